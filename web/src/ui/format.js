// SPDX-License-Identifier: MIT

/** A number with about four significant digits; null is infinite, NaN and undefined are a dash. */
export function number(value, digits = 4) {
  if (value === null || value === Infinity) return '∞';
  if (value === undefined || Number.isNaN(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) {
    const [mantissa, exponent] = value.toExponential(digits - 2).split('e');
    return `${Number(mantissa)}e${Number(exponent)}`.replaceAll('-', '−');
  }
  const places = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return String(Number(value.toFixed(Math.min(places, 6)))).replace('-', '−');
}

export const count = (value) => value.toLocaleString('en-US');

/** shape, min_angle: as read by people. */
export const words = (name) => name.replaceAll('_', ' ');

export const withUnit = (text, unit) => (unit ? `${text}${unit === '°' ? '' : ' '}${unit}` : text);
