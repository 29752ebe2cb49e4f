#pragma once
#include <string_view>

namespace phrame::inline v0 {

/// What is the same in each page of offsets.
constexpr std::string_view offset_page_style = R"css(
:root { color-scheme: light dark; --paper: #fbfaf7; --ink: #1d1f24; --soft: #6b6f78; --line: #d8d5cc; --panel: #fff; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #16181d; --ink: #e8e6e1; --soft: #9a9da6; --line: #353942; --panel: #1e2128; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 96rem; padding: 1rem; background: var(--paper); color: var(--ink); font: 16px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.5rem; margin: 0; overflow-wrap: anywhere; }
h2 { font-size: 1.05rem; margin: 0 0 0.5rem; }
header p, .soft { color: var(--soft); margin: 0 0 0.75rem; font-size: 0.9rem; }
section { background: var(--panel); border: 1px solid var(--line); border-radius: 8px; padding: 0.9rem; margin-bottom: 1rem; min-width: 0; }
#drawing { display: block; width: 100%; height: 70vh; cursor: crosshair; touch-action: none; }
#drawing path { fill: none; stroke-width: 1.8; vector-effect: non-scaling-stroke; }
#drawing .curve { stroke: var(--ink); stroke-width: 1.2; }
#drawing .offset { stroke: var(--colour); }
#drawing .whole { stroke: var(--colour); stroke-width: 1; stroke-dasharray: 3 4; opacity: 0.7; }
#drawing .mark { stroke: var(--colour); }
#drawing .mark circle, #drawing .mark rect { fill: var(--panel); fill-opacity: 0.6; stroke-width: 1.6; vector-effect: non-scaling-stroke; }
#drawing .chosen { stroke: var(--ink); }
#drawing :is(#normal, #place) { stroke: var(--ink); stroke-width: 1; fill: none; vector-effect: non-scaling-stroke; pointer-events: none; }
.tools { display: flex; flex-wrap: wrap; gap: 0.3rem 1.2rem; align-items: center; margin-top: 0.5rem; }
.tools label { white-space: nowrap; }
.swatch { display: inline-block; width: 1.6em; height: 0.3em; vertical-align: 0.2em; background: var(--colour); }
button { font: inherit; color: inherit; background: var(--panel); border: 1px solid var(--line); border-radius: 6px; min-width: 2.2rem; min-height: 2.2rem; cursor: pointer; }
output { display: block; min-height: 3em; font-variant-numeric: tabular-nums; overflow-wrap: anywhere; }
.wide { overflow: auto; max-height: 30rem; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: 0.85rem; }
th, td { text-align: left; padding: 0.1rem 1rem 0.1rem 0; white-space: nowrap; }
#marks tbody tr { cursor: pointer; }
#marks tbody tr:is(:hover, .chosen) { background: var(--line); }
pre { overflow: auto; max-height: 40rem; margin: 0; font: 0.82rem/1.45 ui-monospace, monospace; }
:focus-visible { outline: 2px solid #0072b2; outline-offset: 2px; }
)css";

/// It decides nothing: it moves the view, and shows of what is given what is nearest to the
/// pointer.
constexpr std::string_view offset_page_script = R"js(
'use strict';
const svg = document.getElementById('drawing');
const layers = JSON.parse(document.getElementById('data').textContent);
const whole = svg.viewBox.baseVal;
const home = { x: whole.x, y: whole.y, width: whole.width, height: whole.height };
let view = { ...home };
const out = document.getElementById('at');
const marks = [...svg.querySelectorAll('.mark')];
const rows = [...document.querySelectorAll('#marks tbody tr')];
const place = document.getElementById('place');
const normal = document.getElementById('normal');
const hint = out.textContent;

/** How much of the drawing a pixel is. */
const pixel = () => Math.max(view.width / svg.clientWidth, view.height / svg.clientHeight);
const isShown = (layer) => document.getElementById(`show-${layer}`).checked;

function update() {
  svg.setAttribute('viewBox', [view.x, view.y, view.width, view.height].join(' '));
  const size = pixel();
  for (const mark of marks) mark.setAttribute('transform', `translate(${mark.dataset.x} ${mark.dataset.y}) scale(${size})`);
  place.setAttribute('r', 4 * size);
}
function zoom(factor, x = view.x + view.width / 2, y = view.y + view.height / 2) {
  // Browsers draw with about seven digits: nearer, lines would shake.
  const width = Math.min(Math.max(view.width * factor, home.width / 2000), home.width * 5);
  const by = width / view.width;
  view = { x: x + (view.x - x) * by, y: y + (view.y - y) * by, width, height: view.height * by };
  update();
}
function pan(x, y) {
  view.x += x;
  view.y += y;
  update();
}
function reset() {
  view = { ...home };
  update();
}
function inDrawing(event) {
  const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
  return [at.x, at.y];
}

function choose(text, mark) {
  out.textContent = text;
  marks.forEach((each, k) => each.classList.toggle('chosen', k === mark));
  rows.forEach((each, k) => each.classList.toggle('chosen', k === mark));
}
function clear() {
  place.style.display = normal.style.display = 'none';
  choose(hint, -1);
}
function showMark(k) {
  clear();
  choose(marks[k].querySelector('title').textContent, k);
}
/** The mark or the point of an offset next to the pointer, if it is near. */
function tell([x, y]) {
  const size = pixel();
  let best = 12 * size, found = null;
  marks.forEach((mark, k) => {
    const distance = Math.hypot(mark.dataset.x - x, mark.dataset.y - y);
    if (distance < best && isShown(mark.dataset.layer)) [best, found] = [distance, k];
  });
  if (found !== null) return showMark(found);
  best = 60 * size;
  layers.forEach((layer, k) => {
    if (!isShown(k)) return;
    for (const sample of layer.samples) {
      const distance = Math.hypot(sample[3] - x, sample[4] - y);
      if (distance < best) [best, found] = [distance, [layer, sample]];
    }
  });
  clear();
  if (found === null) return undefined;
  const [layer, [t, atX, atY, px, py, ofX, ofY, isJoin]] = found;
  place.setAttribute('cx', px);
  place.setAttribute('cy', py);
  normal.setAttribute('d', `M${ofX},${ofY}L${px},${py}`);
  place.style.display = normal.style.display = '';
  return choose(`${layer.label}, ${isJoin ? 'the join at ' : ''}t = ${t}: (${atX}, ${atY})`, -1);
}

let isPinned = false, drag = null;
svg.addEventListener('wheel', (event) => {
  event.preventDefault();
  zoom(Math.exp(Math.max(-200, Math.min(200, event.deltaY)) / 400), ...inDrawing(event));
}, { passive: false });
svg.addEventListener('pointerdown', (event) => {
  if (event.button !== 0) return;
  drag = { x: event.clientX, y: event.clientY, moved: false };
  svg.setPointerCapture(event.pointerId);
});
svg.addEventListener('pointermove', (event) => {
  if (drag === null) {
    if (!isPinned) tell(inDrawing(event));
    return;
  }
  const [x, y] = [event.clientX - drag.x, event.clientY - drag.y];
  if (!drag.moved && Math.hypot(x, y) < 4) return;
  const size = pixel();
  pan(-x * size, -y * size);
  drag = { x: event.clientX, y: event.clientY, moved: true };
});
svg.addEventListener('pointerup', (event) => {
  if (drag !== null && !drag.moved) {
    tell(inDrawing(event));
    isPinned = out.textContent !== hint;
  }
  drag = null;
});
svg.addEventListener('pointercancel', () => { drag = null; });
svg.addEventListener('dblclick', reset);
svg.addEventListener('keydown', (event) => {
  const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
  if (step) pan(step[0] * view.width / 20, step[1] * view.height / 20);
  else if (event.key === '+') zoom(0.8);
  else if (event.key === '-') zoom(1.25);
  else if (event.key === '0') reset();
  else if (event.key === 'Escape') { isPinned = false; clear(); }
  else return;
  event.preventDefault();
});
rows.forEach((row, k) => row.addEventListener('click', () => {
  isPinned = true;
  const [x, y] = [Number(marks[k].dataset.x), Number(marks[k].dataset.y)];
  view.x = x - view.width / 2;
  view.y = y - view.height / 2;
  update();
  showMark(k);
}));
for (const box of document.querySelectorAll('input[data-shows]'))
  box.addEventListener('change', () => {
    for (const each of svg.querySelectorAll(box.dataset.shows)) each.style.display = box.checked ? '' : 'none';
  });
document.getElementById('nearer').addEventListener('click', () => zoom(0.7));
document.getElementById('farther').addEventListener('click', () => zoom(1 / 0.7));
document.getElementById('all').addEventListener('click', reset);
addEventListener('resize', update);
update();
clear();
document.documentElement.dataset.ready = '';
)js";

}  // namespace phrame
