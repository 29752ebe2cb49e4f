// What changes along the curve, one under the other, over one t.
import { figure, svg, ticks } from './svg.js';

const width = 460;
const height = 120;
const left = 58;
const right = 8;
const top = 20;
const bottom = 20;

/** What to show of the values: all, unless a few go far away, as next to a pole. */
function range(values) {
  const sorted = values.filter((x) => x !== null).sort((a, b) => a - b);
  if (!sorted.length) return [0, 1];
  const inner = [0.04, 0.96].map((p) => sorted[Math.floor(p * (sorted.length - 1))]);
  const spread = inner[1] - inner[0];
  let low = sorted[0];
  let high = sorted[sorted.length - 1];
  if (spread > 0 && inner[0] - low > 8 * spread) low = inner[0] - spread;
  if (spread > 0 && high - inner[1] > 8 * spread) high = inner[1] + spread;
  // What is constant but for its rounding is drawn as a constant.
  if (high - low <= 1e-9 * Math.max(Math.abs(low), Math.abs(high))) {
    const more = Math.abs(low) / 10 || 1;
    return [low - more, high + more];
  }
  return [low, high];
}

export function drawPlots(element, plots, rows, column, moveTo) {
  const t = rows.map((row) => row[column.t]);
  const x = (value) =>
    left + ((value - t[0]) / (t[t.length - 1] - t[0] || 1)) * (width - left - right);
  const marks = plots.map((plot) => {
    const values = rows.map((row) => row[column[plot.column]]);
    const [low, high] = range(values);
    const y = (value) => top + ((high - value) / (high - low)) * (height - top - bottom);
    let line = '';
    let pen = 'M';
    values.forEach((value, k) => {
      if (value === null || value < low - (high - low) || value > high + (high - low)) pen = 'M';
      else {
        line += `${pen}${x(t[k]).toFixed(2)} ${y(value).toFixed(2)}`;
        pen = 'L';
      }
    });
    const id = `clip-${plot.column}`;
    const text = (label, attributes) =>
      svg('text', { fill: 'currentColor', 'font-size': 11, ...attributes }, [label]);
    const mark = svg('line', { y1: top, y2: height - bottom, stroke: '#d1495b' });
    const dot = svg('circle', { r: 3.5, fill: '#d1495b' });
    const drawing = svg(
      'svg',
      {
        viewBox: `0 0 ${width} ${height}`,
        role: 'img',
        'aria-label': `${plot.label} (${plot.what}) for t from ${t[0]} to ${t[t.length - 1]}`,
      },
      [
        svg('clipPath', { id }, [
          svg('rect', { x: left, y: top - 2, width: width - left - right, height: height - top - bottom + 4 }),
        ]),
        text(`${plot.label}   ${plot.what}`, { x: left, y: 12 }),
        ...ticks(low, high, 3).map((value) =>
          svg('g', {}, [
            svg('line', { x1: left, x2: width - right, y1: y(value), y2: y(value), stroke: 'currentColor', 'stroke-opacity': 0.15 }),
            text(String(value), { x: left - 5, y: y(value) + 4, 'text-anchor': 'end' }),
          ]),
        ),
        ...ticks(t[0], t[t.length - 1], 5).map((value) =>
          // Not beyond the edge, where it would be cut.
          text(String(value), { x: x(value), y: height - 5, 'text-anchor': width - x(value) < 20 ? 'end' : 'middle' }),
        ),
        svg('path', { d: line, fill: 'none', stroke: 'currentColor', 'stroke-width': 1.5, 'clip-path': `url(#${id})` }),
        mark,
        dot,
      ],
    );
    const go = (event) => {
      const box = drawing.getBoundingClientRect();
      const at = ((event.clientX - box.left) / box.width) * width;
      let nearest = 0;
      t.forEach((value, k) => {
        if (Math.abs(x(value) - at) < Math.abs(x(t[nearest]) - at)) nearest = k;
      });
      moveTo(nearest);
    };
    drawing.addEventListener('pointerdown', go);
    drawing.addEventListener('pointermove', (event) => event.buttons && go(event));
    element.append(figure(drawing, plot.column));
    return (k) => {
      mark.setAttribute('x1', x(t[k]));
      mark.setAttribute('x2', x(t[k]));
      dot.setAttribute('visibility', values[k] === null ? 'hidden' : 'visible');
      dot.setAttribute('cx', x(t[k]));
      dot.setAttribute('cy', values[k] === null ? 0 : Math.max(top, Math.min(height - bottom, y(values[k]))));
    };
  });
  return (k) => marks.forEach((mark) => mark(k));
}
