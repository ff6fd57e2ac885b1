// SPDX-License-Identifier: MIT

import { h, segments, svg } from './dom.js';
import { count, number, withUnit, words } from './format.js';
import { barCount, bytesPerBar, histogram } from '../model/histogram.js';
import { colourAt, css, goodness, undefinedColour } from '../model/colour.js';
import { valueOfByte } from '../model/mesh.js';

const width = 320, height = 132;
const plot = { left: 34, right: 8, top: 8, bottom: 22 };
const barWidth = (width - plot.left - plot.right) / (barCount + 2);  // two more: a gap and the bar of those without value

/**
 * Number of cells per value, before as a line and after as bars in the colours of the picture.
 * Dragging over it sets the range of values that is shown.
 */
export function histogramPanel(store) {
  const chart = svg('svg', { viewBox: `0 0 ${width} ${height}`, class: 'em-histogram', role: 'img' });
  const low = rangeInput('Least value shown', () => takeInputs());
  const high = rangeInput('Greatest value shown', () => takeInputs());
  const reset = h('button', { type: 'button', class: 'em-button', onclick: () => store.set({ range: null }) }, 'Reset');
  const whose = segments('Values that the range applies to', [
    ['before', 'before', 'Filter by the values before'], ['after', 'after', 'Filter by the values after'],
  ], (rangeOf) => store.set({ rangeOf }));
  const shownCount = h('output', { class: 'em-hint em-count' });
  const element = h('div', null, chart,
    h('div', { class: 'em-row' }, low, h('span', { 'aria-hidden': 'true' }, '–'), high,
      store.get().rangeOf === 'after' ? whose.element : null),
    h('div', { class: 'em-row em-spread' }, shownCount, reset));

  let brush;
  const both = store.get().rangeOf === 'after';
  const redraw = () => {
    const { values, range } = store.get();
    if (!values) return chart.replaceChildren();
    drawChart(chart, values, both);
    brush = makeBrush(chart, values, range, (next) => store.set({ range: next }));
  };

  function takeInputs() {
    const { values: metric } = store.get();
    if (!metric) return;
    const byte = (input) => ((input.valueAsNumber - metric.low) / (metric.high - metric.low || 1)) * 254;
    const lowest = metric.better === 'lower' ? 0 : -1;
    const highest = metric.better === 'lower' ? 255 : 254;
    const from = Number.isNaN(low.valueAsNumber) || byte(low) <= 0 ? lowest : Math.ceil(byte(low) - 1e-6);
    const to = Number.isNaN(high.valueAsNumber) || byte(high) >= 254 ? highest : Math.floor(byte(high) + 1e-6);
    store.set({ range: from <= lowest && to >= highest ? null : [from, to] });
  }

  const unsubscribe = [
    store.on(['values'], redraw),
    store.on(['range', 'values', 'rangeOf'], ({ range, rangeOf, values }) => {
      brush?.show(range);
      reset.disabled = !range;
      whose.set(rangeOf);
      for (const [input, i] of [[low, 0], [high, 1]]) {
        const inside = range && values && range[i] >= 0 && range[i] <= 254;
        input.value = inside ? Number(valueOfByte(values, range[i]).toPrecision(3)) : '';
        if (values) input.placeholder = number(i === 0 ? values.low : values.high, 3);
      }
    }),
    store.on(['visible'], ({ visible }) => {
      shownCount.textContent = visible ? `${count(visible.count)} of ${count(visible.of.length)} cells shown` : '';
    }),
  ];
  return { element, dispose: () => unsubscribe.forEach((stop) => stop()) };
}

function rangeInput(label, onchange) {
  return h('input', { type: 'number', step: 'any', class: 'em-range', 'aria-label': label, onchange });
}

/** Left edge of the bar of a rank: those without value stand apart beyond the worst end. */
function xOfBar(metric, bar) {
  const shift = metric.better === 'lower' ? 0 : 2;
  return plot.left + barWidth * (bar + shift);
}
const xOfUndefined = (metric) => plot.left + (metric.better === 'lower' ? barWidth * (barCount + 1) : 0);

function drawChart(chart, metric, both) {
  const before = histogram(metric.before);
  const after = histogram(metric.after);
  const most = Math.max(1, ...before.bars, ...after.bars, before.undefinedCount, after.undefinedCount);
  // Logarithmic, or the few bad cells that matter could not be seen.
  const decades = Math.log10(most + 1);
  const base = height - plot.bottom;
  const y = (n) => base - ((base - plot.top) * Math.log10(n + 1)) / decades;
  const parts = [];
  for (let n = 1; n <= most; n *= 10) {
    parts.push(
      svg('line', { x1: plot.left, x2: width - plot.right, y1: y(n), y2: y(n), class: 'em-grid' }),
      svg('text', { x: plot.left - 5, y: y(n) + 3.5, class: 'em-tick em-end' }, shortCount(n)));
  }
  after.bars.forEach((n, bar) => {
    if (n > 0) parts.push(barOf(xOfBar(metric, bar), y(n), base, css(colourAt(goodness(metric, bar * bytesPerBar + 2)))));
  });
  if (after.undefinedCount > 0) {
    parts.push(barOf(xOfUndefined(metric), y(after.undefinedCount), base, css(undefinedColour)));
  }
  if (both) {
    const d = before.bars.reduce((path, n, bar) => `${path}V${y(n)}h${barWidth}`, `M${xOfBar(metric, 0)} ${base}`);
    parts.push(svg('path', { d: `${d}V${base}`, class: 'em-before-line' }));
    if (before.undefinedCount > 0) {
      parts.push(svg('path', { d: `M${xOfUndefined(metric)} ${base}V${y(before.undefinedCount)}h${barWidth}V${base}`, class: 'em-before-line' }));
    }
  }
  parts.push(svg('line', { x1: plot.left, x2: width - plot.right, y1: base, y2: base, class: 'em-base' }));
  for (const [at, place, anchor] of [[metric.low, 0, 'em-start'], [(metric.low + metric.high) / 2, 0.5, 'em-middle'], [metric.high, 1, 'em-end']]) {
    parts.push(svg('text', { x: xOfBar(metric, place * barCount), y: height - 7, class: `em-tick ${anchor}` },
      withUnit(number(at, 3), metric.unit)));
  }
  chart.setAttribute('aria-label', `Number of cells by ${words(metric.name)}, logarithmic` +
    `${both ? ': before as a line, after as bars' : ''}. Drag to show a range only.`);
  chart.replaceChildren(...parts);
}

const barOf = (x, top, base, fill) =>
  svg('rect', { x: x + 0.4, y: top, width: barWidth - 0.8, height: base - top, fill });

const shortCount = (n) => (n >= 1e6 ? `${n / 1e6}M` : n >= 1e3 ? `${n / 1e3}k` : n);

/** Shades what is outside the range, and makes a range of a drag. */
function makeBrush(chart, metric, range, choose) {
  const lower = metric.better === 'lower';
  const lowest = lower ? 0 : -1;
  const highest = lower ? 255 : 254;
  const base = height - plot.bottom;
  const shade = () => svg('rect', { y: 0, height: base, width: 0, class: 'em-shade' });
  const left = shade();
  const right = shade();
  chart.append(left, right);

  const barAt = (event) => {
    const box = chart.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * width;
    return Math.floor((x - xOfBar(metric, 0)) / barWidth);
  };
  const toRange = (a, b) => {
    const from = Math.min(a, b);
    const to = Math.max(a, b);
    const low = from < 0 ? lowest : Math.min(from, barCount - 1) * bytesPerBar;
    const high = to >= barCount ? highest : Math.max(0, to) * bytesPerBar + bytesPerBar - 1;
    if (lower && from >= barCount) return [255, 255];
    if (!lower && to < 0) return [-1, -1];
    return [low, Math.min(high, highest)];
  };
  let start = null;
  chart.onpointerdown = (event) => {
    chart.setPointerCapture(event.pointerId);
    start = { bar: barAt(event), x: event.clientX };
  };
  chart.onpointermove = (event) => {
    if (start && Math.abs(event.clientX - start.x) > 3) choose(toRange(start.bar, barAt(event)));
  };
  chart.onpointerup = (event) => {
    if (start && Math.abs(event.clientX - start.x) <= 3) choose(toRange(start.bar, start.bar));
    start = null;
  };
  const x = (rank, upper) => {
    if (rank < 0) return upper ? xOfUndefined(metric) + barWidth : 0;
    if (rank > 254) return upper ? width : xOfUndefined(metric);
    return xOfBar(metric, (rank + (upper ? 1 : 0)) / bytesPerBar);
  };
  const show = (now) => {
    const from = now ? x(now[0], false) : 0;
    const to = now ? (now[1] === highest ? width : x(now[1], true)) : width;
    left.setAttribute('width', Math.max(0, from));
    right.setAttribute('x', to);
    right.setAttribute('width', Math.max(0, width - to));
  };
  show(range);
  return { show };
}
