// The page of a curve. All numbers come from the data, where phrame rounded them correctly; what is
// computed here is where to draw them.
import katex from 'katex';
import { drawPlots } from './plots.js';
import { drawPoles } from './poles.js';
import { makeScene } from './scene.js';

const data = JSON.parse(document.getElementById('data').textContent);
const byId = (id) => document.getElementById(id);
const make = (name, text, attributes = {}) => {
  const element = document.createElement(name);
  if (text !== undefined) element.textContent = text;
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
};

// The table is the CSV that can be taken along; an empty cell is a number that is undefined.
const [columns, ...rows] = data.csv
  .trimEnd()
  .split('\n')
  .map((line, k) =>
    line.split(',').map((cell) => (k === 0 ? cell : cell === '' ? null : Number(cell))),
  );
const column = Object.fromEntries(columns.map((name, k) => [name, k]));
/** The vector name, namey, namez of a row; null where it is undefined. */
const vector = (row, name) => {
  const v = ['x', 'y', 'z'].map((axis) => row[column[name + axis]]);
  return v.includes(null) ? null : v;
};
const position = (row) => [row[column.x], row[column.y], row[column.z]];
const written = (x) => (x === null || x === undefined ? '–' : String(x).replace('-', '−'));

const colours = ['#d1495b', '#2e86ab', '#e59500', '#3c8d5a', '#8e5bb5', '#6f6a5f'];
const frames = data.frames.map((frame, k) => ({ ...frame, colour: colours[k % colours.length] }));

// ---- the theme: that of the system until somebody chooses
const dark = matchMedia('(prefers-color-scheme: dark)');
let theme = dark.matches ? 'dark' : 'light';
const listeners = [];
const setTheme = (next) => {
  theme = next;
  document.documentElement.dataset.theme = theme;
  for (const listener of listeners) listener(theme);
};
dark.addEventListener('change', () => setTheme(dark.matches ? 'dark' : 'light'));
byId('theme').addEventListener('click', () => setTheme(theme === 'dark' ? 'light' : 'dark'));

// ---- heads
byId('name').textContent = data.name || data.heading;
byId('heading').textContent = data.name ? data.heading : '';
byId('made').textContent =
  `Made by phrame ${data.version}. Numbers in the table and the plots are correctly rounded doubles, but for the errors of given frames.`;

// ---- the scene
const summary = () => {
  const row = rows[slider.valueAsNumber];
  const shown = frames.filter((frame) => frame.isShown).map((frame) => frame.what);
  return (
    `${data.heading}. At t = ${written(row[column.t])} it is at (${position(row).map(written).join(', ')}). ` +
    `Frames shown: ${shown.join('; ') || 'none'}.`
  );
};
const slider = byId('slider');
slider.max = String(rows.length - 1);
let scene = null;
try {
  scene = makeScene(byId('scene'), {
    rows,
    position,
    tangent: (row) => vector(row, 'e1'),
    frames,
    vector,
    isClosed: data.closed,
  });
  listeners.push((name) => scene.setTheme(name));
} catch (error) {
  byId('scene').append(make('p', `No picture: this browser has no WebGL 2. (${error.message})`));
}

// ---- which frames are shown
const switches = frames.map((frame, k) => {
  const label = make('label');
  const box = make('input', undefined, { type: 'checkbox' });
  const swatch = make('i');
  swatch.style.background = frame.colour;
  label.append(box, swatch, frame.what);
  byId('ribbons').append(label);
  box.checked = frame.isShown = k === 0 || frame.shown === true;
  box.addEventListener('change', () => {
    frame.isShown = box.checked;
    scene?.update();
    showHere();
  });
  return box;
});

// ---- the place on the curve
const movePlots = drawPlots(byId('plots'), data.plots, rows, column, (k) => moveTo(k));

function showHere() {
  const row = rows[slider.valueAsNumber];
  byId('at').textContent = `t = ${written(row[column.t])}`;
  const table = make('table');
  const add = (name, values) => {
    const line = make('tr');
    line.append(make('th', name, { scope: 'row' }), ...values.map((x) => make('td', written(x))));
    table.append(line);
  };
  add('r', position(row));
  add('e₁', vector(row, 'e1'));
  for (const frame of frames.filter((frame) => frame.isShown)) {
    add(frame.names[0], vector(row, frame.second) ?? [null, null, null]);
    add(frame.names[1], vector(row, frame.third) ?? [null, null, null]);
  }
  for (const plot of data.plots) add(plot.label, [row[column[plot.column]], '', '']);
  const wide = make('div', undefined, { class: 'wide' });
  wide.append(table);
  byId('numbers').replaceChildren(wide);
  byId('scene').setAttribute('aria-label', summary());
}

function moveTo(k) {
  slider.value = String(Math.max(0, Math.min(rows.length - 1, k)));
  slider.setAttribute('aria-valuetext', `t = ${written(rows[slider.valueAsNumber][column.t])}`);
  scene?.moveTo(slider.valueAsNumber);
  movePlots(slider.valueAsNumber);
  showHere();
}
slider.addEventListener('input', () => moveTo(slider.valueAsNumber));

// ---- playing
let playing = 0;
const play = byId('play');
const stop = () => {
  cancelAnimationFrame(playing);
  playing = 0;
  play.textContent = '▶';
  play.setAttribute('aria-label', 'play');
};
const start = () => {
  const began = performance.now();
  const from = slider.valueAsNumber === rows.length - 1 ? 0 : slider.valueAsNumber;
  const perSecond = (rows.length - 1) / 8;
  play.textContent = '❚❚';
  play.setAttribute('aria-label', 'stop');
  const step = (now) => {
    const k = from + Math.floor(((now - began) / 1000) * perSecond);
    moveTo(k);
    if (k >= rows.length - 1) stop();
    else playing = requestAnimationFrame(step);
  };
  playing = requestAnimationFrame(step);
};
play.addEventListener('click', () => (playing ? stop() : start()));

document.addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const isSlider = event.target === slider;
  if (/^(INPUT|TEXTAREA|SELECT)$/.test(event.target.tagName) && !isSlider) return;
  const isButton = event.target.tagName === 'BUTTON' || event.target.tagName === 'SUMMARY';
  const step = event.shiftKey ? 10 : 1;
  if (event.key === 'ArrowRight' && !isSlider) moveTo(slider.valueAsNumber + step);
  else if (event.key === 'ArrowLeft' && !isSlider) moveTo(slider.valueAsNumber - step);
  else if (event.key === ' ' && !isButton) playing ? stop() : start();
  else if (event.key === '0') scene?.lookFromStart();
  else if (/^[1-9]$/.test(event.key) && switches[event.key - 1]) switches[event.key - 1].click();
  else return;
  event.preventDefault();
});

// ---- the closed form
const formula = byId('formula');
for (const text of data.latex) {
  const box = make('div', undefined, { class: 'wide' });
  katex.render(text, box, { displayMode: true, throwOnError: false, strict: false, trust: false });
  formula.append(box);
}
for (const sentence of data.said) formula.append(make('p', sentence));
if (data.poles?.rows.length) {
  byId('poles').hidden = false;
  drawPoles(byId('poles'), data.poles);
}

// ---- what is known exactly
for (const { title, text } of data.facts) {
  const box = make('details');
  if (byId('facts').children.length === 1) box.open = true;
  box.append(make('summary', title), make('pre', text));
  byId('facts').append(box);
}

// ---- downloads
const csv = { name: data.csv_name, type: 'text/csv', text: data.csv };
for (const { name, type, text } of [csv, ...data.downloads]) {
  const button = make('button', name, { type: 'button' });
  button.addEventListener('click', () => {
    const link = make('a', undefined, { download: name });
    link.href = URL.createObjectURL(new Blob([text], { type }));
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  });
  byId('downloads').append(button);
}

// ---- the table, when somebody wants it
const details = make('details');
details.append(make('summary', `${rows.length} rows, ${columns.length} columns`));
details.addEventListener('toggle', () => {
  if (!details.open || details.children.length > 1) return;
  const table = make('table');
  const head = make('tr');
  head.append(...columns.map((name) => make('th', name, { scope: 'col' })));
  const top = make('thead');
  top.append(head);
  const body = make('tbody');
  for (const row of rows) {
    const line = make('tr');
    line.append(...row.map((x) => make('td', written(x))));
    body.append(line);
  }
  table.append(top, body);
  const wide = make('div', undefined, { class: 'wide', tabindex: '0' });
  wide.append(table);
  details.append(wide);
});
byId('table').append(details);

setTheme(theme);
moveTo(0);
document.documentElement.dataset.ready = 'true';
