// SPDX-License-Identifier: MIT

import uPlot from 'uplot';
import { h } from './dom.js';
import { number } from './format.js';

const curves = [
  { key: 'cost', title: 'Cost', log: true },
  { key: 'max_move', title: 'Largest move', log: true },
  { key: 'gradient', title: 'Gradient', log: true },
  { key: 'worst', title: 'Worst quality', log: false },
  { key: 'inverted', title: 'Inverted cells', log: false },
];

/** Curves over the iterations, one small chart each, with one cursor for all. */
export function convergence(history, theme) {
  if (!(history?.length > 1)) return null;
  const steps = history.map(({ iteration }, i) => iteration ?? i);
  const charts = curves.map((curve) => chart(curve, steps, history, theme)).filter(Boolean);
  if (charts.length === 0) return null;
  const element = h('section', { class: 'em-card em-wide' },
    h('h2', null, 'Convergence'),
    changes(history).length > 0 && h('p', { class: 'em-hint' },
      'Dashed: the cost itself changed there (penalties or multipliers); compare it only between two such lines.'),
    h('div', { class: 'em-charts' }, ...charts.map(({ element: chartElement }) => chartElement)));
  const sizes = new ResizeObserver(() => { for (const { resize } of charts) resize(); });
  for (const { element: chartElement } of charts) sizes.observe(chartElement);
  return { element, redraw: () => charts.forEach(({ redraw }) => redraw()), dispose: () => sizes.disconnect() };
}

/** Iterations at which the function that is minimised changed. */
function changes(history) {
  return history.filter((entry, i) => i > 0 && entry.function !== history[i - 1].function)
    .map(({ iteration }) => iteration);
}

function chart({ key, title, log }, steps, history, theme) {
  const raw = history.map((entry) => entry[key]);
  if (!raw.some((value) => Number.isFinite(value)) || (key === 'inverted' && raw.every((value) => !value))) return null;
  const logarithmic = log && raw.some((value) => value > 0);
  const values = raw.map((value) => (Number.isFinite(value) && (!logarithmic || value > 0) ? value : null));

  const reading = h('output', { class: 'em-reading' });
  const read = (i) => {
    reading.textContent = i === null || i === undefined ? '' : `${number(raw[i])} at ${steps[i]}`;
  };
  const holder = h('div', { class: 'em-chart', role: 'img', 'aria-label':
    `${title} over ${history.length - 1} iterations: from ${number(raw[0])} to ${number(raw.at(-1))}` });
  const element = h('figure', null,
    h('figcaption', null, title, h('small', null, logarithmic ? ' (log)' : ''), reading), holder);

  const axis = {
    stroke: () => theme().muted, grid: { stroke: () => theme().grid, width: 1 }, ticks: { stroke: () => theme().grid, width: 1 },
    font: '12px system-ui, sans-serif',
  };
  let plot;
  const make = () => {
    plot = new uPlot({
      width: holder.clientWidth || 320,
      height: 170,
      legend: { show: false },
      cursor: { sync: { key: 'evenmesh' }, drag: { x: false, y: false }, points: { size: 7 } },
      scales: {
        x: { time: false },
        y: logarithmic ? { distr: 3, log: 10, range: roundRange } : { range: { min: { pad: 0.1, soft: 0, mode: 1 }, max: { pad: 0.1 } } },
      },
      axes: [
        { ...axis, incrs: [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000], size: 34 },
        { ...axis, size: 62, values: (_, ticks) => ticks.map((tick) => (tick === null ? '' : number(tick, 3))) },
      ],
      series: [{}, {
        stroke: () => theme().accent, width: 2, spanGaps: true,
        points: { show: history.length <= 40, size: 5, fill: () => theme().accent, stroke: () => theme().accent },
      }],
      hooks: {
        setCursor: [(u) => read(u.cursor.idx)],
        draw: [(u) => drawChanges(u, changes(history), theme)],
      },
    }, [steps, values], holder);
  };
  return {
    element,
    resize() {
      if (!plot) make();
      else if (holder.clientWidth > 0) plot.setSize({ width: holder.clientWidth, height: 170 });
    },
    redraw: () => plot?.redraw(false, true),
  };
}

function roundRange(_, low, high) {
  if (!(low > 0)) return [0.1, 1];
  if (high / low > 100) return [10 ** Math.floor(Math.log10(low)), 10 ** Math.ceil(Math.log10(high))];
  return [roundTo(low, [5, 2, 1], (step, x) => step <= x), roundTo(high, [1, 2, 5, 10], (step, x) => step >= x)];
}

/** The first of some steps, times a power of ten, that fits. */
function roundTo(value, steps, fits) {
  const decade = 10 ** Math.floor(Math.log10(value));
  return decade * steps.find((step) => fits(step, value / decade * (steps[0] === 5 ? 1.001 : 0.999)));
}

function drawChanges(u, at, theme) {
  const { ctx, bbox } = u;
  ctx.save();
  ctx.strokeStyle = theme().muted;
  ctx.setLineDash([4, 4]);
  for (const iteration of at) {
    const x = Math.round(u.valToPos(iteration, 'x', true)) + 0.5;
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
  }
  ctx.restore();
}
