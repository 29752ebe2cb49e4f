// SVG of our own, small enough to be saved with its style in it.
const space = 'http://www.w3.org/2000/svg';

/** Of what is marked, on light and on dark paper. */
export const accent = '#d1495b';

export function svg(name, attributes = {}, children = []) {
  const element = document.createElementNS(space, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

/** The multiples in [low, high] of the greatest 1, 2 or 5 times a power of ten that has `fewest` there. */
export function ticks(low, high, fewest) {
  const width = high - low;
  if (!(width > 0) || !Number.isFinite(width)) return [low];
  let exponent = Math.ceil(Math.log10(width));
  for (;;) {
    for (const digit of [5, 2, 1]) {
      const step = digit * 10 ** exponent;
      const first = Math.ceil(low / step - 1e-9);
      const last = Math.floor(high / step + 1e-9);
      if (last - first + 1 < fewest) continue;
      const digits = Math.ceil(Math.log10(Math.max(Math.abs(low), Math.abs(high)) / step)) + 2;
      return Array.from({ length: last - first + 1 }, (_, k) =>
        Number(((first + k) * step).toPrecision(Math.min(15, Math.max(2, digits)))),
      );
    }
    --exponent;
  }
}

let pen = null;
/** How wide a text is in the font of the drawings. */
export function textWidth(text, size) {
  pen ??= document.createElement('canvas').getContext('2d');
  pen.font = `${size}px system-ui, sans-serif`;
  return pen.measureText(text).width;
}

/** A figure with its caption and a button that saves it, in the colours that it has now. */
export function figure(caption, name, current) {
  const box = document.createElement('figure');
  const head = document.createElement('figcaption');
  const title = document.createElement('span');
  title.append(...caption);
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = 'SVG';
  button.setAttribute('aria-label', `save ${name}.svg`);
  button.addEventListener('click', () => {
    const drawing = current();
    const copy = drawing.cloneNode(true);
    const [, , width, height] = drawing.getAttribute('viewBox').split(' ').map(Number);
    copy.setAttribute('viewBox', `0 -18 ${width} ${height + 18}`);
    copy.append(svg('text', { x: 4, y: -5, 'font-size': 12, fill: 'currentColor' }, [title.innerText]));
    copy.setAttribute('xmlns', space);
    const style = getComputedStyle(drawing);
    copy.setAttribute('style', `color: ${style.color}; font-family: sans-serif`);
    const text = new XMLSerializer().serializeToString(copy);
    const link = document.createElement('a');
    link.download = `${name}.svg`;
    link.href = URL.createObjectURL(new Blob([text], { type: 'image/svg+xml' }));
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  });
  head.append(title, button);
  box.append(head);
  return box;
}
