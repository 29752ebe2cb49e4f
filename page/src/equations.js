// The closed form: an equation a line. Where that is wider than the page, fractions are written in a line, which is broken
// between terms, and what sums are over gets a name.
import katex from 'katex';

/** The end of the group in braces that begins at `from`. */
function groupEnd(text, from) {
  let depth = 0;
  for (let k = from; k < text.length; ++k) {
    if (text[k] === '\\') ++k;
    else if (text[k] === '{') ++depth;
    else if (text[k] === '}' && --depth === 0) return k + 1;
  }
  return -1;
}

/** The end of \left( … \right) that begins at `from`. */
function bracketEnd(text, from) {
  let depth = 0;
  const marks = /\\left\b|\\right\b/g;
  marks.lastIndex = from;
  for (let mark; (mark = marks.exec(text)); ) {
    depth += mark[0] === '\\left' ? 1 : -1;
    if (depth === 0) return mark.index + '\\right)'.length;
  }
  return -1;
}

/** The lines of an align*; null where one of them is part of something that goes on. */
function lines(text) {
  const isWhole = (line) => line.split('\\begin{').length === line.split('\\end{').length;
  const list = text
    .trim()
    .replace(/^\\begin\{align\*\}|\\end\{align\*\}$/g, '')
    .split(' \\\\\n');
  return list.every(isWhole) ? list.map((line) => line.replace('&=', '=').trim()) : null;
}

/** y = Σ over q = 0 of (c) log → y = Σ over q(z) = 0 of c(z) log, q(z) = …, c(z) = …; y = \frac{a}{b} → y = (a)/(b). */
function broken(line) {
  const list = [];
  let rest = line;
  let done = '';
  let count = 0;
  const sums = line.split('\\sum_{').length - 1;
  for (;;) {
    const at = rest.indexOf('\\sum_{');
    if (at < 0) break;
    const end = groupEnd(rest, at + '\\sum_'.length);
    const over = rest.slice(at + '\\sum_{'.length, end - 1);
    if (end < 0 || !over.endsWith(' = 0')) break;
    const index = sums > 1 ? `_{${++count}}` : '';
    done += `${rest.slice(0, at)}\\sum_{q${index}(z) = 0} `;
    list.push(`q${index}(z) = ${over.slice(0, -' = 0'.length)}`);
    rest = rest.slice(end).trimStart();
    if (!rest.startsWith('\\left(')) continue;
    const close = bracketEnd(rest, 0);
    done += `c${index}(z)\\,`;
    list.push(`c${index}(z) = ${rest.slice('\\left('.length, close - '\\right)'.length)}`);
    rest = rest.slice(close);
  }
  return [done + rest, ...list].map((line) => {
    const start = line.indexOf('= \\frac{');
    if (start < 0) return line;
    const above = groupEnd(line, start + '= \\frac'.length);
    const below = groupEnd(line, above);
    if (below !== line.length) return line;
    const inside = (from, to) => `\\bigl(${line.slice(from + 1, to - 1)}\\bigr)`;
    return `${line.slice(0, start)}= ${inside(start + '= \\frac'.length, above)} \\,\\big/\\, ${inside(above, below)}`;
  });
}

const options = { throwOnError: false, strict: false, trust: false };

function render(list) {
  return list.map((line) => {
    const box = document.createElement('div');
    // A logarithm is not broken.
    const text = line.replace(/\\log\([^()]*\)/g, '{$&}');
    katex.render(`\\displaystyle ${text}`, box, options);
    return box;
  });
}

const widest = (box) => Math.max(0, ...[...box.querySelectorAll('.katex-base')].map((part) => part.offsetWidth));

/** The equations of a text in LaTeX, and what makes them fit into a width: it returns the shares by which they are too wide. */
export function equations(element, text) {
  const list = lines(text);
  const boxes = (list ?? [text]).map((line) => {
    const box = document.createElement('div');
    box.className = 'wide equation';
    element.append(box);
    if (!list) katex.render(line, box, { ...options, displayMode: true });
    return { box, line };
  });
  return (width) =>
    boxes.map(({ box, line }) => {
      if (!list) return { box, share: width / Math.max(1, box.scrollWidth) };
      box.replaceChildren(...render([line]));
      if (widest(box) > width) box.replaceChildren(...render(broken(line)));
      return { box, share: width / Math.max(1, widest(box)) };
    });
}
