// What changes along the curve, one under the other, over one t.
import { accent, figure, svg, textWidth, ticks } from './svg.js';
import { brief } from './text.js';

const height = 124;
const right = 10;
const top = 8;
const bottom = 20;
const size = 11;

/** What to show of the values: all, unless a few go far away, as next to a pole. Each weighs as much as the t it stands for. */
function range(values, t) {
  const weights = t.map((_, k) => (t[Math.min(k + 1, t.length - 1)] - t[Math.max(k - 1, 0)]) / 2);
  const sorted = values
    .map((value, k) => ({ value, weight: weights[k] }))
    .filter(({ value }) => value !== null)
    .sort((a, b) => a.value - b.value);
  if (!sorted.length) return [0, 1];
  const total = sorted.reduce((sum, { weight }) => sum + weight, 0);
  const quantile = (share) => {
    let sum = 0;
    return (sorted.find(({ weight }) => (sum += weight) >= share * total) ?? sorted.at(-1)).value;
  };
  const inner = [quantile(0.04), quantile(0.96)];
  const spread = inner[1] - inner[0];
  let low = sorted[0].value;
  let high = sorted.at(-1).value;
  if (spread > 0 && inner[0] - low > 8 * spread) low = inner[0] - spread;
  if (spread > 0 && high - inner[1] > 8 * spread) high = inner[1] + spread;
  // What is constant but for its rounding is drawn as a constant.
  if (high - low <= 1e-9 * Math.max(Math.abs(low), Math.abs(high)) || high === low) {
    const more = Math.abs(low) / 4 || 1;
    return [low - more, high + more];
  }
  const air = 0.04 * (high - low);
  return [low - air, high + air];
}

/** How far the values go, and where. */
function extremes(plot, values, t, [low, high]) {
  const known = values.map((value, k) => ({ value, k })).filter(({ value }) => value !== null);
  if (!known.length) return '';
  const least = known.reduce((a, b) => (b.value < a.value ? b : a));
  const greatest = known.reduce((a, b) => (b.value > a.value ? b : a));
  if (plot.infinite) return 'infinite at a pole, which the line leaves the plot for';
  if (least.value === greatest.value) return `always ${brief(least.value, 6)}`;
  const at = ({ value, k }) => `${brief(value, 6)} at t = ${brief(t[k], 4)}`;
  const leaves = least.value < low || greatest.value > high ? '; the line leaves the plot' : '';
  return `${at(least)} … ${at(greatest)}${leaves}`;
}

/** The values with, at a joint, the limit from the left first where that is another: {k, value}. */
function points(plot, values, jumps) {
  const list = [];
  values.forEach((value, k) => {
    const before = jumps.get(k);
    if (before && plot.column in before) {
      list.push({ k, value: before[plot.column] });
      list.push(null);
    }
    list.push({ k, value });
  });
  return list;
}

function drawing(plot, { values, t, shown, list, isSparse }, width) {
  const [low, high] = shown;
  const size11 = (label, attributes) => svg('text', { fill: 'currentColor', 'font-size': size, ...attributes }, [label]);
  const y = (value) => top + ((high - value) / (high - low)) * (height - top - bottom);
  const marks = ticks(low, high, 3).map((value) => ({ value, label: label(value, low, high) }));
  const left = Math.ceil(Math.max(24, ...marks.map((mark) => textWidth(mark.label, size)))) + 9;
  const x = (value) => left + ((value - t[0]) / (t.at(-1) - t[0] || 1)) * (width - left - right);
  let line = '';
  let pen = 'M';
  for (const point of list) {
    if (!point) pen = 'M';
    else if (point.value === null) pen = isSparse ? pen : 'M';
    else {
      // Far beyond the edge numbers are too large for the renderer.
      const inside = Math.max(low - 2 * (high - low), Math.min(high + 2 * (high - low), point.value));
      line += `${pen}${x(t[point.k]).toFixed(2)} ${y(inside).toFixed(2)}`;
      pen = 'L';
    }
  }
  const id = `clip-${plot.column}`;
  const mark = svg('line', { y1: top, y2: height - bottom, stroke: accent });
  const dot = svg('circle', { r: 3.5, fill: accent });
  const along = ticks(t[0], t.at(-1), 4);
  const image = svg(
    'svg',
    {
      viewBox: `0 0 ${width} ${height}`,
      role: 'img',
      'aria-label': `${plot.label} (${plot.what}) for t from ${t[0]} to ${t.at(-1)}`,
    },
    [
      svg('clipPath', { id }, [
        svg('rect', { x: left, y: top - 2, width: width - left - right, height: height - top - bottom + 4 }),
      ]),
      ...marks.map(({ value, label }) =>
        svg('g', { class: 'tick' }, [
          svg('line', { x1: left, x2: width - right, y1: y(value), y2: y(value), stroke: 'currentColor', 'stroke-opacity': 0.2 }),
          size11(label, { x: left - 5, y: y(value) + 4, 'text-anchor': 'end' }),
        ]),
      ),
      ...along.map((value) => {
        const text = brief(value, 6);
        const half = textWidth(text, size) / 2;
        return size11(text, { x: Math.min(x(value), width - half - 1), y: height - 5, 'text-anchor': 'middle', class: 'along' });
      }),
      svg('path', { d: line, fill: 'none', stroke: 'currentColor', 'stroke-width': 1.5, 'clip-path': `url(#${id})` }),
      ...(isSparse ? list.filter((point) => point && point.value !== null).map((point) => svg('circle', { r: 1.8, cx: x(t[point.k]), cy: y(point.value), fill: 'currentColor' })) : []),
      mark,
      dot,
    ],
  );
  const show = (k) => {
    mark.setAttribute('x1', x(t[k]));
    mark.setAttribute('x2', x(t[k]));
    dot.setAttribute('visibility', values[k] === null ? 'hidden' : 'visible');
    dot.setAttribute('cx', x(t[k]));
    dot.setAttribute('cy', values[k] === null ? 0 : Math.max(top, Math.min(height - bottom, y(values[k]))));
  };
  return { image, show, x };
}

/** A tick in as many digits as tell it from its neighbours. */
function label(value, low, high) {
  const most = Math.max(Math.abs(low), Math.abs(high));
  const digits = Math.ceil(Math.log10(most / (high - low))) + 3;
  return brief(value, Math.min(15, Math.max(3, digits)));
}

export function drawPlots(element, plots, rows, column, jumps, moveTo) {
  const t = rows.map((row) => row[column.t]);
  const nearest = (x, at) => {
    let best = 0;
    t.forEach((value, k) => {
      if (Math.abs(x(value) - at) < Math.abs(x(t[best]) - at)) best = k;
    });
    return best;
  };
  let current = 0;
  const shows = plots.map((plot) => {
    const values = rows.map((row) => row[column[plot.column]]);
    const isSparse = plot.column === 'error';
    const data = { values, t, shown: range(values, t), list: points(plot, values, jumps), isSparse };
    const name = document.createElement('b');
    name.textContent = plot.label;
    const soft = document.createElement('small');
    soft.textContent = extremes(plot, values, t, data.shown);
    let drawn;
    const box = figure([name, ` ${plot.what} `, soft], plot.column, () => drawn.image);
    let width = 0;
    const draw = (next) => {
      if (next === width || next < 60) return;
      width = next;
      const before = drawn;
      drawn = drawing(plot, data, width);
      before ? before.image.replaceWith(drawn.image) : box.append(drawn.image);
      drawn.show(current);
    };
    element.append(box);
    draw(Math.round(box.clientWidth) || 460);
    new ResizeObserver(() => draw(Math.round(box.clientWidth))).observe(box);
    const go = (event) => {
      const frame = drawn.image.getBoundingClientRect();
      moveTo(nearest(drawn.x, ((event.clientX - frame.left) / frame.width) * width));
    };
    box.addEventListener('pointerdown', (event) => {
      if (!drawn.image.contains(event.target)) return;
      box.setPointerCapture(event.pointerId);
      go(event);
    });
    box.addEventListener('pointermove', (event) => box.hasPointerCapture(event.pointerId) && go(event));
    return (k) => drawn.show(k);
  });
  return (k) => {
    current = k;
    shows.forEach((show) => show(k));
  };
}
