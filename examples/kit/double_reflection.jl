# Frames for all curves of the reference collection by double reflection (Wang, Jüttler, Zheng, Liu 2008), to be judged by
# phrame check --suite. Put your own method in the place of next_normal().
#
#     phrame reference --export collection --samples 51,101,201
#     julia double_reflection.jl collection/frames mine
#     phrame check --suite mine

dot(a, b) = sum(a .* b)

"f2 at the next point: reflected in the plane between the points, then so that the tangent becomes that of the next."
function next_normal(at, f2, next)
    e1 = at.e1
    way = next.r - at.r
    c = dot(way, way)
    if c > 0  # else it is the same point
        f2 = f2 - 2 * dot(way, f2) / c * way
        e1 = e1 - 2 * dot(way, e1) / c * way
    end
    turn = next.e1 - e1
    c = dot(turn, turn)
    return c > 0 ? f2 - 2 * dot(turn, f2) / c * turn : f2
end

function rows_of(file)
    head, lines... = [split(line, ',') for line in readlines(file)]
    return map(lines) do cells
        row = Dict(zip(head, cells))
        vector(names...) = [parse(Float64, row[name]) for name in names]
        (t = row["t"], r = vector("x", "y", "z"), e1 = vector("e1x", "e1y", "e1z"), f2 = vector("f2x", "f2y", "f2z"))
    end
end

function normals_of(rows)
    normals = [rows[1].f2]  # where the exact frame starts
    for k in 2:length(rows)
        push!(normals, next_normal(rows[k - 1], normals[k - 1], rows[k]))
    end
    return normals
end

function main(source, target)
    times = ["name,seconds"]
    for (folder, _, files) in walkdir(source), file in filter(endswith(".csv"), files)
        rows = rows_of(joinpath(folder, file))
        name = relpath(joinpath(folder, file), source)
        length(times) == 1 && normals_of(rows)  # the first call compiles it, and is not timed
        start = time_ns()
        normals = normals_of(rows)
        seconds = (time_ns() - start) / 1e9
        push!(times, replace(first(splitext(name)), '\\' => '/') * ",$seconds")
        mkpath(dirname(joinpath(target, name)))
        open(joinpath(target, name), "w") do out
            println(out, "t,f2x,f2y,f2z")
            for (row, f2) in zip(rows, normals)
                println(out, join([row.t; f2], ','))
            end
        end
    end
    write(joinpath(target, "times.csv"), join(times, '\n') * "\n")
end

length(ARGS) == 2 || error("julia double_reflection.jl collection/frames mine")
main(ARGS...)
