// Frames for all curves of the reference collection by double reflection (Wang, Jüttler, Zheng, Liu 2008), to be judged by
// phrame check --suite. Put your own method in the place of nextNormal().
//
//     phrame reference --export collection --samples 51,101,201
//     node double_reflection.mjs collection/frames mine
//     phrame check --suite mine
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { dirname, join } from 'node:path'

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
const minus = (a, k, b) => a.map((x, i) => x - k * b[i])

/** f2 at the next point: reflected in the plane between the points, then so that the tangent becomes that of the next. */
function nextNormal(at, f2, next) {
  let e1 = at.e1
  const way = minus(next.r, 1, at.r)
  let c = dot(way, way)
  if (c > 0) { // else it is the same point
    f2 = minus(f2, 2 * dot(way, f2) / c, way)
    e1 = minus(e1, 2 * dot(way, e1) / c, way)
  }
  const turn = minus(next.e1, 1, e1)
  c = dot(turn, turn)
  return c > 0 ? minus(f2, 2 * dot(turn, f2) / c, turn) : f2
}

function rowsOf(text) {
  const [head, ...lines] = text.trim().split('\n').map(line => line.split(','))
  return lines.map(cells => {
    const column = name => Number(cells[head.indexOf(name)])
    return { t: cells[0], r: ['x', 'y', 'z'].map(column), e1: ['e1x', 'e1y', 'e1z'].map(column), f2: ['f2x', 'f2y', 'f2z'].map(column) }
  })
}

function main(source, target) {
  let times = 'name,seconds\n'
  for (const name of readdirSync(source, { recursive: true })) {
    if (!name.endsWith('.csv')) continue
    const rows = rowsOf(readFileSync(join(source, name), 'utf8'))
    const start = performance.now()
    const normals = [rows[0].f2] // where the exact frame starts
    for (let k = 1; k < rows.length; k++) normals.push(nextNormal(rows[k - 1], normals[k - 1], rows[k]))
    const milliseconds = performance.now() - start
    times += name.slice(0, -4).replaceAll('\\', '/') + ',' + milliseconds / 1000 + '\n'
    mkdirSync(dirname(join(target, name)), { recursive: true })
    writeFileSync(join(target, name), 't,f2x,f2y,f2z\n' + rows.map((row, k) => [row.t, ...normals[k]].join() + '\n').join(''))
  }
  writeFileSync(join(target, 'times.csv'), times)
}

if (process.argv.length !== 4) throw new Error('node double_reflection.mjs collection/frames mine')
main(process.argv[2], process.argv[3])
