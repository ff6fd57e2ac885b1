// SPDX-License-Identifier: MIT

import { CannotShow } from './cannot_show.js';
import { makeArrays } from './data/decode.js';
import { loadMesh } from './model/mesh.js';
import { findVisible, spanAlong } from './model/visibility.js';
import { initialState, makeStore } from './store.js';
import { poseAlong } from './gl/camera.js';
import { bar } from './ui/bar.js';
import { cellPanel } from './ui/cell.js';
import { commandAndRun } from './ui/command.js';
import { controls } from './ui/controls.js';
import { convergence } from './ui/convergence.js';
import { h } from './ui/dom.js';
import { keysDialog, listenToKeys, makeKeys } from './ui/keys.js';
import { legend as makeLegend } from './ui/legend.js';
import { qualityTable } from './ui/quality.js';
import { Stage } from './ui/stage.js';
import { summary } from './ui/summary.js';
import { makeTheme } from './ui/theme.js';
import { worstTable } from './ui/worst.js';

const format = 1;
const kindNames = { smooth: 'Smoothing', compare: 'Comparison', check: 'Check' };

export { CannotShow };

/**
 * Builds the interactive report inside an element.
 *
 * @param root     an empty element; gets the class em-app
 * @param report   what #evenmesh-report holds, parsed
 * @param data     Uint8Array of what #evenmesh-data holds, decoded from base64
 * @param options  {keyTarget: where keys are listened to, default root}
 * @return         {state(), set(), select(), goTo(), project(), pick(), camera(), settled(), redraw(), snapshot(), canvas, dispose()},
 *                 see README.md, after the first picture is drawn
 * @throws CannotShow  no WebGL 2, or the data cannot be read
 */
export async function mountReport(root, report, data, { keyTarget = root } = {}) {
  if (report.format !== format) {
    throw new CannotShow(`This report has data format ${report.format}; this page reads format ${format}.`);
  }
  const mesh = await loadMesh(report, makeArrays(report.arrays ?? {}, data));
  const store = makeStore(initialState(mesh));
  if (store.get().metric) store.set({ values: await mesh.metric(store.get().metric) });
  performance.mark('evenmesh-decoded');

  let stage;
  const palette = () => theme.palette();
  const theme = makeTheme(root, (colours) => {
    stage?.scene.setTheme(colours);
    stage?.redraw();
    legend?.redraw();
    charts?.redraw();
  });
  const legend = makeLegend(store, palette);
  stage = new Stage(mesh, store);
  const listed = (report.worst ?? []).map(({ cell }) => cell).filter((cell) => cell >= 0 && cell < mesh.cellCount);
  const actions = makeActions({ report, mesh, store, stage, theme, listed, dialog: () => dialog });
  const keys = makeKeys({ mesh, store, stage, actions });
  const dialog = keysDialog(keys);
  const charts = convergence(report.history, theme.chart);
  const parts = { bar: bar(mesh, store, actions), cell: cellPanel(report, mesh, store, stage.goTo.bind(stage)), controls: controls(mesh, store, actions) };

  const stopUpdates = followState(report, mesh, store, stage, listed);
  const firstPicture = new Promise((resolve) => { stage.whenDrawn = resolve; });
  root.classList.add('em-app');
  root.replaceChildren(
    header(report, theme),
    h('main', null,
      summary(report),
      h('section', { class: 'em-workspace', 'aria-label': 'Mesh' },
        h('div', { class: 'em-picture' }, parts.bar.element, stage.element, legend.element),
        h('aside', { class: 'em-side', 'aria-label': 'Cell, colours and filters' }, parts.cell.element, ...parts.controls.panels)),
      h('div', { class: 'em-below' },
        ...[worstTable(report, store, actions.goTo), qualityTable(report.quality), charts?.element, commandAndRun(report)].filter(Boolean))),
    dialog);
  root.hidden = false;
  theme.apply();
  const stopKeys = listenToKeys(keyTarget, keys, stage.canvas);
  await firstPicture;
  stage.whenDrawn = undefined;
  stage.scene.finish();

  return {
    state: () => describeState(store.get(), mesh),
    set: (patch) => store.set(patch),
    select: (cell) => store.set({ selected: cell }),
    goTo: actions.goTo,
    project: (cell, side) => stage.project(cell, side),
    pick: (x, y) => stage.pick(x, y),
    camera: () => ({
      target: [...stage.view.target], halfHeight: stage.view.halfHeight,
      azimuth: stage.view.azimuth, elevation: stage.view.elevation, flying: stage.view.flying,
    }),
    settled: () => settled(stage),
    redraw() {
      stage.draw();
      stage.scene.finish();
    },
    snapshot: () => stage.snapshot().toDataURL('image/png'),
    canvas: stage.canvas,
    dispose() {
      stopUpdates();
      stopKeys();
      theme.dispose();
      legend.dispose();
      charts?.dispose();
      for (const part of Object.values(parts)) part.dispose();
      stage.dispose();
      root.replaceChildren();
    },
  };
}

function header({ title, kind, program }, theme) {
  return h('header', { class: 'em-header' },
    h('span', { class: 'em-brand' }, 'evenmesh'),
    h('h1', null, title),
    h('span', { class: 'em-kind' }, kindNames[kind] ?? kind, program ? h('span', { class: 'em-program' }, ` · ${program}`) : null),
    theme.button);
}

/** What follows from the state: values of the metric, which cells are seen, marks and arrows. */
function followState(report, mesh, store, stage, listed) {
  const { scene } = stage;
  const stops = [
    store.on(['metric'], async ({ metric, values }) => {
      if (!metric || values?.name === metric) return;
      const loaded = await mesh.metric(metric);
      if (store.get().metric === metric) store.set({ values: loaded });
    }),
    store.on(['values'], ({ values }) => scene.setMetric(values)),
    store.on(['values', 'range', 'rangeOf', 'show', 'others', 'cutAxis', 'cutNormal', 'cutPlace', 'cutFlip'], (state) => {
      const cut = planeOf(mesh, state);
      store.set({ visible: findVisible(mesh, state.values, { ...state, cut }, listed) });
    }),
    store.on(['visible', 'shrink'], ({ visible, shrink }) => {
      scene.setVisible(visible, shrink < 1);
      stage.redraw();
    }),
    store.on(['visible', 'marks'], async ({ marks }) => {
      if (!marks) return;
      const { hold } = await mesh.details();
      scene.setMarks(store.get().visible, hold);
      stage.redraw();
    }),
    store.on(['visible', 'vectors'], ({ visible, vectors }) => {
      if (!vectors || !mesh.after) return;
      scene.setArrows(visible);
      stage.redraw();
    }),
  ];
  mesh.featureEdges().then((edges) => {
    scene.setFeatureEdges(edges);
    stage.redraw();
  });
  return () => stops.forEach((stop) => stop());
}

const axes = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

function planeOf(mesh, { cutAxis, cutNormal, cutPlace, cutFlip }) {
  if (cutAxis === 'off') return null;
  const normal = (axes[cutAxis] ?? cutNormal).map((n) => (cutFlip ? -n : n));
  const [low, high] = spanAlong(mesh, normal);
  const slack = 1e-6 * mesh.box.diagonal;
  return { normal, distance: low + (cutFlip ? 1 - cutPlace : cutPlace) * (high - low) + slack };
}

/** What buttons and keys do. */
function makeActions({ report, mesh, store, stage, theme, listed, dialog }) {
  const last = mesh.stops.length - 1;
  const actions = {
    blink() {
      const { mode, scrub } = store.get();
      store.set({ mode: 'single', scrub: mode === 'single' && scrub > last / 2 ? 0 : mode === 'single' ? last : 0 });
    },
    scrubBy(step) {
      store.set({ scrub: Math.min(last, Math.max(0, Math.round((store.get().scrub + step) * 100) / 100)) });
    },
    fit: () => stage.view.fly(stage.view.whole(), { fitted: true }),
    lookAlong(normal) {
      const pose = poseAlong(normal);
      const { target, halfHeight } = stage.view.whole(pose);
      stage.view.fly({ ...pose, target, halfHeight }, { fitted: true });
    },
    goTo(cell) {
      store.set({ selected: cell });
      openTo(cell);
      stage.goTo(cell);
      stage.element.scrollIntoView({ block: 'nearest' });
    },
    goToSelected() {
      const { selected } = store.get();
      if (selected >= 0) stage.goTo(selected);
    },
    nextWorst(step) {
      if (listed.length === 0) return;
      const at = listed.indexOf(store.get().selected);
      const next = at < 0 ? (step > 0 ? 0 : listed.length - 1) : (at + step + listed.length) % listed.length;
      actions.goTo(listed[next]);
    },
    cut(axis) {
      store.set({ cutAxis: axis, cutNormal: axis === 'view' ? stage.view.axes().eye : null, cutFlip: false });
    },
    theme: () => theme.button.click(),
    keys: () => (dialog().open ? dialog().close() : dialog().showModal()),
    save() {
      const link = h('a', { download: `${report.title.replace(/[^\w.-]+/g, '_')}.png`, href: stage.snapshot().toDataURL('image/png') });
      link.click();
    },
  };
  /** Cuts a volume open where the cell would be inside, so that it can be seen. */
  function openTo(cell) {
    if (mesh.type !== 'volume') return;
    store.set(stage.cutTo(cell));
  }
  return actions;
}

function describeState(state, mesh) {
  const { visible, values, ...plain } = state;
  return { ...plain, cells: mesh.cellCount, vertices: mesh.vertexCount, visibleCells: visible?.count ?? 0, decoded: values?.name ?? null };
}

/** Resolves when nothing moves and all is drawn. */
async function settled(stage) {
  const frame = () => new Promise(requestAnimationFrame);
  do {
    await frame();
    await frame();
  } while (stage.view.flying || stage.frame !== undefined);
}
