// SPDX-License-Identifier: MIT

import { h, svg } from './dom.js';
import { number, withUnit, words } from './format.js';
import { colourAt, css, goodness, undefinedColour, undefinedStripe } from '../model/colour.js';
import { holds } from '../model/kinds.js';

const steps = 64;

/** What the colours, and the marks if shown, mean. */
export function legend(store, palette) {
  const element = h('div', { class: 'em-legend' });
  const draw = ({ values, marks }) => {
    element.replaceChildren(...[values && colourBar(values), marks && markList(palette().holds)].filter(Boolean));
  };
  const stop = store.on(['values', 'marks'], draw);
  return { element, redraw: () => draw(store.get()), dispose: stop };
}

function colourBar(metric) {
  const bar = svg('svg', { viewBox: `0 0 ${steps} 8`, preserveAspectRatio: 'none', class: 'em-colours', 'shape-rendering': 'crispEdges', 'aria-hidden': 'true' },
    ...Array.from({ length: steps }, (_, i) => svg('rect', {
      x: i, y: 0, width: 1, height: 8, fill: css(colourAt(goodness(metric, (254 * (i + 0.5)) / steps))),
    })));
  const swatch = svg('svg', { viewBox: '0 0 16 12', class: 'em-swatch', 'aria-hidden': 'true' },
    svg('rect', { width: 16, height: 12, fill: css(undefinedColour) }),
    ...[0, 8, 16].map((x) => svg('path', { d: `M${x - 4} 12l12 -12h-4l-12 12z`, fill: css(undefinedStripe) })));
  const hasUndefined = metric.before.includes(255) || metric.after.includes(255);
  const side = (value) => withUnit(number(value, 3), metric.unit);
  return h('div', { class: 'em-legend-row' },
    h('span', { class: 'em-legend-title' }, words(metric.name), h('small', null, ` ${metric.better} is better`)),
    h('span', { class: 'em-legend-item' }, side(metric.low), bar, side(metric.high)),
    hasUndefined && h('span', { class: 'em-legend-item' }, swatch, 'inverted or without size'));
}

/** The same on a 2D canvas, for pictures that leave the page. @param style  computed, for the colours */
export function drawLegend(context, metric, { y, width, height }, style) {
  context.fillStyle = style.backgroundColor;
  context.fillRect(0, y, width, height);
  context.font = '13px system-ui, sans-serif';
  context.textBaseline = 'middle';
  const middle = y + height / 2;
  let x = 12;
  const write = (text) => {
    context.fillStyle = style.color;
    context.fillText(text, x, middle);
    x += context.measureText(text).width + 8;
  };
  write(`${words(metric.name)}, ${metric.better} is better:`);
  write(withUnit(number(metric.low, 3), metric.unit));
  for (let i = 0; i < 180; ++i) {
    context.fillStyle = css(colourAt(goodness(metric, (254 * i) / 179)));
    context.fillRect(x + i, middle - 6, 1.5, 12);
  }
  x += 188;
  write(withUnit(number(metric.high, 3), metric.unit));
}

const shapes = [
  null,
  'M2 2h8v8h-8z',
  'M6 1.5a4.5 4.5 0 1 0 .01 0z',
  'M6 1.5a4.5 4.5 0 1 0 .01 0zM6 4.2a1.8 1.8 0 1 1 -.01 0z',
  'M6 1l5 5l-5 5l-5 -5z',
  'M1.5 2.5h9l-4.5 8z',
];

function markList(colours) {
  return h('ul', { class: 'em-legend-row' }, ...shapes.map((d, hold) => d && h('li', { class: 'em-legend-item' },
    svg('svg', { viewBox: '0 0 12 12', class: 'em-swatch', 'aria-hidden': 'true' },
      svg('path', { d, fill: css(colours[hold]), class: 'em-mark-shape' })),
    holds[hold])).filter(Boolean));
}
