// SPDX-License-Identifier: MIT

import { h, segments, slider } from './dom.js';

/** Over the picture: which of before and after is seen, and how. */
export function bar(mesh, store, actions) {
  const parts = [];
  const unsubscribe = [];
  if (mesh.after) {
    const mode = segments('Arrangement', [
      ['side', 'Side by side', 'Two linked pictures (1)'],
      ['wipe', 'Wipe', 'One picture, with a border to drag (2)'],
      ['single', 'Single', 'One picture at a time (3)'],
    ], (value) => store.set({ mode: value }));
    const last = mesh.stops.length - 1;
    const scrub = slider('From before to after', { min: 0, max: last, step: last > 1 ? 0.05 : 0.01 },
      (value) => store.set({ scrub: value }));
    unsubscribe.push(
      store.on(['mode'], ({ mode: chosen }) => mode.set(chosen)),
      store.on(['scrub'], ({ scrub: place }) => scrub.set(place)));
    parts.push(mode.element,
      h('div', { class: 'em-row em-scrub' }, h('span', null, 'before'), scrub.element, h('span', null, 'after')),
      h('button', { type: 'button', class: 'em-button', onclick: actions.blink, title: 'Change between before and after (B)' }, 'Blink'));
  }
  const button = (label, title, onclick) => h('button', { type: 'button', class: 'em-button', title, onclick }, label);
  parts.push(h('span', { class: 'em-row em-last' },
    button('Fit', 'Show the whole mesh (F)', actions.fit),
    button('Save picture', 'Save the picture as PNG', actions.save),
    button('Keys', 'List the keys (?)', actions.keys)));
  return {
    element: h('div', { class: 'em-bar', role: 'toolbar', 'aria-label': 'View' }, ...parts),
    dispose: () => unsubscribe.forEach((stop) => stop()),
  };
}
