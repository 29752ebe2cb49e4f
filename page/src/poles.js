// The poles of θ′ in the complex plane, with [0, 1] among them, and their residues in a table.
import { accent, figure, svg, textWidth, ticks } from './svg.js';
import { brief, typeset } from './text.js';

const side = 320;
const edge = 12;
const size = 11;

export function drawPoles(element, { rows, count, end }) {
  const numbers = rows.map((row) => ({ re: Number(row.re), im: Number(row.im) }));
  const reach = Math.max(
    end / 2,
    ...numbers.map(({ re, im }) => Math.max(Math.abs(re - end / 2), Math.abs(im))),
  );
  const low = end / 2 - 1.1 * reach;
  const high = end / 2 + 1.1 * reach;
  const upright = ticks(low - end / 2, high - end / 2, 3).map((im) => ({ im, label: im === 0 ? '0' : `${brief(im)}i` }));
  const left = Math.max(...upright.map(({ label }) => textWidth(label, size))) + 10;
  const scale = (side - left - edge) / (high - low);
  const x = (re) => left + (re - low) * scale;
  const y = (im) => edge + (high - end / 2 - im) * scale;
  const bottom = y(low - end / 2) + 22;
  const text = (label, attributes) =>
    svg('text', { fill: 'currentColor', 'font-size': size, ...attributes }, [label]);
  const cross = (re, im) =>
    svg('path', {
      d: `M${x(re) - 4} ${y(im) - 4}l8 8m0 -8l-8 8`,
      stroke: accent,
      'stroke-width': 1.6,
    });
  const drawing = svg('svg', { viewBox: `0 0 ${side} ${bottom}`, role: 'img', 'aria-label': 'the poles in the complex plane' }, [
    svg('line', { x1: left, x2: side - edge, y1: y(0), y2: y(0), stroke: 'currentColor', 'stroke-opacity': 0.4 }),
    svg('line', { x1: x(0), x2: x(end), y1: y(0), y2: y(0), stroke: 'currentColor', 'stroke-width': 3 }),
    ...ticks(low, high, 3).map((re) => text(brief(re), { x: x(re), y: bottom - 5, 'text-anchor': 'middle', class: 'along' })),
    ...upright.map(({ im, label }) => text(label, { x: left - 6, y: y(im) + 4, 'text-anchor': 'end' })),
    ...numbers.flatMap(({ re, im }) => (im === 0 ? [cross(re, 0)] : [cross(re, im), cross(re, -im)])),
  ]);
  const box = figure(['in the complex plane'], 'poles', () => drawing);
  box.append(drawing);
  box.style.maxWidth = '24rem';
  const table = document.createElement('table');
  const add = (name, cells) => {
    const line = document.createElement('tr');
    for (const cell of cells) {
      const element = document.createElement(name);
      element.textContent = typeset(cell);
      line.append(element);
    }
    table.append(line);
  };
  add('th', ['pole', 'residue']);
  for (const row of rows) add('td', [row.pole, row.residue]);
  const wide = document.createElement('div');
  wide.className = 'wide';
  wide.append(table);
  const note = document.createElement('p');
  note.className = 'soft';
  note.textContent = `${count} poles; those with ± are pairs of conjugate ones, and so are their residues. The bold line is the curve’s parameter.`;
  element.append(box, wide, note);
}
