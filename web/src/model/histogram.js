// SPDX-License-Identifier: MIT

/** Bytes per bar: 255 values make 51 bars. */
export const bytesPerBar = 5;
export const barCount = 51;

/**
 * Where a byte stands between worst and best: undefined counts as beyond the worst end.
 * Ranges of values are kept in these ranks, -1 to 255.
 */
export const rankOfByte = (metric, byte) => (byte !== 255 ? byte : metric.better === 'lower' ? 255 : -1);

/** Number of cells per bar, and of those without a value. */
export function histogram(values) {
  const bars = new Float64Array(barCount);
  let undefinedCount = 0;
  for (let i = 0; i < values.length; ++i) {
    if (values[i] === 255) ++undefinedCount;
    else ++bars[(values[i] / bytesPerBar) | 0];
  }
  return { bars, undefinedCount };
}

/**
 * The range of ranks [low, high] that holds the worst `share` of all cells, and no fewer. Cells of
 * equal byte stay together.
 */
export function worstRange(metric, values, share) {
  const counts = new Float64Array(256);
  for (let i = 0; i < values.length; ++i) ++counts[values[i]];
  let left = share * values.length - counts[255];
  if (metric.better === 'lower') {
    let low = 255;
    while (left > 0 && low > 0) left -= counts[--low];
    return [low, 255];
  }
  let high = -1;
  while (left > 0 && high < 254) left -= counts[++high];
  return [-1, high];
}
