// SPDX-License-Identifier: MIT

import { h } from './dom.js';

/** Colours that the picture needs, in bytes; the page has its own in report.css. */
const palettes = {
  light: {
    canvas: [247, 248, 250], edge: [22, 28, 38], faded: [222, 226, 232], plain: [150, 170, 196], rim: [255, 255, 255],
    feature: [10, 14, 22], arrow: [214, 72, 4],
    holds: [[0, 0, 0], [30, 36, 48], [0, 98, 196], [0, 98, 196], [124, 58, 190], [201, 78, 0]],
  },
  dark: {
    canvas: [20, 23, 29], edge: [8, 10, 14], faded: [58, 64, 75], plain: [104, 124, 152], rim: [255, 255, 255],
    feature: [232, 236, 242], arrow: [255, 146, 60],
    holds: [[0, 0, 0], [30, 36, 48], [0, 98, 196], [0, 98, 196], [124, 58, 190], [201, 78, 0]],
  },
};

/**
 * Light or dark, as the system says until someone chooses.
 * @param changed  called with the palette, now and at every change
 */
export function makeTheme(root, changed) {
  const system = matchMedia('(prefers-color-scheme: dark)');
  let chosen = null;
  const name = () => chosen ?? (system.matches ? 'dark' : 'light');
  const button = h('button', { type: 'button', class: 'em-button', onclick: () => {
    chosen = name() === 'dark' ? 'light' : 'dark';
    apply();
  } });
  const apply = () => {
    root.dataset.theme = name();
    button.textContent = name() === 'dark' ? 'Light' : 'Dark';
    button.title = `Change to ${name() === 'dark' ? 'light' : 'dark'} colours (T)`;
    changed(palettes[name()]);
  };
  system.addEventListener('change', apply);
  const css = (property) => getComputedStyle(root).getPropertyValue(property).trim();
  return {
    button,
    apply,
    name,
    /** Colours of charts. */
    chart: () => ({ accent: css('--accent'), muted: css('--muted'), grid: css('--grid') }),
    palette: () => palettes[name()],
    dispose: () => system.removeEventListener('change', apply),
  };
}
