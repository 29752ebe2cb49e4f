// The page of a curve. All numbers come from the data, where phrame rounded them correctly; what is
// computed here is where to draw them.
import { equations } from './equations.js';
import { magnification, styles, turned } from './frames.js';
import { drawPlots } from './plots.js';
import { drawPoles } from './poles.js';
import { makeScene } from './scene.js';
import { svg } from './svg.js';
import { brief, typeset, written } from './text.js';

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

/** At rows that are joints: the columns that are another number just before, with that. */
const jumps = new Map(data.jumps);

// ---- the frames, and how those that were given are drawn: turned away from the exact one by their error, made greater
const errors = column.error === undefined ? [] : rows.map((row) => row[column.error]);
const worst = errors.reduce((most, x, k) => (Math.abs(x ?? 0) > Math.abs(errors[most] ?? 0) ? k : most), 0);
let magnified = magnification(Math.abs(errors[worst] ?? 0));
const frames = data.frames.map((frame) => ({
  ...frame,
  vectors(k) {
    const row = rows[k];
    if (frame.second !== 'g2') return [vector(row, frame.second), vector(row, frame.third)];
    // No frame was given at rows between.
    if (row[column.error] === null && vector(row, 'g2') === null) return undefined;
    if (magnified === 1 || row[column.error] === null) return [vector(row, 'g2'), vector(row, 'g3')];
    const [f2, f3] = [vector(row, 'f2'), vector(row, 'f3')];
    const angle = magnified * row[column.error];
    return [turned(f2, f3, angle), turned(f3, f2?.map((x) => -x), angle)];
  },
  before(k) {
    const jump = jumps.get(k);
    if (!jump || frame.second !== 'n' || !('nx' in jump || 'ny' in jump || 'nz' in jump)) return undefined;
    return vector(rows[k].map((x, j) => (columns[j] in jump ? jump[columns[j]] : x)), 'n');
  },
}));

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
    isClosed: data.closed,
  });
  listeners.push((name) => scene.setTheme(name));
} catch (error) {
  byId('scene').append(make('p', `No picture: this browser has no WebGL 2. (${error.message})`));
}

// ---- which frames are shown
/** A piece of the ribbon's edge. */
const swatch = (frame) => {
  const { dash } = styles[frame.second];
  const stroke = dash ? { 'stroke-dasharray': dash.map((x) => 1.2 * x).join(' ') } : {};
  const box = svg('svg', { viewBox: '0 0 30 12', class: 'swatch', 'aria-hidden': 'true' }, [
    svg('rect', { width: 30, height: 8, y: 4, fill: 'currentColor', 'fill-opacity': 0.45 }),
    svg('line', { x2: 30, y1: 3, y2: 3, stroke: 'currentColor', 'stroke-width': 3, ...stroke }),
  ]);
  listeners.push((name) => (box.style.color = styles[frame.second][name]));
  return box;
};
const box = (text, checked, change, ...before) => {
  const label = make('label');
  const input = make('input', undefined, { type: 'checkbox' });
  input.checked = checked;
  input.addEventListener('change', () => change(input.checked));
  label.append(input, ...before, text);
  byId('ribbons').append(label);
  return input;
};
const switches = frames.map((frame, k) => {
  frame.isShown = k === 0 || frame.shown === true;
  const show = (checked) => {
    frame.isShown = checked;
    scene?.update();
    showHere();
  };
  return box(frame.what, frame.isShown, show, swatch(frame));
});
if (errors.length) {
  const [error, t] = [errors[worst], rows[worst][column.t]];
  const off = `The given frame is off by up to ${brief(Math.abs(error ?? 0))} rad, at t = ${brief(t)}.`;
  const times = magnified;
  byId('error').textContent =
    times === 1 ? off : `${off} So that it can be seen, its ribbon and arrows are drawn ${brief(times)} times as far away from the exact frame.`;
  if (times !== 1)
    box(`error × ${brief(times)}`, true, (checked) => {
      magnified = checked ? times : 1;
      scene?.reshape(frames.findIndex((frame) => frame.second === 'g2'));
    });
}

// ---- the place on the curve
const movePlots = drawPlots(byId('plots'), data.plots, rows, column, jumps, (k) => moveTo(k));
byId('said-of-plots').textContent = data.said_of_plots;

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

let onScreen = null; // while the page is printed, what it was
// ---- the closed form
const formula = byId('formula');
const fits = data.latex.map((text) => equations(formula, text));
const fit = (width) => fits.flatMap((fit) => fit(width));
let fitted = 0;
new ResizeObserver(() => {
  const style = getComputedStyle(formula);
  const width = Math.floor(formula.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight));
  if (width !== fitted && !onScreen) fit((fitted = width));
}).observe(formula);
for (const sentence of data.said) formula.append(make('p', typeset(sentence)));
if (data.poles?.rows.length) {
  byId('poles').hidden = false;
  drawPoles(byId('poles'), data.poles);
}

// ---- what is known exactly
for (const { title, text } of data.facts) {
  const box = make('details');
  if (byId('facts').children.length === 1) box.open = true;
  box.append(make('summary', title), make('pre', typeset(text)));
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

if (data.missing) byId('downloads').append(make('p', data.missing, { class: 'soft' }));

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

// ---- on paper: light, everything unfolded but the table, no equation wider than the sheet
addEventListener('beforeprint', () => {
  if (onScreen) return;
  onScreen = { theme, unfolded: [...document.querySelectorAll('#facts details:not([open])')], parts: [] };
  setTheme('light');
  for (const part of onScreen.unfolded) part.open = true;
  if (scene) {
    // What a printer sees of a canvas is what was last on the screen.
    onScreen.parts.push(make('img', undefined, { src: scene.picture(), alt: summary(), class: 'paper' }));
    byId('scene').append(onScreen.parts[0]);
  }
  for (const { box, share } of fit(640)) {
    if (share < 1) box.style.fontSize = `${share}em`;
    if (share > 0.35) continue;
    box.classList.add('too-wide');
    const note = make('p', 'An equation that is too wide for paper is on the page itself.', { class: 'paper' });
    box.after(note);
    onScreen.parts.push(note);
  }
});
addEventListener('afterprint', () => {
  if (!onScreen) return;
  for (const part of onScreen.unfolded) part.open = false;
  for (const part of onScreen.parts) part.remove();
  for (const wide of document.querySelectorAll('.equation')) {
    wide.style.fontSize = '';
    wide.classList.remove('too-wide');
  }
  setTheme(onScreen.theme);
  onScreen = null;
  if (fitted) fit(fitted);
});

setTheme(theme);
moveTo(0);
document.documentElement.dataset.ready = 'true';
