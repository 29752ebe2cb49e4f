// Frames for all curves of the reference collection by double reflection (Wang, Jüttler, Zheng, Liu 2008), to be judged by
// phrame check --suite. Put your own method in the place of next_normal().
//
//     phrame reference --export collection --samples 51,101,201
//     rustc -O double_reflection.rs
//     ./double_reflection collection/frames mine
//     phrame check --suite mine
use std::{env, fs, io, path::Path, time::Instant};

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a - k b
fn minus(a: Vector, k: f64, b: Vector) -> Vector {
    [a[0] - k * b[0], a[1] - k * b[1], a[2] - k * b[2]]
}

struct Row {
    t: String,
    r: Vector,
    e1: Vector,
    f2: Vector,
}

/// f2 at the next point: reflected in the plane between the points, then so that the tangent becomes that of the next.
fn next_normal(at: &Row, mut f2: Vector, next: &Row) -> Vector {
    let mut e1 = at.e1;
    let way = minus(next.r, 1.0, at.r);
    let c = dot(way, way);
    if c > 0.0 {
        // else it is the same point
        f2 = minus(f2, 2.0 * dot(way, f2) / c, way);
        e1 = minus(e1, 2.0 * dot(way, e1) / c, way);
    }
    let turn = minus(next.e1, 1.0, e1);
    let c = dot(turn, turn);
    if c > 0.0 { minus(f2, 2.0 * dot(turn, f2) / c, turn) } else { f2 }
}

fn rows_of(text: &str) -> Vec<Row> {
    let mut lines = text.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    lines
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            let cell = |name: &str| cells[head.iter().position(|x| *x == name).unwrap()].parse().unwrap();
            let vector = |names: [&str; 3]| names.map(cell);
            Row {
                t: cells[0].to_string(),
                r: vector(["x", "y", "z"]),
                e1: vector(["e1x", "e1y", "e1z"]),
                f2: vector(["f2x", "f2y", "f2z"]),
            }
        })
        .collect()
}

/// The tables below a folder; a line for each in `times`, where the folder is called `prefix`.
fn write_frames(source: &Path, target: &Path, prefix: &str, times: &mut String) -> io::Result<()> {
    fs::create_dir_all(target)?;
    for entry in fs::read_dir(source)? {
        let path = entry?.path();
        let out = target.join(path.file_name().unwrap());
        let name = format!("{}{}", prefix, path.file_stem().unwrap().to_str().unwrap());
        if path.is_dir() {
            write_frames(&path, &out, &format!("{}/", name), times)?;
        } else if path.extension().is_some_and(|end| end == "csv") {
            let rows = rows_of(&fs::read_to_string(&path)?);
            let start = Instant::now();
            let mut normals = vec![rows[0].f2]; // where the exact frame starts
            for k in 1..rows.len() {
                normals.push(next_normal(&rows[k - 1], normals[k - 1], &rows[k]));
            }
            *times += &format!("{},{:.9}\n", name, start.elapsed().as_secs_f64());
            let mut text = String::from("t,f2x,f2y,f2z\n");
            for (row, f2) in rows.iter().zip(normals) {
                text += &format!("{},{},{},{}\n", row.t, f2[0], f2[1], f2[2]);
            }
            fs::write(out, text)?;
        }
    }
    Ok(())
}

fn main() -> io::Result<()> {
    let args: Vec<String> = env::args().collect();
    if args.len() != 3 {
        eprintln!("double_reflection collection/frames mine");
        std::process::exit(2);
    }
    let mut times = String::from("name,seconds\n");
    write_frames(Path::new(&args[1]), Path::new(&args[2]), "", &mut times)?;
    fs::write(Path::new(&args[2]).join("times.csv"), times)
}
