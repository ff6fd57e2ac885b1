// SPDX-License-Identifier: MIT

import { h } from './dom.js';
import { number, words } from './format.js';

const columns = [['worst', 'worst'], ['p1', '1 %'], ['p5', '5 %'], ['median', 'median'], ['mean', 'mean']];

/** The quality of all cells, before and after. */
export function qualityTable(quality) {
  if (!quality?.length) return null;
  const both = quality.some(({ after }) => after);
  const metrics = quality.map((row) => h('tr', null,
    h('th', { scope: 'row' }, words(row.metric), row.unit ? ` (${row.unit})` : '',
      h('small', null, `${row.better} is better`)),
    ...columns.flatMap(([key]) => cells(row, key, both))));
  return h('section', { class: 'em-card em-wide' },
    h('h2', null, 'Quality of all cells'),
    h('div', { class: 'em-scroll', tabindex: '0', role: 'region', 'aria-label': 'Quality of all cells' },
      h('table', { class: 'em-table em-numbers' },
        h('thead', null,
          h('tr', null, h('td'), ...columns.map(([, label]) =>
            h('th', { scope: 'colgroup', colspan: both ? 2 : 1 }, label))),
          both && h('tr', { class: 'em-subhead' }, h('td'), ...columns.flatMap(() =>
            [h('th', { scope: 'col' }, 'before'), h('th', { scope: 'col' }, 'after')]))),
        h('tbody', null, ...metrics))));
}

function cells(row, key, both) {
  const before = row.before?.[key];
  const first = h('td', { class: 'em-before' }, number(before));
  if (!both) return [first];
  const after = row.after?.[key];
  return [first, h('td', { class: `em-after ${changeOf(row.better, before, after)}` }, number(after))];
}

function changeOf(better, before, after) {
  const a = before ?? Infinity;
  const b = after ?? Infinity;
  if (a === b || after === undefined || Math.abs(a - b) < 1e-12) return '';
  return (better === 'lower') === b < a ? 'em-better' : 'em-worse';
}
