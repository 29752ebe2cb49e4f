// three.js: Curve.computeFrenetFrames(), which TubeGeometry and ExtrudeGeometry use. Its getTangentAt() are the tangents of the table.
//     node three.mjs SOURCE TARGET < NAMES
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { Curve, REVISION, Vector3 } from 'three'

class Sampled extends Curve {
  constructor(tangents) {
    super()
    this.sampledTangents = tangents
  }

  getTangentAt(u, target = new Vector3()) {
    return target.fromArray(this.sampledTangents[Math.round(u * (this.sampledTangents.length - 1))])
  }
}

const [source, target] = process.argv.slice(2)
const wanted = new Set(readFileSync(0, 'utf8').trim().split('\n').map(name => name + '.csv'))
for (const steps of readdirSync(source)) {
  mkdirSync(join(target, steps), { recursive: true })
  for (const name of readdirSync(join(source, steps)).filter(x => wanted.has(x))) {
    const rows = readFileSync(join(source, steps, name), 'utf8').trim().split('\n').slice(1).map(line => line.split(','))
    const { normals } = new Sampled(rows.map(row => row.slice(4, 7).map(Number))).computeFrenetFrames(rows.length - 1, false)
    const lines = rows.map((row, k) => [row[0], ...normals[k].toArray()].join())
    writeFileSync(join(target, steps, name), ['t,f2x,f2y,f2z', ...lines].join('\n') + '\n')
  }
}
console.log('0.' + REVISION + '.0')
