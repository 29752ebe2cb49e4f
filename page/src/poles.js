// The poles of θ′ in the complex plane, with [0, 1] among them, and their residues in a table.
import { figure, svg, ticks } from './svg.js';

const side = 300;
const edge = 28;

export function drawPoles(element, { rows, count, end }) {
  const numbers = rows.map((row) => ({ re: Number(row.re), im: Number(row.im) }));
  const reach = Math.max(
    end / 2,
    ...numbers.map(({ re, im }) => Math.max(Math.abs(re - end / 2), Math.abs(im))),
  );
  const low = end / 2 - 1.1 * reach;
  const high = end / 2 + 1.1 * reach;
  const x = (re) => edge + ((re - low) / (high - low)) * (side - 2 * edge);
  const y = (im) => side / 2 - (im / (high - low)) * (side - 2 * edge);
  const text = (label, attributes) =>
    svg('text', { fill: 'currentColor', 'font-size': 10, ...attributes }, [label]);
  const cross = (re, im) =>
    svg('path', {
      d: `M${x(re) - 4} ${y(im) - 4}l8 8m0 -8l-8 8`,
      stroke: '#d1495b',
      'stroke-width': 1.6,
    });
  const drawing = svg('svg', { viewBox: `0 0 ${side} ${side}`, role: 'img', 'aria-label': 'the poles in the complex plane' }, [
    svg('line', { x1: edge, x2: side - edge, y1: y(0), y2: y(0), stroke: 'currentColor', 'stroke-opacity': 0.4 }),
    svg('line', { x1: x(0), x2: x(end), y1: y(0), y2: y(0), stroke: 'currentColor', 'stroke-width': 3 }),
    ...ticks(low, high, 4).map((re) => text(String(re), { x: x(re), y: side - 8, 'text-anchor': 'middle' })),
    ...ticks(low - end / 2, high - end / 2, 4).map((im) => text(im === 0 ? '0' : `${im}i`, { x: 2, y: y(im) + 3 })),
    ...numbers.flatMap(({ re, im }) => (im === 0 ? [cross(re, 0)] : [cross(re, im), cross(re, -im)])),
  ]);
  const box = figure(drawing, 'poles');
  box.style.maxWidth = '22rem';
  const table = document.createElement('table');
  const add = (name, cells) => {
    const line = document.createElement('tr');
    for (const cell of cells) {
      const element = document.createElement(name);
      element.textContent = cell;
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
  note.textContent = `${count} poles; those with ± are pairs of conjugate ones, and so are their residues. The bold line is the curve's parameter.`;
  element.append(box, wide, note);
}
