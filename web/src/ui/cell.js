// SPDX-License-Identifier: MIT

import { h } from './dom.js';
import { number, withUnit, words } from './format.js';
import { describeCell } from '../model/cell.js';
import { valueOfByte } from '../model/mesh.js';

/** The panel of the cell that was chosen. */
export function cellPanel(report, mesh, store, goTo) {
  const element = h('section', { class: 'em-group em-cell', 'aria-live': 'polite', 'aria-label': 'Chosen cell' });
  const show = async ({ selected }) => {
    if (selected < 0) {
      element.replaceChildren(h('h3', null, 'Cell'),
        h('p', { class: 'em-hint' }, 'Point at a cell to read it; click to keep it here.'));
      return;
    }
    const [details, ...values] = await Promise.all([mesh.details(), ...mesh.metrics.map(({ name }) => mesh.metric(name))]);
    if (store.get().selected !== selected) return;
    const entry = report.worst?.find(({ cell }) => cell === selected);
    element.replaceChildren(...panel(mesh, describeCell(mesh, details, selected), values, selected, entry, {
      close: () => store.set({ selected: -1 }),
      goTo: () => goTo(selected),
    }));
  };
  const stop = store.on(['selected'], show);
  return { element, dispose: stop };
}

function panel(mesh, about, metrics, cell, entry, { close, goTo }) {
  const facts = [
    about.group && ['group', about.group],
    about.held && ['vertices', about.held],
    entry?.held_by?.length > 0 && ['held by', entry.held_by.join('; ')],
    about.largestMove !== null && ['largest move', about.largestMove > 0 ? number(about.largestMove) : 'none'],
    ['middle', about.middle.slice(0, mesh.dimension).map((x) => number(x)).join(', ')],
    ['vertex ids', about.vertices.join(', ')],
  ].filter(Boolean);
  return [
    h('div', { class: 'em-row em-spread' },
      h('h3', null, `${about.kind} ${about.name}`),
      h('span', { class: 'em-row' },
        h('button', { type: 'button', class: 'em-button', onclick: goTo, title: 'Bring it to the middle (G)' }, 'Go to'),
        h('button', { type: 'button', class: 'em-button', onclick: close, 'aria-label': 'Close', title: 'Close (Esc)' }, '×'))),
    about.flags.length > 0 && h('p', { class: 'em-tags' }, ...about.flags.map((flag) =>
      h('span', { class: `em-tag ${flag === 'wall layer' ? 'em-calm' : ''}` }, flag))),
    h('table', { class: 'em-table em-metrics' },
      mesh.after && h('thead', null, h('tr', null, h('td'),
        h('th', { scope: 'col', class: 'em-number' }, 'before'), h('th', { scope: 'col', class: 'em-number' }, 'after'))),
      h('tbody', null, ...metrics.map((metric) => h('tr', null,
        h('th', { scope: 'row' }, words(metric.name)),
        h('td', { class: 'em-number' }, valueText(metric, metric.before[cell])),
        mesh.after && h('td', { class: 'em-number' }, valueText(metric, metric.after[cell])))))),
    h('dl', { class: 'em-ledger' }, ...facts.flatMap(([name, value]) => [h('dt', null, name), h('dd', null, value)])),
  ].filter(Boolean);
}

/** The byte of a metric tells three digits at most; more would be made up. */
export function valueText(metric, byte) {
  if (byte === 255) return 'undefined';
  const text = withUnit(number(valueOfByte(metric, byte), 3), metric.unit);
  return byte === 254 && metric.better === 'lower' ? `≥ ${text}` : text;
}
