// SPDX-License-Identifier: MIT

/**
 * The state of the page: plain values that only `set` changes. Who subscribes is told which keys
 * changed; nobody else tells the views what to show.
 */
export function makeStore(initial) {
  let state = Object.freeze({ ...initial });
  const listeners = new Set();
  return {
    get: () => state,
    set(patch) {
      const changed = new Set(Object.keys(patch).filter((key) => !Object.is(patch[key], state[key])));
      if (changed.size === 0) return;
      state = Object.freeze({ ...state, ...patch });
      for (const listener of [...listeners]) listener(state, changed);
    },
    /** @param keys  the listener is called if one of these changes, and once now */
    on(keys, listener) {
      const wrapped = (now, changed) => {
        if (keys.some((key) => changed.has(key))) listener(now);
      };
      listeners.add(wrapped);
      listener(state);
      return () => listeners.delete(wrapped);
    },
  };
}

/** What is shown at first. */
export function initialState(mesh) {
  const planar = mesh.dimension === 2;
  return {
    mode: mesh.after ? 'side' : 'single',  // side | wipe | single
    wipe: 0.5,
    scrub: mesh.stops.length - 1,          // a place among the stops; between them positions are mixed
    metric: mesh.metrics[0]?.name ?? null,
    values: null,                          // of the metric, once decoded
    range: null,                           // [low, high] in ranks, null: all
    rangeOf: mesh.after ? 'after' : 'before',
    show: 'all',                           // all | listed | a share of the cells, the worst
    others: mesh.type === 'volume' ? 'hide' : 'fade',
    cutAxis: 'off',                        // off | x | y | z | view
    cutNormal: null,                       // of the plane, kept from when the view was chosen
    cutPlace: 0.5,                         // share of the cells' extent that stays
    cutFlip: false,
    shrink: 1,
    edges: true,
    features: !planar,
    marks: false,
    vectors: false,
    vectorScale: 1,
    selected: -1,
    hovered: -1,
    visible: null,                         // {of, count}, follows from the above
  };
}
