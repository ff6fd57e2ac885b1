// SPDX-License-Identifier: MIT

import { h } from './dom.js';

/**
 * The keys. Each: what is shown for it, what it does, and the function.
 * @param actions  see viewer.js
 */
export function makeKeys({ mesh, store, stage, actions }) {
  const flip = (key) => () => store.set({ [key]: !store.get()[key] });
  const { view } = stage;
  const arrow = (dx, dy) => (event) => {
    if (mesh.dimension === 2 || event.shiftKey) view.pan(-dx * 40, -dy * 40, stage.size.height);
    else view.turn(-dx * 16, -dy * 16);
  };
  const along = (normal) => () => actions.lookAlong(normal);
  const both = Boolean(mesh.after);
  const deep = mesh.dimension === 3;
  return [
    both && { keys: ['b'], shown: 'B', what: 'blink: change between before and after', run: actions.blink },
    both && { keys: ['1'], shown: '1', what: 'side by side', run: () => store.set({ mode: 'side' }) },
    both && { keys: ['2'], shown: '2', what: 'wipe', run: () => store.set({ mode: 'wipe' }) },
    both && { keys: ['3'], shown: '3', what: 'single', run: () => store.set({ mode: 'single' }) },
    both && { keys: ['['], shown: '[ ]', what: 'scrub back, forward', run: () => actions.scrubBy(-0.1) },
    both && { keys: [']'], run: () => actions.scrubBy(0.1) },
    { keys: ['e'], shown: 'E', what: 'cell edges', run: flip('edges') },
    deep && { keys: ['o'], shown: 'O', what: 'shape edges', run: flip('features') },
    { keys: ['m'], shown: 'M', what: 'held vertices', run: flip('marks') },
    both && { keys: ['v'], shown: 'V', what: 'moves', run: flip('vectors') },
    { keys: ['n'], shown: 'N P', what: 'next, previous of the worst cells', run: () => actions.nextWorst(1) },
    { keys: ['p'], run: () => actions.nextWorst(-1) },
    { keys: ['g'], shown: 'G', what: 'go to the chosen cell', run: actions.goToSelected },
    { keys: ['Escape'], shown: 'Esc', what: 'choose no cell', run: () => store.set({ selected: -1 }) },
    { keys: ['f'], shown: 'F', what: 'fit the whole mesh', run: actions.fit },
    deep && { keys: ['x'], shown: 'X Y Z', what: 'look along an axis', run: along([1, 0, 0]) },
    deep && { keys: ['y'], run: along([0, -1, 0]) },
    deep && { keys: ['z'], run: along([0, 0, 1]) },
    { keys: ['ArrowLeft'], shown: 'arrows', what: deep ? 'turn; with Shift: move' : 'move', canvas: true, run: arrow(-1, 0) },
    { keys: ['ArrowRight'], canvas: true, run: arrow(1, 0) },
    { keys: ['ArrowUp'], canvas: true, run: arrow(0, -1) },
    { keys: ['ArrowDown'], canvas: true, run: arrow(0, 1) },
    { keys: ['+', '='], shown: '+ −', what: 'zoom', run: () => view.zoom(1 / 1.25) },
    { keys: ['-'], run: () => view.zoom(1.25) },
    { keys: ['t'], shown: 'T', what: 'light or dark', run: actions.theme },
    { keys: ['?'], shown: '?', what: 'these keys', run: actions.keys },
  ].filter(Boolean);
}

/** Listens on an element; text fields, sliders and modified keys keep theirs. */
export function listenToKeys(target, keys, canvas) {
  const listener = (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    if (event.target.closest?.('input:not([type=range]), select, textarea, dialog[open]')) return;
    const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const key = keys.find((candidate) => candidate.keys.includes(name));
    if (!key || (key.canvas && event.target !== canvas)) return;
    event.preventDefault();
    key.run(event);
  };
  target.addEventListener('keydown', listener);
  return () => target.removeEventListener('keydown', listener);
}

export function keysDialog(keys) {
  const dialog = h('dialog', { class: 'em-dialog', 'aria-label': 'Keys' },
    h('h2', null, 'Keys'),
    h('dl', null, ...keys.filter(({ shown }) => shown).flatMap(({ shown, what }) =>
      [h('dt', null, ...shown.split(' ').map((key) => h('kbd', null, key))), h('dd', null, what)])),
    h('p', { class: 'em-hint' }, 'Mouse: drag to turn (with Shift or the right button: move), wheel to zoom, click to choose a cell, double click to go there.'),
    h('form', { method: 'dialog' }, h('button', { class: 'em-button' }, 'Close')));
  return dialog;
}
