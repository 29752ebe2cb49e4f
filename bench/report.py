"""Whole programs: what they take, beside what cannot be avoided or what does the same, and how it grows.

`./dev bench --report` runs it with the program that it has built, in about four minutes, and prints three tables in Markdown, which are in
docs/performance.md. CPU time, user and system, of whole processes, the least of several runs; both columns of a row are measured in turn.
A neighbour that is not installed (NumPy, python-flint) has no figure. The last table has what was aimed at, by the same program, by
Google Benchmark and by the Python package, where these are built. The exit status is 1 where something grows faster than it should.
"""
import argparse
import json
import math
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time

import peers

try:
    import flint
    import numpy
except ImportError:
    flint = numpy = None

KNOT = pathlib.Path(__file__).resolve().parents[1] / "examples" / "any" / "trefoil.json"


def curve(preimage, **more):
    return {"phrame": "curve/1", "basis": "power", "preimage": dict(zip("uvpq", preimage)), **more}


def random_curve(m):
    return curve(peers.preimage(m))


def composed(outer, inner):
    """The polynomials of `outer` at `inner`, by Horner's rule."""
    def at(a):
        value = [0]
        for c in reversed(a):
            value = peers.product(value, inner)
            value[0] += c
        return value
    return curve([at(a) for a in outer])


def chebyshev(k):
    """T_k(2t - 1)."""
    below, this = [1], [-1, 2]
    for _ in range(k - 1):
        twice = peers.product(this, [-2, 4])
        below, this = this, [x - y for x, y in zip(twice, below + [0] * len(twice))]
    return this


def symmetric(m):
    """As t -> 1 - t turns it over: its polynomials are those of t(1 - t)."""
    return composed(peers.preimage(m // 2), [0, 1, -1])


def long_numbers(digits):
    rng = random.Random(digits)
    return curve([[rng.randrange(-10 ** digits, 10 ** digits) for _ in range(4)] for _ in range(4)])


def clustered(k):
    """Poles in clusters of k, 10^-3 wide, about i and -i."""
    a = [1]
    for n in range(k):
        a = peers.product(a, [n, 1000])
    return curve([a, [0], [1000 ** k], [0]])


def near_cusp(k):
    return curve([[-1, 2], [f"1e-{k}"], [0, f"1e-{k}"], [1, -2, 1]])


def points(n, digits=16):
    """A table of points on a winding line."""
    rows = ([math.cos(k / 3) * (3 + k % 7), math.sin(k / 3) * (3 + k % 5), k / 4] for k in range(n))
    return "x,y,z\n" + "".join(",".join(f"{x:.{digits}g}" for x in row) + "\n" for row in rows)


def coil(n):
    return "x,y,z\n" + "".join(f"{math.cos(0.3 * k)!r},{math.sin(0.3 * k)!r},{0.03 * k!r}\n" for k in range(n))


def svg_path(n):
    """Lines and curves of both degrees with a corner at nearly every joint."""
    rng = random.Random(n)
    x = y = 0
    d = "M0 0"
    for k in range(n):
        to, up = x + rng.randint(5, 9), y + rng.randint(-9, 9)
        d += (f"L{to} {up}", f"Q{x + 2} {y + rng.randint(-5, 5)} {to} {up}",
              f"C{x + 1.5} {y + rng.randint(-5, 5)} {to - 2} {up + rng.randint(-5, 5) / 4} {to} {up}")[k % 3]
        x, y = to, up
    return f'<svg xmlns="http://www.w3.org/2000/svg"><path d="{d}"/></svg>'


def least(ask, times):
    return min(ask() for _ in range(times))


# The greatest memory of a process is at least that of the one that starts it: this one is small.
RUN = """
import os, sys
_, status, usage = os.wait4(os.posix_spawn(sys.argv[1], sys.argv[1:], os.environ), 0)
print(os.waitstatus_to_exitcode(status), usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, file=sys.stderr)
"""


class Program:
    def __init__(self, path, folder):
        self.path, self.folder, self.start = path, pathlib.Path(folder), 0.0

    def file(self, name, content):
        path = self.folder / name
        path.write_text(content if isinstance(content, str) else json.dumps(content))
        return path

    def run(self, *arguments):
        """CPU seconds and the greatest memory in MB. A run that fails ends the report."""
        command = [self.path, *map(str, arguments)]
        with open(self.folder / "out", "wb") as out:
            ran = subprocess.run([sys.executable, "-S", "-E", "-c", RUN, *command], stdout=out, stderr=subprocess.PIPE, text=True)
        *said, status = ran.stderr.splitlines()
        exit_status, seconds, memory = map(float, status.split())
        if exit_status:
            sys.exit(f"report: {' '.join(command)}: {' '.join(said)[-300:]}")
        return seconds, memory

    def seconds(self, *arguments):
        """The least of as many runs as a second takes, but five."""
        found = [self.run(*arguments)[0]]
        while len(found) < 5 and sum(found) < 1:
            found.append(self.run(*arguments)[0])
        return min(found)


def libraries(program):
    """To load the shared libraries of the program, by a program that does nothing."""
    listed = subprocess.run(["ldd", program.path], capture_output=True, text=True, check=True).stdout
    paths = re.findall(r"=> (/\S+)", listed)
    before = peers.spent()
    for _ in range(20):
        subprocess.run(["/bin/true"], env={"LD_PRELOAD": " ".join(paths)}, check=True)
    return (peers.spent() - before) / 20


def by_savetxt(rows):
    table = numpy.random.default_rng(1).random((rows // 10, 13))
    before = time.process_time()
    numpy.savetxt(os.devnull, table, delimiter=",")
    return 10 * (time.process_time() - before)


def by_roots(preimages):
    """θ(1) of these quintics to 17 digits: roots of σ, residues and logarithms of python-flint."""
    before = time.process_time()
    flint.ctx.prec = 96
    for u, v, p, q in (map(flint.fmpz_poly, a) for a in preimages):
        h = u * v.derivative() - u.derivative() * v - p * q.derivative() + p.derivative() * q
        sigma = u * u + v * v + p * p + q * q
        slope = sigma.derivative()
        sum(2 * (-2 * h(z) / slope(z) * ((1 - z).log() - (-z).log())).real for z, _ in sigma.complex_roots() if z.imag > 0)
    return time.process_time() - before


def by_quadrature():
    """The angle of the knot from the frame of the up vector k, −∫ (r′·k) det(k, r′, r″)/(|r′||k × r′|²), by python-flint to 50 digits."""
    flint.ctx.prec = 190

    def rate(s, _):
        jet = flint.acb_series([s, 1], 3)
        c, w, a, b = (3 * jet).cos(), 2 + (3 * jet).cos(), (2 * jet).cos(), (2 * jet).sin()
        first = [list((w * f).derivative()) + [0, 0] for f in (a, b)] + [list((3 * jet).sin().derivative()) + [0, 0]]
        (x, dx), (y, dy), (z, _dz) = (f[:2] for f in first)
        flat = x * x + y * y
        return -z * (x * dy - y * dx) / ((flat + z * z).sqrt() * flat)

    before = time.process_time()
    flint.acb.integral(rate, 0, 2 * flint.arb.pi())
    return time.process_time() - before


def beside(program):
    """Rows of the first table: what, a call, its neighbour, a call or a function of no arguments that returns seconds."""
    quintic = program.file("quintic.json", random_curve(2))
    rng = random.Random(2003)

    def lines(name, m, count):
        preimages = [[[rng.randint(-9, 9) for _ in range(m + 1)] for _ in range(4)] for _ in range(count)]
        return preimages, program.file(name, "".join(json.dumps({"at": 1, "curve": curve(a)}) + "\n" for a in preimages))

    quintics, batch = lines("batch.jsonl", 2, 3000)
    degree21, batch21 = lines("batch21.jsonl", 10, 1000)
    m81 = program.file("m40.json", random_curve(40))
    table = points(10_000)
    spline = program.file("spline.csv", table)
    thousand = program.file("thousand.csv", points(1000))
    coiled = program.file("coil.csv", coil(400))
    ph = program.folder / "ph.json"
    program.run("construct", thousand, "-o", ph)
    corners = program.file("corners.svg", svg_path(10_000))
    frames = program.folder / "frames.csv"
    program.run("frames", quintic, "--samples", 100_001, "-o", frames)
    noisy = program.folder / "noisy.csv"  # to six decimals
    noisy.write_text("".join(line if line[0] == "t" else ",".join(f"{float(x):.6f}" for x in line.split(",")) + "\n" for line in open(frames)))
    quartic = program.file("quartic.json", {"phrame": "curve/1", "control_points": [[0, 0, 0], [1, 2, 0], [3, 1, 1], [2, -1, 2], [4, 0, 1]]})

    def forms(m):
        path = program.file(f"form{m}.json", random_curve(m))
        return ("angle", path, "--form", "rothstein-trager"), ("angle", path)

    by_t = ("frames", quintic, "--samples", 100_001)
    rows = [
        ("start", ("--version",), "to load its libraries", lambda: libraries(program)),
        ("`frames`, 10⁶ rows as CSV", ("frames", quintic, "--samples", 1_000_001), "`numpy.savetxt` of as many numbers", numpy and (lambda: by_savetxt(1_000_001))),
        ("`frames --by arc-length`, 10⁵ rows", (*by_t, "--by", "arc-length"), "the same by t", by_t),
        ("`frames --frame frenet --by arc-length`, 11 rows, degree 81", ("frames", m81, "--samples", 11, "--frame", "frenet", "--by", "arc-length"),
         "`frames --by arc-length`", ("frames", m81, "--samples", 11, "--by", "arc-length")),
        ("`check` of 10⁵ rows", ("check", quintic, frames), "`frames` writes them", by_t),
        ("the same, to six decimals", ("check", quintic, noisy, "--tol", "1e-5"), "`frames` writes them", by_t),
        ("`frames` of a knot by formulas, 10⁵ rows", ("frames", KNOT, "--samples", 100_001), "of a quintic", by_t),
        ("`frames` of 11 rows, symmetric, degree 61", ("frames", program.file("s60.json", symmetric(30)), "--samples", 11), "a random curve",
         ("frames", program.file("r60.json", random_curve(30)), "--samples", 11)),
        ("θ in closed form, m = 80, composed with a quadratic", ("angle", program.file("c80.json", composed(peers.preimage(40), [3, -2, 1]))),
         "a random curve", ("angle", program.file("r80.json", random_curve(80)))),
        ("`--form rothstein-trager`, m = 20", forms(20)[0], "the default form", forms(20)[1]),
        ("m = 40", forms(40)[0], "the default form", forms(40)[1]),
        ("`batch --values-only`, 3000 quintics", ("batch", "--values-only", batch), "python-flint: roots, residues, logarithms", flint and (lambda: by_roots(quintics))),
        ("the same with closed forms", ("batch", batch), "values only", ("batch", "--values-only", batch)),
        ("`batch --values-only`, 1000 curves of degree 21", ("batch", "--values-only", batch21), "python-flint", flint and (lambda: by_roots(degree21))),
        ("the same with closed forms", ("batch", batch21), "values only", ("batch", "--values-only", batch21)),
        ("θ of the knot to 50 digits", ("angle", KNOT, "--at", 1, "--digits", 50, "--start", "up"), "python-flint's `acb.integral`", flint and by_quadrature),
        ("5000 digits of a quartic Bézier's angle", ("angle", quartic, "--at", 1, "--digits", 5000), "1000 digits", ("angle", quartic, "--at", 1, "--digits", 1000)),
        ("`angle` of a C² spline, 10⁴ points", ("angle", spline, "--at", 1), "`info`", ("info", spline)),
        ("`totals` of 999 PH quintics", ("totals", ph), "`angle`", ("angle", ph, "--at", 1)),
        ("`frames`, 10⁵ rows along them", ("frames", ph, "--samples", 100_001), "along one quintic", by_t),
        ("`frames --frame frenet`, 10⁴ rows along them", ("frames", ph, "--samples", 10_001, "--frame", "frenet"), "`frames`", ("frames", ph, "--samples", 10_001)),
        ("`info` of an SVG path with corners, 10⁴ commands", ("info", corners), "`angle`", ("angle", corners, "--at", 1)),
        ("`construct` through 1000 points", ("construct", thousand), "`angle` of that", ("angle", ph, "--at", 1)),
        ("`construct --kind rrmf`, 400 points of a coil", ("construct", coiled, "--kind", "rrmf"), "`--kind rmf`", ("construct", coiled, "--kind", "rmf")),
        ("`compile` of the knot", ("compile", KNOT), "`angle`", ("angle", KNOT, "--at", 1)),
        ("`page` of degree 81", ("page", m81), "`angle`", ("angle", m81, "--at", 1)),
    ]
    print("| | CPU seconds | MB | beside it | CPU seconds | ratio |\n|---|---|---|---|---|---|")
    for what, call, neighbour, other in rows:
        memory = program.run(*call)[1]
        mine = program.seconds(*call)
        theirs = None if other is None else program.seconds(*other) if isinstance(other, tuple) else least(other, 3)
        print(f"| {what} | {shown(mine)} | {memory:.0f} | {neighbour} | {shown(theirs)} | {'' if theirs is None else format(mine / theirs, '.2g')} |", flush=True)


def shown(seconds):
    return "" if seconds is None else f"{seconds:.2g}" if seconds < 10 else f"{seconds:.0f}"


def growth(program):
    """The second table: seconds at sizes n, without the start, and the exponent of each step from 2 ms on; marked where it is more
    than 3.5, or by more than 1 greater than that of the step before.
    """
    random_points = {n: program.file(f"p{n}.csv", points(n)) for n in (1000, 4000, 16000)}

    def angles(name, make):
        return lambda n: ("angle", program.file(f"{name}{n}.json", make(n)), "--at", 1, "--digits", 50)

    coils = {n: program.file(f"coil{n}.csv", coil(n)) for n in (100, 400, 1600)}
    quintic = program.file("quintic.json", random_curve(2))
    families = [
        ("random curves, m", (20, 40, 80, 160), angles("r", random_curve)),
        ("symmetric, m", (20, 40, 80, 160), angles("s", symmetric)),
        ("m = 2 composed with T_k, k", (5, 10, 20), angles("t", lambda k: composed(peers.preimage(2), chebyshev(k)))),
        ("poles in clusters of k, k", (10, 20, 40), angles("c", clustered)),
        ("near-cusps 10^−k, k", (30, 100, 300, 1000), angles("n", near_cusp)),
        ("coefficients of k digits, k", (30, 100, 300, 1000), angles("l", long_numbers)),
        ("f = T_k of Chebyshev, k", (20, 40, 80), angles("f", lambda k: curve(peers.preimage(5), multiplier=chebyshev(k)))),
        ("digits of a quintic's angle", (1000, 4000, 16000), lambda n: ("angle", quintic, "--at", 1, "--digits", n)),
        ("rows of `frames`", (100_001, 400_001, 1_600_001), lambda n: ("frames", quintic, "--samples", n)),
        ("points of a C² spline, `angle`", (1000, 4000, 16000), lambda n: ("angle", random_points[n], "--at", 1)),
        ("points of a C² spline, `info`", (1000, 4000, 16000), lambda n: ("info", random_points[n])),
        ("points of a coil, `construct --kind rrmf`", (100, 400, 1600), lambda n: ("construct", coils[n], "--kind", "rrmf")),
        ("points of a coil, `construct --kind rmf`", (100, 400, 1600), lambda n: ("construct", coils[n], "--kind", "rmf")),
    ]
    print("| | n | CPU seconds | n^… |\n|---|---|---|---|")
    marked = 0
    for what, sizes, call in families:
        times = [max(program.seconds(*call(n)) - program.start, 1e-4) for n in sizes]
        steps = [math.log(b / a) / math.log(n / m) if a >= 0.002 else None for a, b, m, n in zip(times, times[1:], sizes, sizes[1:])]
        steep = [s is not None and (s > 3.5 or (k > 0 and s > (steps[k - 1] or 2.5) + 1)) for k, s in enumerate(steps)]
        marked += sum(steep)
        exponents = ", ".join("–" if s is None else f"**{s:.1f}**" if bad else f"{s:.1f}" for s, bad in zip(steps, steep))
        print(f"| {what} | {', '.join(map(str, sizes))} | {', '.join(map(shown, times))} | {exponents} |", flush=True)
    return marked


def benchmarks(program, *names):
    """CPU seconds of some benchmarks by name, for one item where they count items; none where they are not built."""
    binary = pathlib.Path(program.path).parents[1] / "bench" / "phrame_bench"
    if not binary.exists():
        return {}
    out = program.folder / "benchmarks.json"
    subprocess.run([binary, f"--benchmark_filter=^({'|'.join(names)})$", f"--benchmark_out={out}", "--benchmark_out_format=json"],
                   capture_output=True, check=True)
    found = {}
    for run in json.loads(out.read_text())["benchmarks"]:
        if run.get("run_type") == "iteration":
            unit = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}[run["time_unit"]]
            seconds = 1 / run["items_per_second"] if "items_per_second" in run else run["cpu_time"] * unit
            found[run["run_name"]] = min(seconds, found.get(run["run_name"], math.inf))
    return found


def by_python():
    """Seconds for the first frame of a quintic, the first 10 and the first 100; none without the package."""
    try:
        import python_speed
    except ImportError:
        return {}
    return {n: python_speed.few_frames(n)[0] * 1e-6 for n in (1, 10, 100)}


def in_units(seconds):
    if not seconds:
        return "0"
    for unit, size in (("s", 1), ("ms", 1e-3), ("µs", 1e-6), ("ns", 1e-9)):
        if seconds >= 0.995 * size or unit == "ns":
            return f"{seconds / size:.2g} {unit}" if seconds < 99.5 * size else f"{seconds / size:.0f} {unit}"


def aims(program):
    """The third table: seconds now, seconds aimed at, and their ratio; of the files that beside() has written, too."""
    def seconds(*arguments):
        return program.seconds(*arguments)

    def rate(arguments, count):
        return (seconds(*arguments) - program.start) / count

    quintics = [program.folder / name for name in ("batch.jsonl", "batch21.jsonl")]
    thousand, ten_thousand = program.folder / "thousand.csv", program.folder / "spline.csv"
    ph, quintic = program.folder / "ph.json", program.folder / "quintic.json"
    coiled, m81 = program.folder / "coil.csv", program.folder / "m40.json"
    rows = program.folder / "million.csv"
    program.run("frames", quintic, "--samples", 1_000_001, "-o", rows)
    rrmf = program.folder / "rrmf.json"
    program.run("construct", coiled, "--kind", "rrmf", "-o", rrmf)
    table = [
        ("start", program.start, 0.002),
        ("`--form rothstein-trager`, m = 20", seconds("angle", program.folder / "form20.json", "--form", "rothstein-trager"), 0.06),
        ("m = 40", seconds("angle", program.folder / "form40.json", "--form", "rothstein-trager"), 0.5),
        ("θ in closed form, m = 80, composed with a quadratic", seconds("angle", program.folder / "c80.json"), 0.5),
        ("`frames` of the knot, 10⁵ rows, beside `compile`",
         max(seconds("frames", KNOT, "--samples", 100_001) - seconds("compile", KNOT), 0), 0.3),
        ("`compile` of the knot", seconds("compile", KNOT), 1),
        ("`page` of the knot", seconds("page", KNOT), 1),
        ("`sweep` of the knot", seconds("sweep", KNOT, "--profile", "circle:0.2", "-o", program.folder / "knot.glb"), 1),
        ("`check` of 10⁶ rows", seconds("check", quintic, rows), 10),
        ("`frames`, 10⁶ rows as CSV", seconds("frames", quintic, "--samples", 1_000_001), 0.8),
        ("`batch --values-only`, a quintic", rate(("batch", "--values-only", quintics[0]), 3000), 1 / 35_000),
        ("with its closed form", rate(("batch", quintics[0]), 3000), 1 / 15_000),
        ("a curve of degree 21 with its closed form", rate(("batch", quintics[1]), 1000), 1 / 5000),
        ("`angle` of a C² spline, 10³ points", seconds("angle", thousand, "--at", 1), 0.05),
        ("10⁴ points", seconds("angle", ten_thousand, "--at", 1), 0.5),
        ("`info` of 999 PH quintics", seconds("info", ph), 0.3),
        ("`totals` of 999 PH quintics", seconds("totals", ph), 1),
        ("`construct --kind rrmf`, 400 points", seconds("construct", coiled, "--kind", "rrmf"), 0.5),
        ("`construct --kind rmf`, 1000 points", seconds("construct", thousand, "--kind", "rmf"), 0.3),
        ("`frames`, 1001 rows along 399 RRMF segments", seconds("frames", rrmf, "--samples", 1001), 0.5),
        ("10⁵ rows along 999 PH quintics", seconds("frames", ph, "--samples", 100_001), 1.5),
        ("5000 digits of a quartic Bézier's angle", seconds("angle", program.folder / "quartic.json", "--at", 1, "--digits", 5000), 3),
        ("`page` of degree 81", seconds("page", m81), 3),
    ]
    found = benchmarks(program, "frenet_energy/20", "erf_symbolic/[12]", "erf_flint/[12]", "compiled_(angle|frame)_array/m:2/ascending:0",
                       "header_(angle|frame)_array/m:2/ascending:1")
    if found:
        table += [
            ("`frenet_energy`, m = 20", found["frenet_energy/20"], 0.015),
            ("symbolic stage, m = 1, beside 3 times FLINT's part", found["erf_symbolic/1"], 3 * found["erf_flint/1"]),
            ("m = 2, beside 1.5 times", found["erf_symbolic/2"], 1.5 * found["erf_flint/2"]),
            ("θ by `CompiledAngle`, an array", found["compiled_angle_array/m:2/ascending:0"], 6e-9),
            ("frames by `CompiledFrames`, an array", found["compiled_frame_array/m:2/ascending:0"], 25e-9),
            ("θ by a compiled header, an ascending array", found["header_angle_array/m:2/ascending:1"], 1.5e-9),
            ("frames by a compiled header, an ascending array", found["header_frame_array/m:2/ascending:1"], 6e-9),
        ]
    table += [(f"first {n} frames in Python" if n > 1 else "first frame in Python", s, aim * 1e-6)
              for (n, s), aim in zip(by_python().items(), (10, 20, 40))]
    print("| | now | aim | ratio |\n|---|---|---|---|")
    for what, now, aim in table:
        print(f"| {what} | {in_units(now)} | {in_units(aim)} | {now / aim:.2g} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description="whole programs beside what cannot be avoided, and how they grow: tables in Markdown")
    parser.error = lambda message: parser.exit(2, f"{parser.prog}: {message}\n")
    parser.add_argument("program", metavar="PROGRAM", help="phrame")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        program = Program(os.path.abspath(arguments.program), folder)
        program.start = program.seconds("--version")
        beside(program)
        print()
        marked = growth(program)
        print()
        aims(program)
    if marked:
        sys.exit(f"report: {marked} steps grow faster than those before them")


if __name__ == "__main__":
    main()
