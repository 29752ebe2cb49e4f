// SVG of our own, small enough to be saved with its style in it.
const space = 'http://www.w3.org/2000/svg';

export function svg(name, attributes = {}, children = []) {
  const element = document.createElementNS(space, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

/** Steps of 1, 2 or 5 times a power of ten, about `count` of them within [low, high]. */
export function ticks(low, high, count) {
  const rough = (high - low) / count;
  if (!(rough > 0) || !Number.isFinite(rough)) return [low];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].find((x) => x * power >= rough * 0.999) * power;
  const list = [];
  for (let k = Math.ceil(low / step); k * step <= high + step * 1e-9; ++k)
    list.push(Number((k * step).toPrecision(12)));
  return list;
}

/** A figure with a button that saves it, in the colours that it has now. */
export function figure(drawing, name) {
  const box = document.createElement('figure');
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = 'SVG';
  button.setAttribute('aria-label', `save ${name}.svg`);
  button.addEventListener('click', () => {
    const copy = drawing.cloneNode(true);
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
  box.append(drawing, button);
  return box;
}
