// Numbers and texts as they are shown.

const missing = '–';

/** All hyphens of a number are minus signs: −1.5e−7. */
export const written = (x) => (x === null || x === undefined ? missing : String(x).replaceAll('-', '−'));

/** In a text those before digits that follow no word, as in "−1/2", and those of exponents. */
export const typeset = (text) =>
  text.replace(/(?<![\p{L}\p{N}_-])-(?=[\d.])/gu, '−').replace(/(?<=\d[eE])-(?=\d)/g, '−');

const superscripts = [...'⁰¹²³⁴⁵⁶⁷⁸⁹'];

/** A few digits of a number, along an axis or in a sentence: 0.25, 6.4·10⁸. */
export function brief(x, digits = 4) {
  if (x === 0) return '0';
  const size = Math.abs(x);
  if (size < 1e5 && size >= 1e-3) return written(Number(x.toPrecision(digits)));
  const [mantissa, exponent] = x.toExponential(digits - 1).split('e');
  const power = [...String(Number(exponent))].map((c) => (c === '-' ? '⁻' : superscripts[c])).join('');
  const factor = Number(mantissa);
  const sign = factor < 0 ? '−' : '';
  return Math.abs(factor) === 1 ? `${sign}10${power}` : `${written(factor)}·10${power}`;
}
