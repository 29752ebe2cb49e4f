// Writes three.json: curves as three.js r160 writes them by toJSON(), and points of them.
import * as THREE from 'three';
import {NURBSCurve} from 'three/examples/jsm/curves/NURBSCurve.js';
import {writeFileSync} from 'fs';
const v = (...x) => new THREE.Vector3(...x);
const w = (...x) => new THREE.Vector2(...x);
const points = [v(-10, 0, 10), v(-5, 5, 5), v(0, 0, 0), v(5, -5.5, 5.25), v(10, 0, 10.1)];
const path = new THREE.CurvePath();
path.add(new THREE.LineCurve3(v(0, 0, 0), v(2, 0, 0)));
path.add(new THREE.CubicBezierCurve3(v(2, 0, 0), v(3, 0, 0), v(4, 1, 0.5), v(4, 2, 1)));
path.add(new THREE.QuadraticBezierCurve3(v(4, 2, 1), v(4, 3, 1.5), v(5, 3, 3)));
const curves = {
  centripetal: [new THREE.CatmullRomCurve3(points), 4],
  chordal: [new THREE.CatmullRomCurve3(points, false, 'chordal'), 4],
  uniform: [new THREE.CatmullRomCurve3(points, false, 'catmullrom', 0.25), 4],
  closed: [new THREE.CatmullRomCurve3(points, true), 5],
  spline: [new THREE.SplineCurve([w(-10, 0), w(-5, 5), w(0, 0), w(5, -5)]), 3],
  cubic: [new THREE.CubicBezierCurve(w(0, 0), w(1, 0), w(2, 1.5), w(2, 2.25)), 1],
  path: [path, 3],
};
const list = [];
for (const [name, [curve, segments]] of Object.entries(curves)) {
  const at = [];
  for (let k = 0; k < segments; ++k) for (const u of [0, 0.3, 0.8]) {
    const piece = name === 'path' ? curve.curves[k].getPoint(u) : curve.getPoint((k + u) / segments);
    const p = [piece.x, piece.y, piece.z ?? 0];
    at.push([k, u, p]);
  }
  const json = curve.toJSON();
  list.push('  ' + JSON.stringify({name, curve: json, points: at}));
}
writeFileSync('three.json', '{"made_by": "three_curves.mjs", "curves": [\n' + list.join(',\n') + '\n]}\n');
