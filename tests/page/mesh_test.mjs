// node mesh_test.mjs PROGRAM CURVES: bodies of phrame sweep as three.js loads them, and as Khronos's validator finds
// them. What a loader makes is a list of triangles: each side must have its opposite, with the points of a file equal
// bit by bit, and the pyramids over the triangles the volume that is known. Camera paths of phrame frames likewise.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import validator from 'gltf-validator';
import { AnimationMixer, Quaternion, Vector3 } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';

const [program, curves] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'phrame-mesh-'));

// A loader's warnings are failures.
for (const word of ['warn', 'error'])
  console[word] = (...words) => {
    throw new Error(`a loader complains: ${words.join(' ')}`);
  };

globalThis.ProgressEvent ??= Event; // three.js tells of what it loads by one

const bytesOf = (bytes) => bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
const onlyChild = (group) => {
  assert.equal(group.children.length, 1);
  return group.children[0].geometry;
};

/** The geometry that three.js has of a file's bytes. */
const loaders = {
  obj: (bytes) => onlyChild(new OBJLoader().parse(bytes.toString('utf8'))),
  stl: (bytes) => new STLLoader().parse(bytesOf(bytes)),
  ply: (bytes) => new PLYLoader().parse(bytesOf(bytes)),
  glb: async (bytes) => onlyChild((await new GLTFLoader().parseAsync(bytesOf(bytes), '')).scene),
};

/** The triangles, as three points each. */
function triangles(geometry) {
  const places = geometry.getAttribute('position');
  const index = geometry.getIndex();
  const count = index ? index.count : places.count;
  assert.equal(count % 3, 0);
  const points = Array.from({ length: count }, (_, k) => {
    const at = index ? index.getX(k) : k;
    return [places.getX(at), places.getY(at), places.getZ(at)];
  });
  return Array.from({ length: count / 3 }, (_, k) => points.slice(3 * k, 3 * k + 3));
}

const minus = (a, b) => a.map((x, k) => x - b[k]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);

/** Its volume, once each side is seen to lie opposite to one other. */
function volumeOf(body) {
  const sides = new Map();
  for (const corners of body)
    corners.forEach((from, k) => {
      const side = `${from}|${corners[(k + 1) % 3]}`;
      assert.ok(!sides.has(side), `the side ${side} is there twice`);
      sides.set(side, `${corners[(k + 1) % 3]}|${from}`);
    });
  for (const opposite of sides.values()) assert.ok(sides.has(opposite), `nothing is opposite to ${opposite}`);
  const apex = body[0][0];
  return body.reduce((sum, [a, b, c]) => sum + dot(minus(a, apex), cross(minus(b, apex), minus(c, apex))), 0) / 6;
}

/** ∫ f·|A|², of the spline's file with Bernstein coefficients, by Simpson's rule, exact to degree 3 in each of 200 parts. */
function lengthOf(file) {
  const number = (x) => (typeof x === 'string' ? x.split('/').reduce((a, b) => a / b) : x);
  const blend = (list, t) => (list.length === 1 ? list[0] : (1 - t) * blend(list.slice(0, -1), t) + t * blend(list.slice(1), t));
  let sum = 0;
  for (const { quaternions, multiplier = [1] } of JSON.parse(readFileSync(file, 'utf8')).segments) {
    const speed = (t) =>
      blend(multiplier.map(number), t) *
      [0, 1, 2, 3].reduce((square, k) => square + blend(quaternions.map((a) => number(a[k])), t) ** 2, 0);
    for (let k = 0; k < 200; ++k)
      sum += (speed(k / 200) + 4 * speed((k + 0.5) / 200) + speed((k + 1) / 200)) / 1200;
  }
  return sum;
}

const line = join(folder, 'line.json');
writeFileSync(line, '{"phrame": "curve/1", "basis": "power", "preimage": {"u": [2], "v": [0], "p": [0], "q": [1]}}');
const ring = join(folder, 'ring.csv');
const angles = Array.from({ length: 12 }, (_, k) => (k * Math.PI) / 6);
writeFileSync(ring, angles.map((angle) => `${Math.cos(angle)},${Math.sin(angle)},0\n`).join(''));
const torus = join(folder, 'torus.json');
const closed = join(curves, 'curves', 'closed-spline.json');
execFileSync(program, ['construct', ring, '--closed', '-o', torus]);

// The volume, and what it may be off: of a prism in floats what rounding moves its faces by; of a tube the tolerance
// times its surface [Pappus]. 12 quintics are as long as the circle through their joints to 10⁻³.
const tube = (curve, length, radius, tolerance) => ({
  curve,
  options: ['--profile', `circle:${radius}`, '--tolerance', `${tolerance}`],
  volume: Math.PI * radius ** 2 * length,
  within: 1.01 * tolerance * 2 * Math.PI * radius * length,
});
const bodies = {
  'a prism': { curve: line, options: ['--profile', 'rectangle:2,3', '--sections', '2'], volume: 30, within: 1e-5 },
  'a torus': tube(torus, 2 * Math.PI, 1 / 4, 1 / 500),
  'a tube around a closed spline': tube(closed, lengthOf(closed), 1 / 8, 1 / 250),
};

let failures = 0;
let count = 0;
for (const [name, { curve, options, volume, within }] of Object.entries(bodies))
  for (const [format, load] of Object.entries(loaders)) {
    ++count;
    try {
      const file = join(folder, `body.${format}`);
      const said = execFileSync(program, ['sweep', curve, ...options, '-o', file], { encoding: 'utf8' });
      const bytes = readFileSync(file);
      const body = triangles(await load(bytes));
      assert.equal(body.length, Number(/(\d+) triangles/.exec(said)[1]));
      const found = volumeOf(body);
      assert.ok(Math.abs(found - volume) <= within, `the volume is ${found}, not ${volume}`);
      if (format === 'glb') {
        const { issues } = await validator.validateBytes(new Uint8Array(bytes));
        assert.equal(issues.messages.length, 0, JSON.stringify(issues.messages));
      }
      console.log(`ok      ${name}, ${format}`);
    } catch (error) {
      ++failures;
      console.log(`FAILED  ${name}, ${format}\n${error.stack}`);
    }
  }

// Far from 0 a node has the place, in doubles, and floats are from there.
const quintic = JSON.parse(readFileSync(join(curves, 'curves', 'farouki-2003-quintic.json'), 'utf8'));
const far = join(folder, 'far.json');
writeFileSync(far, JSON.stringify({ ...quintic, start: [1e9, -1e9, 0] }));
++count;
try {
  const near = ['--profile', 'circle:1/10', '--tolerance', '1/100', '-o', join(folder, 'far.glb')];
  execFileSync(program, ['sweep', far, ...near]);
  const bytes = readFileSync(join(folder, 'far.glb'));
  const { scene } = await new GLTFLoader().parseAsync(bytesOf(bytes), '');
  assert.deepEqual(scene.children[0].position.toArray(), [1e9, -1e9, 0]);
  const found = volumeOf(triangles(onlyChild(scene)));
  const exact = (Math.PI / 100) * (71 / 15); // Pappus; the curve's length is of [Farouki 2003]
  assert.ok(Math.abs(found - exact) < (2.02 * Math.PI * (71 / 15)) / 10 / 100, `the volume is ${found}, not ${exact}`);
  const { issues } = await validator.validateBytes(new Uint8Array(bytes));
  assert.equal(issues.messages.length, 0, JSON.stringify(issues.messages));
  console.log('ok      a tube far from 0, glb');
} catch (error) {
  ++failures;
  console.log(`FAILED  a tube far from 0, glb\n${error.stack}`);
}

// What three.js plays, at the times of the keys, is where a point of the table lies, and it looks along e1.
for (const [format, curve] of [
  ['glb', closed],
  ['gltf', closed],
  ['glb', far],
]) {
  ++count;
  try {
    const file = join(folder, `camera.${format}`);
    const table = ['frames', curve, '--samples', '9'];
    const rows = execFileSync(program, table, { encoding: 'utf8' }).trim().split('\n').slice(1);
    execFileSync(program, [...table, '-o', file]);
    const bytes = readFileSync(file);
    const { issues } = await validator.validateBytes(new Uint8Array(bytes));
    assert.equal(issues.messages.length, 0, JSON.stringify(issues.messages));
    const { scene, cameras, animations } = await new GLTFLoader().parseAsync(bytesOf(bytes), '');
    assert.equal(cameras.length, 1);
    const mixer = new AnimationMixer(scene);
    mixer.clipAction(animations[0]).play();
    for (const row of rows.slice(0, -1)) {
      const [t, x, y, z, ex, ey, ez, ux, uy, uz] = row.split(',').map(Number);
      mixer.setTime(t);
      scene.updateMatrixWorld();
      const camera = cameras[0];
      const off = (a, b) => Math.hypot(...minus(a.toArray(), b));
      assert.ok(off(camera.getWorldPosition(new Vector3()), [x, y, z]) < 1e-5, `at ${t}`); // at 1e9 a double is 1e-7 from the next
      assert.ok(off(camera.getWorldDirection(new Vector3()), [ex, ey, ez]) < 1e-6, `towards, at ${t}`);
      const up = new Vector3(0, 1, 0).applyQuaternion(camera.getWorldQuaternion(new Quaternion()));
      assert.ok(off(up, [ux, uy, uz]) < 1e-6, `up, at ${t}`);
    }
    console.log(`ok      a camera path, ${format}${curve === far ? ', far from 0' : ''}`);
  } catch (error) {
    ++failures;
    console.log(`FAILED  a camera path, ${format}\n${error.stack}`);
  }
}
rmSync(folder, { recursive: true });
console.log(`meshes: ${count - failures} of ${count} tests passed`);
process.exitCode = failures === 0 ? 0 : 1;
