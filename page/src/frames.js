// How each frame is drawn. Pairs of colours differ for eyes without one kind of cones, too, and each stands out on the paper
// (tests/page computes both); the lines differ where there is no colour.

/** By the name of the frame's second vector in the table; widths and dashes in hundredths of the picture. Of two ribbons that coincide the wider one shows its edge. */
export const styles = {
  f2: { width: 16, light: '#0048b8', dark: '#2f80ff', dash: null },
  e2: { width: 13, light: '#9a72dc', dark: '#cbb8ff', dash: [6, 3] },
  up2: { width: 13, light: '#9a72dc', dark: '#cbb8ff', dash: [6, 3] },
  n: { width: 14.5, light: '#55585e', dark: '#c9ccd2', dash: [1, 2] },
  exact_mtf2: { width: 11.5, light: '#b07400', dark: '#ffd24a', dash: [10, 2] },
  g2: { width: 10, light: '#8f1d0a', dark: '#e8613c', dash: [3, 2] },
};

/** 1, 2 or 5 times a power of ten that makes errors of at most `worst` radians plain to see; 1 where they are. */
export function magnification(worst) {
  if (!(worst > 1e-12) || worst > 0.4) return 1;
  const most = 0.8 / worst;
  const power = 10 ** Math.floor(Math.log10(most));
  return [5, 2, 1].find((x) => x * power <= most) * power;
}

/** cos(angle)·a + sin(angle)·b. */
export const turned = (a, b, angle) =>
  a && b ? a.map((x, k) => Math.cos(angle) * x + Math.sin(angle) * b[k]) : null;
