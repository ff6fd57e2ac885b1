// SPDX-License-Identifier: MIT

import { h } from './dom.js';
import { count } from './format.js';

const marks = { pass: '✓', fail: '✗', none: '–' };
const readOut = { pass: 'pass', fail: 'fail', none: 'not judged' };
const toneOf = (pass) => (pass === true ? 'pass' : pass === false ? 'fail' : 'none');

/** Title, how it ended, what passed, what was done. */
export function summary(report) {
  return h('section', { class: 'em-summary', 'aria-label': 'Result' },
    h('div', { class: 'em-card em-result' },
      headline(report),
      verdicts(report.verdicts ?? [])),
    report.ledger?.length > 0 && h('div', { class: 'em-card' },
      h('h2', null, 'Geometry'),
      h('dl', { class: `em-columns ${report.ledger.length > 6 ? 'em-two' : ''}` }, ...report.ledger.map(({ name, value }) =>
        h('div', null, h('dt', null, name), h('dd', null, value))))),
    notes(report));
}

function headline({ run, status: given = run?.status, message: said = run?.message, verdicts = [], kind }) {
  const failed = verdicts.filter(({ pass }) => pass === false).length;
  const tone = toneOfRun(given, failed);
  const status = given ?? (failed ? 'not passed' : kind === 'check' ? 'checked' : 'compared');
  const message = said ?? (failed
    ? `${failed} of ${verdicts.length} checks did not pass`
    : verdicts.some(({ pass }) => pass === true) ? 'All that was judged passed' : 'Measured; nothing was judged');
  return h('p', { class: 'em-headline' }, h('span', { class: `em-status em-${tone}` }, status), ' ', message);
}

/** A run that ended well and yet missed a demand is neither green nor red. */
function toneOfRun(status, failed) {
  if (!status) return failed ? 'fail' : 'pass';
  if (status === 'failed') return 'fail';
  return status === 'ok' && !failed ? 'pass' : 'warn';
}

function verdicts(list) {
  if (list.length === 0) return null;
  return h('ul', { class: 'em-verdicts' }, ...list.map(({ name, pass, text }) => {
    const tone = toneOf(pass);
    return h('li', { class: `em-verdict-${tone}` },
      h('span', { class: 'em-mark', role: 'img', 'aria-label': readOut[tone] }, marks[tone]),
      h('span', { class: 'em-verdict-name' }, name),
      h('span', { class: 'em-verdict-text' }, text));
  }));
}

function notes({ notes: given = [], mesh }) {
  const list = [...given];
  const { shown, of } = mesh?.cells ?? {};
  if (shown < of) list.unshift(`${count(shown)} of ${count(of)} cells are in this file and can be looked at.`);
  if (list.length === 0) return null;
  return h('div', { class: 'em-card' },
    h('h2', null, 'Notes'),
    h('ul', { class: 'em-notes' }, ...list.map((note) => h('li', null, note))));
}
