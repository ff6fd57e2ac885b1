// SPDX-License-Identifier: MIT

import { h } from './dom.js';
import { number } from './format.js';

/** The worst cells; choosing one goes there. */
export function worstTable({ worst = [], mesh }, store, goTo) {
  if (worst.length === 0) return null;
  const both = mesh.has_after;
  const rows = worst.map((entry) => row(entry, both, goTo));
  store.on(['selected'], ({ selected }) => {
    worst.forEach(({ cell }, i) => rows[i].classList.toggle('em-chosen', cell >= 0 && cell === selected));
  });
  return h('section', { class: 'em-card em-worst' },
    h('h2', null, 'Worst cells'),
    h('p', { class: 'em-hint' }, 'Choose one to see it. N and P go through the list.'),
    h('div', { class: 'em-scroll em-list' },
      h('table', { class: 'em-table' },
        h('thead', null, h('tr', null,
          h('th', { scope: 'col' }, 'cell'), h('th', { scope: 'col' }, 'kind'),
          h('th', { scope: 'col', class: 'em-number' }, both ? 'shape before' : 'shape'),
          both && h('th', { scope: 'col', class: 'em-number' }, 'after'),
          h('th', { scope: 'col' }, 'what holds it'))),
        h('tbody', null, ...rows))));
}

function row(entry, both, goTo) {
  const there = entry.cell >= 0;
  const name = there
    ? h('button', { type: 'button', class: 'em-link' }, entry.name)
    : h('span', { title: 'Not among the cells in this file' }, entry.name);
  return h('tr', { class: there ? 'em-goes' : null, onclick: there && (() => goTo(entry.cell)) },
    h('th', { scope: 'row' }, name, entry.inverted && h('span', { class: 'em-tag' }, 'inverted')),
    h('td', null, entry.kind),
    h('td', { class: 'em-number' }, number(entry.shape_before)),
    both && h('td', { class: 'em-number' }, number(entry.shape_after)),
    h('td', { class: 'em-holds' }, (entry.held_by ?? []).join('; ') || '–'));
}
