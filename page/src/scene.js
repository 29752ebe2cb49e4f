// The curve in space with ribbons along its frames, and the frame at one place.
import {
  AmbientLight,
  ArrowHelper,
  BufferGeometry,
  Color,
  DirectionalLight,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  Line,
  LineBasicMaterial,
  Mesh,
  MeshLambertMaterial,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const papers = { light: '#f3f1ea', dark: '#111318' };
const inks = { light: '#222222', dark: '#eeeeee' };

/** The centre of the box of the points, and half of its diagonal. */
function extent(points) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const p of points)
    for (let k = 0; k < 3; ++k) {
      low[k] = Math.min(low[k], p[k]);
      high[k] = Math.max(high[k], p[k]);
    }
  const centre = low.map((x, k) => x / 2 + high[k] / 2);
  return { centre, size: Math.hypot(...low.map((x, k) => high[k] / 2 - x / 2)) || 1 };
}

/** Of length 1, for the picture: frames of others may be long or short. */
function unit(v) {
  const length = v && Math.hypot(...v);
  return length ? v.map((x) => x / length) : null;
}

/** A strip between r and r + width·second, in pieces where the frame is defined. */
function ribbon(points, seconds, width, material) {
  const vertices = [];
  const faces = [];
  points.forEach((p, k) => {
    const v = seconds[k] ?? [0, 0, 0];
    vertices.push(...p, ...p.map((x, axis) => x + width * v[axis]));
    if (k > 0 && seconds[k] && seconds[k - 1])
      faces.push(2 * k - 2, 2 * k - 1, 2 * k, 2 * k - 1, 2 * k + 1, 2 * k);
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(vertices, 3));
  geometry.setIndex(faces);
  geometry.computeVertexNormals();
  return new Mesh(geometry, material);
}

export function makeScene(element, { rows, position, tangent, frames, vector, isClosed }) {
  const renderer = new WebGLRenderer({ antialias: true });
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  element.append(renderer.domElement);
  renderer.domElement.setAttribute('aria-hidden', 'true');

  // In doubles, before the picture's single precision: a curve may be small and far away.
  const { centre, size } = extent(rows.map(position));
  const points = rows.map((row) => position(row).map((x, k) => (x - centre[k]) / size));
  const width = 0.16;

  const scene = new Scene();
  const camera = new PerspectiveCamera(40, 1, 0.01, 50);
  camera.up.set(0, 0, 1);
  const controls = new OrbitControls(camera, renderer.domElement);
  const from = new Vector3(1.9, -2.4, 1.5);
  scene.add(new AmbientLight('#ffffff', 1.6));
  const light = new DirectionalLight('#ffffff', 2);
  camera.add(light);
  scene.add(camera);

  const ink = new LineBasicMaterial({ color: inks.light });
  const path = new BufferGeometry();
  path.setAttribute('position', new Float32BufferAttribute(points.flat(), 3));
  scene.add(new Line(path, ink));

  const drawn = frames.map((frame) => {
    const seconds = rows.map((row) => unit(vector(row, frame.second)));
    const material = new MeshLambertMaterial({
      color: frame.colour,
      side: DoubleSide,
      transparent: true,
      opacity: 0.85,
    });
    const group = new Group();
    group.add(ribbon(points, seconds, width, material));
    // Of a closed curve: how it starts and how it comes back.
    if (isClosed)
      for (const k of [0, rows.length - 1])
        if (seconds[k])
          group.add(
            new ArrowHelper(
              new Vector3(...seconds[k]),
              new Vector3(...points[k]),
              1.8 * width,
              k === 0 ? '#777777' : frame.colour,
              0.05,
              0.03,
            ),
          );
    scene.add(group);
    return group;
  });

  const moving = new Group();
  scene.add(moving);
  const arrow = (v, from, colour) =>
    moving.add(
      new ArrowHelper(new Vector3(...v), new Vector3(...from), 0.42, colour, 0.09, 0.05),
    );
  let at = 0;

  const render = () => renderer.render(scene, camera);
  const api = {
    update() {
      frames.forEach((frame, k) => (drawn[k].visible = frame.isShown));
      for (const child of [...moving.children]) child.dispose();
      moving.clear();
      const row = rows[at];
      const e1 = tangent(row);
      if (e1) arrow(e1, points[at], ink.color);
      for (const frame of frames.filter((frame) => frame.isShown))
        for (const name of [frame.second, frame.third]) {
          const v = unit(vector(row, name));
          if (v) arrow(v, points[at], frame.colour);
        }
      render();
    },
    moveTo(k) {
      at = k;
      api.update();
    },
    lookFromStart() {
      camera.position.copy(from);
      controls.target.set(0, 0, 0);
      controls.update();
      render();
    },
    setTheme(name) {
      scene.background = new Color(papers[name]);
      ink.color = new Color(inks[name]);
      api.update();
    },
  };
  const resize = () => {
    const { clientWidth, clientHeight } = element;
    if (!clientWidth || !clientHeight) return;
    renderer.setSize(clientWidth, clientHeight);
    camera.aspect = clientWidth / clientHeight;
    camera.updateProjectionMatrix();
    render();
  };
  controls.addEventListener('change', render);
  new ResizeObserver(resize).observe(element);
  resize();
  api.lookFromStart();
  return api;
}
