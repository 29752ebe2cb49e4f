// Babylon.js: Path3D(points).getNormals(), which CreateTube and ExtrudeShape use. Its points are those of the table.
//     node babylon.mjs SOURCE TARGET < NAMES
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { join } from 'node:path'
import { Path3D } from '@babylonjs/core/Maths/math.path.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'

const [source, target] = process.argv.slice(2)
const wanted = new Set(readFileSync(0, 'utf8').trim().split('\n').map(name => name + '.csv'))
for (const steps of readdirSync(source)) {
  mkdirSync(join(target, steps), { recursive: true })
  for (const name of readdirSync(join(source, steps)).filter(x => wanted.has(x))) {
    const rows = readFileSync(join(source, steps, name), 'utf8').trim().split('\n').slice(1).map(line => line.split(','))
    const normals = new Path3D(rows.map(row => new Vector3(...row.slice(1, 4).map(Number)))).getNormals()
    const lines = rows.map((row, k) => [row[0], ...normals[k].asArray()].join())
    writeFileSync(join(target, steps, name), ['t,f2x,f2y,f2z', ...lines].join('\n') + '\n')
  }
}
console.log(createRequire(import.meta.url)('@babylonjs/core/package.json').version)
