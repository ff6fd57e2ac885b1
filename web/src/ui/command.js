// SPDX-License-Identifier: MIT

import { copyButton, h } from './dom.js';

/** The command line and the record of the run, to copy. */
export function commandAndRun({ command, run, program }) {
  return h('section', { class: 'em-card em-wide' },
    h('h2', null, 'How it was made'),
    command && h('div', { class: 'em-command' },
      h('pre', { tabindex: '0', 'aria-label': 'Command line' }, command), copyButton('Copy command', () => command)),
    run && runDetails(run),
    program && h('p', { class: 'em-hint' }, program));
}

function runDetails(run) {
  const text = () => JSON.stringify(run, null, 2);
  const pre = h('pre', { class: 'em-json', tabindex: '0', 'aria-label': 'Record of the run' });
  const details = h('details', {
    ontoggle: () => { if (details.open && !pre.textContent) pre.textContent = text(); },
  }, h('summary', null, 'Record of the run (JSON)'), copyButton('Copy JSON', text), pre);
  return details;
}
