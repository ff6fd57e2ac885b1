// SPDX-License-Identifier: MIT

import { h, segments, select, slider, toggle } from './dom.js';
import { number, words } from './format.js';
import { histogramPanel } from './histogram.js';

/** Beside the picture: colours and filter, what is drawn, cut and shrink. */
export function controls(mesh, store, actions) {
  const stops = [];
  const on = (keys, listener) => stops.push(store.on(keys, listener));
  const panels = [
    mesh.metrics.length > 0 && colourGroup(mesh, store, on, stops),
    showGroup(mesh, store, on),
    mesh.dimension === 3 && cutGroup(store, on, actions),
  ].filter(Boolean);
  return { panels, dispose: () => stops.forEach((stop) => stop()) };
}

function colourGroup(mesh, store, on, stops) {
  const metric = select('Metric', mesh.metrics.map(({ name }) => [name, words(name)]),
    (name) => store.set({ metric: name, range: null }));
  on(['metric'], ({ metric: name }) => metric.set(name));
  const panel = histogramPanel(store);
  stops.push(panel.dispose);
  return h('section', { class: 'em-group', 'aria-label': 'Colour' },
    h('div', { class: 'em-row em-spread' }, h('h3', null, 'Colour by'), metric.element),
    panel.element);
}

function showGroup(mesh, store, on) {
  const flags = [
    ['edges', 'Cell edges', 'Edges of cells (E)'],
    mesh.dimension === 3 && ['features', 'Shape edges', 'Boundary and feature edges (O)'],
    ['marks', 'Held vertices', 'Vertices that are fixed, slide or were stopped (M)'],
  ].filter(Boolean);
  const switchOf = ([key, label, title]) => {
    const { button, set } = toggle(label, title, () => store.set({ [key]: !store.get()[key] }));
    on([key], (state) => set(state[key]));
    return button;
  };
  const which = select('Cells to show', [
    ['all', 'all cells'], ['0.1', 'worst 10 %'], ['0.01', 'worst 1 %'], ['0.001', 'worst 0.1 %'], ['listed', 'listed worst cells'],
  ], (show) => store.set({ show }));
  const others = segments('The other cells', [['fade', 'faded'], ['hide', 'hidden']], (value) => store.set({ others: value }));
  on(['show'], ({ show }) => which.set(show));
  on(['others'], (state) => others.set(state.others));
  const scale = select('Scale of the moves', [1, 2, 5, 10, 50].map((n) => [String(n), `× ${n}`]),
    (value) => store.set({ vectorScale: Number(value), vectors: true }));
  on(['vectorScale'], ({ vectorScale }) => scale.set(String(vectorScale)));
  const shrink = slider('Shrink cells', { min: 0.3, max: 1, step: 0.01 }, (value) => store.set({ shrink: 1.3 - value }));
  on(['shrink'], (state) => shrink.set(1.3 - state.shrink));
  return h('section', { class: 'em-group', 'aria-label': 'Show' },
    h('h3', null, 'Show'),
    h('div', { class: 'em-row' }, ...flags.map(switchOf)),
    mesh.after && h('div', { class: 'em-row' }, h('span', { class: 'em-what' }, 'Moves'),
      switchOf(['vectors', 'Arrows', 'From where each vertex was to where it is (V)']), scale.element),
    h('div', { class: 'em-row' }, h('span', { class: 'em-what' }, 'Cells'), which.element),
    mesh.type !== 'volume' && h('div', { class: 'em-row' }, h('span', { class: 'em-what' }, 'Others'), others.element),
    h('label', { class: 'em-row' }, h('span', { class: 'em-what' }, 'Shrink'), shrink.element));
}

function cutGroup(store, on, actions) {
  const axis = segments('Cut along', [
    ['off', 'off'], ['x', 'x'], ['y', 'y'], ['z', 'z'], ['view', 'view', 'Along the line of sight as it is now'],
  ], (value) => actions.cut(value));
  const place = slider('Place of the cut', { min: 0, max: 1, step: 0.005 }, (cutPlace) => store.set({ cutPlace }));
  const flip = toggle('Flip', 'Keep the other side', () => store.set({ cutFlip: !store.get().cutFlip }));
  const row = h('div', { class: 'em-row' }, place.element, flip.button);
  on(['cutAxis'], ({ cutAxis }) => {
    axis.set(cutAxis);
    row.hidden = cutAxis === 'off';
  });
  on(['cutPlace'], ({ cutPlace }) => {
    place.set(cutPlace);
    place.element.setAttribute('aria-valuetext', `${number(100 * cutPlace, 3)} %`);
  });
  on(['cutFlip'], ({ cutFlip }) => flip.set(cutFlip));
  return h('section', { class: 'em-group', 'aria-label': 'Cut' },
    h('div', { class: 'em-row em-spread' }, h('h3', null, 'Cut'), axis.element), row);
}
