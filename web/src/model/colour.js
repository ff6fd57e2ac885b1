// SPDX-License-Identifier: MIT

// Viridis by polynomials in t, red, green and blue, lowest power first (fit by Matt Zucker, public domain).
const powers = [
  [0.2777273272234177, 0.1050930431085774, -0.3308618287255563, -4.634230498983486, 6.228269936347081,
    4.776384997670288, -5.435455855934631],
  [0.005407344544966578, 1.404613529898575, 0.214847559468213, -5.799100973351585, 14.17993336680509,
    -13.74514537774601, 4.645852612178535],
  [0.3340998053353061, 1.384590162594685, 0.09509516302823659, -19.33244095627987, 56.69055260068105,
    -65.35303263337234, 26.3124352495832],
];

/** Colour of a place between worst (0, dark) and best (1, bright) as three bytes. */
export function colourAt(t) {
  const x = Math.min(1, Math.max(0, t));
  return powers.map((c) => {
    const value = c.reduceRight((sum, coefficient) => sum * x + coefficient, 0);
    return Math.round(255 * Math.min(1, Math.max(0, value)));
  });
}

/** Of cells that have no value: inverted, or without size. They are hatched as well. */
export const undefinedColour = [226, 26, 108];
export const undefinedStripe = [150, 0, 66];

export const css = ([r, g, b]) => `rgb(${r}, ${g}, ${b})`;

/** 256 colours from worst to best, RGBA. */
export function colourTable() {
  const table = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; ++i) table.set([...colourAt(i / 255), 255], 4 * i);
  return table;
}

/** Place between worst and best of a byte. */
export function goodness(metric, byte) {
  return metric.better === 'lower' ? 1 - byte / 254 : byte / 254;
}
