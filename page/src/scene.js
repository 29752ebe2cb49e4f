// The curve in space with ribbons along its frames, and the frame at one place.
import {
  AmbientLight,
  ConeGeometry,
  BufferGeometry,
  Color,
  DirectionalLight,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  Line,
  LineBasicMaterial,
  LineDashedMaterial,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { styles } from './frames.js';

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

/** The ways of a frame along the points, in pieces: lists of {point, second}. A piece ends where the frame is undefined, jumps or flips. */
function pieces(points, seconds, before) {
  const list = [];
  let piece = [];
  const end = () => {
    if (piece.length > 1) list.push(piece);
    piece = [];
  };
  const add = (point, second) => {
    const last = piece.at(-1)?.second;
    if (last && last.reduce((sum, x, k) => sum + x * second[k], 0) < 0) end();
    piece.push({ point, second });
  };
  points.forEach((point, k) => {
    if (before(k) !== undefined) {
      if (before(k)) add(point, before(k));
      end();
    }
    if (seconds[k]) add(point, seconds[k]);
    else if (seconds[k] === null) end();
  });
  end();
  return list;
}

const moved = (point, second, width) => point.map((x, axis) => x + width * second[axis]);

/** A strip between r and r + width·second. */
function ribbon(piece, width, material) {
  const vertices = piece.flatMap(({ point, second }) => [...point, ...moved(point, second, width)]);
  const faces = piece.flatMap((_, k) =>
    k === 0 ? [] : [2 * k - 2, 2 * k - 1, 2 * k, 2 * k - 1, 2 * k + 1, 2 * k],
  );
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(vertices, 3));
  geometry.setIndex(faces);
  geometry.computeVertexNormals();
  return new Mesh(geometry, material);
}

function polyline(points, material) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(points.flat(), 3));
  const line = new Line(geometry, material);
  line.computeLineDistances();
  return line;
}

/** Solid, or in dashes of hundredths. */
const stroke = (dash) =>
  dash
    ? new LineDashedMaterial({ dashSize: dash[0] / 100, gapSize: dash[1] / 100 })
    : new LineBasicMaterial();

/** An arrow from a point along a unit vector, whose shaft is drawn as the material says. */
function arrow(v, from, length, line, tip) {
  const group = new Group();
  const end = moved(from, v, length);
  group.add(polyline([from, end], line));
  const cone = new Mesh(new ConeGeometry(0.022, 0.075, 12), tip);
  cone.position.set(...moved(from, v, length - 0.0375));
  cone.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), new Vector3(...v));
  group.add(cone);
  return group;
}

/**
 * Of frames: {second, third, what, names, isShown, vectors}, where vectors(k) are the two to draw at row k, null where
 * undefined and undefined where there is none; before(k) is the second one just before a jump at row k.
 */
export function makeScene(element, { rows, position, tangent, frames, isClosed }) {
  // picture() reads what was drawn.
  const renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  element.append(renderer.domElement);
  renderer.domElement.setAttribute('aria-hidden', 'true');

  // In doubles, before the picture's single precision: a curve may be small and far away.
  const { centre, size } = extent(rows.map(position));
  const points = rows.map((row) => position(row).map((x, k) => (x - centre[k]) / size));

  const scene = new Scene();
  const camera = new PerspectiveCamera(40, 1, 0.01, 50);
  camera.up.set(0, 0, 1);
  const controls = new OrbitControls(camera, renderer.domElement);
  const from = new Vector3(1.9, -2.4, 1.5).setLength(3.5);
  scene.add(new AmbientLight('#ffffff', 1.7));
  const light = new DirectionalLight('#ffffff', 1.9);
  camera.add(light);
  scene.add(camera);

  const ink = new LineBasicMaterial();
  const inkTip = new MeshBasicMaterial();
  scene.add(polyline(points, ink));

  // What is told apart by colour is so by lines, too: the free edge of a ribbon, and its arrows.
  const drawn = frames.map((frame) => {
    const { dash, width } = styles[frame.second];
    const colours = {
      // Of two in one place the narrower one is in front.
      face: new MeshLambertMaterial({ side: DoubleSide, transparent: true, opacity: 0.8, polygonOffset: true, polygonOffsetFactor: width / 4, polygonOffsetUnits: width }),
      edge: stroke(dash),
      tip: new MeshBasicMaterial(),
      third: new LineDashedMaterial({ dashSize: 0.025, gapSize: 0.02 }),
    };
    return { frame, colours, group: null };
  });
  function shape({ frame, colours }) {
    const group = new Group();
    const width = styles[frame.second].width / 100;
    const seconds = rows.map((_, k) => {
      const vectors = frame.vectors(k);
      return vectors === undefined ? undefined : unit(vectors[0]);
    });
    const before = (k) => {
      const v = frame.before(k);
      return v === undefined ? undefined : unit(v);
    };
    for (const piece of pieces(points, seconds, before)) {
      group.add(ribbon(piece, width, colours.face));
      group.add(polyline(piece.map(({ point, second }) => moved(point, second, width)), colours.edge));
    }
    // Of a closed curve: how it starts and how it comes back.
    if (isClosed)
      for (const k of [0, rows.length - 1])
        if (seconds[k]) group.add(arrow(seconds[k], points[k], (k === 0 ? 1.4 : 1.9) * width, colours.edge, colours.tip));
    return group;
  }
  function reshape(entry) {
    if (entry.group) {
      scene.remove(entry.group);
      entry.group.traverse((part) => part.geometry?.dispose());
    }
    entry.group = shape(entry);
    scene.add(entry.group);
  }
  drawn.forEach(reshape);

  const moving = new Group();
  scene.add(moving);
  let at = 0;
  let labels = [];
  const place = new Vector3();

  function render() {
    renderer.render(scene, camera);
    const { clientWidth, clientHeight } = element;
    for (const { box, at } of labels) {
      place.set(...at).project(camera);
      box.style.left = `${((place.x + 1) / 2) * clientWidth}px`;
      box.style.top = `${((1 - place.y) / 2) * clientHeight}px`;
    }
  }
  function add(v, length, line, tip, name, colour) {
    moving.add(arrow(v, points[at], length, line, tip));
    const box = document.createElement('span');
    box.textContent = name;
    box.style.color = colour;
    element.append(box);
    labels.push({ box, at: moved(points[at], v, length + 0.05) });
  }
  const api = {
    update() {
      for (const { frame, group } of drawn) group.visible = frame.isShown;
      moving.traverse((part) => part.geometry?.dispose());
      moving.clear();
      for (const { box } of labels) box.remove();
      labels = [];
      const e1 = tangent(rows[at]);
      if (e1) add(e1, 0.42, ink, inkTip, 'e₁', `#${ink.color.getHexString()}`);
      for (const { frame, colours } of drawn.filter(({ frame }) => frame.isShown)) {
        const [second, third] = (frame.vectors(at) ?? [null, null]).map(unit);
        const colour = `#${colours.tip.color.getHexString()}`;
        // The third vector is shorter, and its shaft is dotted.
        if (second) add(second, 0.42, colours.edge, colours.tip, frame.names[0], colour);
        if (third) add(third, 0.3, colours.third, colours.tip, frame.names[1], colour);
      }
      render();
    },
    /** As it is now. */
    picture() {
      render();
      return renderer.domElement.toDataURL();
    },
    /** After the vectors of a frame have changed. */
    reshape(k) {
      reshape(drawn[k]);
      api.update();
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
      for (const material of [ink, inkTip]) material.color = new Color(inks[name]);
      for (const { frame, colours } of drawn)
        for (const material of Object.values(colours)) material.color = new Color(styles[frame.second][name]);
      api.update();
    },
  };
  const resize = () => {
    const { clientWidth, clientHeight } = element;
    if (!clientWidth || !clientHeight) return;
    renderer.setSize(clientWidth, clientHeight);
    camera.aspect = clientWidth / clientHeight;
    // What fits into a square is seen in an upright picture, too.
    camera.fov = camera.aspect < 1 ? (360 / Math.PI) * Math.atan(Math.tan(Math.PI / 9) / camera.aspect) : 40;
    camera.updateProjectionMatrix();
    render();
  };
  controls.addEventListener('change', render);
  new ResizeObserver(resize).observe(element);
  resize();
  api.lookFromStart();
  return api;
}
