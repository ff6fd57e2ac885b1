// SPDX-License-Identifier: MIT
//
// The page: finds the data in the document, builds the interactive report, and falls back to
// the static one, which is in the document already.

import { bytesFromBase64 } from './data/base64.js';
import { h } from './ui/dom.js';
import { CannotShow, mountReport } from './viewer.js';

performance.mark('evenmesh-start');

const app = document.getElementById('evenmesh-app');
const fixed = document.getElementById('evenmesh-static');

async function start() {
  const report = JSON.parse(document.getElementById('evenmesh-report').textContent);
  const data = bytesFromBase64(document.getElementById('evenmesh-data').textContent);
  const viewer = await mountReport(app, report, data, { keyTarget: document });
  fixed?.classList.add('em-print-only');
  addPrintedPicture(viewer);
  performance.mark('evenmesh-first-frame');
  performance.measure('evenmesh-open', { start: 0, end: 'evenmesh-first-frame' });
  return viewer;
}

/** What is printed is the static report, with the picture as it is at that time. */
function addPrintedPicture(viewer) {
  const picture = h('img', { class: 'em-printed', alt: 'The mesh as it was shown on the screen' });
  const holder = h('figure', { class: 'em-print-only' }, picture);
  document.body.append(holder);
  addEventListener('beforeprint', () => { picture.src = viewer.snapshot(); });
}

function explain(error) {
  app.className = 'em-app em-failed';
  app.replaceChildren(h('p', { class: 'em-message', role: 'status' },
    error instanceof CannotShow ? error.message : `The interactive view cannot be shown: ${error.message}.`,
    ' Below is the report without it.'));
  app.hidden = false;
  fixed?.before(app);
}

window.evenmesh = {
  ready: start().then((viewer) => Object.assign(window.evenmesh, viewer)).catch((error) => {
    window.evenmesh.error = error.message;
    explain(error);
  }),
};
