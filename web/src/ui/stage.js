// SPDX-License-Identifier: MIT

import { h, svg } from './dom.js';
import { words } from './format.js';
import { valueText } from './cell.js';
import { listenToPointers } from './pointer.js';
import { drawLegend } from './legend.js';
import { makePanes, paneAspect, paneAt } from './panes.js';
import { Scene } from '../gl/scene.js';
import { poseAlong, View } from '../gl/camera.js';
import { kinds, edgesOf } from '../model/kinds.js';
import { middleOfCell } from '../model/mesh.js';
import { spanAlong } from '../model/visibility.js';

/**
 * The picture: a canvas, what lies over it, and what the pointer does there. It draws when
 * something has changed, and only then.
 */
export class Stage {
  /** @throws CannotShow  there is no WebGL 2 */
  constructor(mesh, store) {
    this.mesh = mesh;
    this.store = store;
    this.canvas = h('canvas', {
      tabindex: '0', class: 'em-canvas', role: 'application',
      'aria-label': 'Picture of the mesh. Arrow keys turn or shift it, plus and minus zoom, question mark lists all keys.',
    });
    this.scene = new Scene(this.canvas, mesh);
    this.view = new View(mesh, () => this.redraw());
    this.labels = [h('div', { class: 'em-label' }), h('div', { class: 'em-label' })];
    this.handle = this.#makeHandle();
    this.tip = h('div', { class: 'em-tip', hidden: true });
    this.triad = mesh.dimension === 3 && makeTriad();
    this.divider = h('div', { class: 'em-divider', hidden: true });
    this.element = h('div', { class: 'em-stage' }, this.canvas, this.divider, ...this.labels, this.handle,
      this.triad && this.triad.element, this.tip);
    this.size = { width: 0, height: 0 };
    this.drawn = 0;
    this.points = { from: mesh.before, to: mesh.before, mixing: 0 };
    this.#listen();
    this.observer = new ResizeObserver(() => this.#resize());
    this.observer.observe(this.canvas);
  }

  #makeHandle() {
    const slide = (x) => this.store.set({ wipe: Math.min(0.98, Math.max(0.02, x)) });
    const handle = h('div', {
      class: 'em-wipe', role: 'slider', tabindex: '0', 'aria-label': 'Border between before and after',
      'aria-valuemin': '0', 'aria-valuemax': '100', hidden: true,
      onpointerdown: (event) => handle.setPointerCapture(event.pointerId),
      onpointermove: (event) => {
        if (!handle.hasPointerCapture(event.pointerId)) return;
        const box = this.canvas.getBoundingClientRect();
        slide((event.clientX - box.left) / box.width);
      },
      onkeydown: (event) => {
        const by = { ArrowLeft: -0.02, ArrowRight: 0.02 }[event.key];
        if (!by) return;
        slide(this.store.get().wipe + by);
        event.preventDefault();
        event.stopPropagation();
      },
    }, h('span', { 'aria-hidden': 'true' }, '⇔'));
    return handle;
  }

  #listen() {
    const { store } = this;
    listenToPointers(this.canvas, this.view, {
      paneAt: (x, y) => paneAt(this.panes, x, y),
      hover: (x, y) => {
        this.hoverAt = [x, y];
        this.hoverFrame ??= requestAnimationFrame(() => this.#hover());
      },
      leave: () => {
        this.hoverAt = null;
        store.set({ hovered: -1 });
      },
      click: (x, y) => store.set({ selected: this.pick(x, y) }),
    });
    this.canvas.addEventListener('dblclick', () => {
      const { selected } = store.get();
      if (selected >= 0) this.goTo(selected);
    });
    this.unsubscribe = [
      store.on(['mode', 'wipe', 'visible', 'values', 'edges', 'features', 'marks', 'vectors', 'vectorScale', 'shrink'],
        () => this.redraw()),
      store.on(['mode'], () => this.#fitAgain()),
      store.on(['scrub'], ({ scrub }) => this.#scrub(scrub)),
      store.on(['selected'], ({ selected }) => {
        this.scene.setSelected(selected);
        this.redraw();
      }),
      store.on(['hovered'], ({ hovered }) => {
        this.#showTip(hovered);
        this.redraw();
      }),
    ];
  }

  /** Brings the points of a place among the stops, which may have to be decoded first. */
  async #scrub(scrub) {
    const { stops } = this.mesh;
    const from = Math.min(Math.floor(scrub), stops.length - 1);
    const to = Math.min(from + 1, stops.length - 1);
    const points = await Promise.all([stops[from].points(), stops[to].points()]);
    if (this.store.get().scrub !== scrub) return;
    this.points = { from: points[0], to: points[1], mixing: scrub - from };
    this.redraw();
  }

  #resize() {
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    if (width < 1 || height < 1) return;
    this.size = { width, height };
    this.scene.resize(width, height, Math.min(window.devicePixelRatio || 1, 2));
    this.#fitAgain();
    this.draw();  // at once: resizing has cleared the canvas
  }

  #fitAgain() {
    if (!this.size.width) return;
    this.view.aspect = paneAspect(this.store.get(), this.size);
    if (this.view.fitted) this.view.fit();
  }

  get panes() {
    const state = this.store.get();
    const last = this.mesh.stops.length - 1;
    const progress = last > 0 ? state.scrub / last : 0;
    const { before } = this.mesh;
    return makePanes(state, this.size, { from: before, to: before, mixing: 0, progress: 0, label: 'before' },
      { ...this.points, progress, label: labelOf(this.mesh.stops, state.scrub) });
  }

  redraw() {
    this.frame ??= requestAnimationFrame(() => this.draw());
  }

  draw() {
    if (this.frame !== undefined) cancelAnimationFrame(this.frame);
    this.frame = undefined;
    const state = this.store.get();
    if (!this.size.width || !state.visible) return;
    this.scene.setLook(state);
    this.scene.render(this.panes, this.view, this.size.height);
    this.#placeOverlays(state);
    ++this.drawn;
    this.whenDrawn?.();
  }

  #placeOverlays({ mode, wipe }) {
    const { panes, mesh } = this;
    this.labels.forEach((label, i) => {
      const pane = panes[i];
      label.hidden = !pane || mesh.stops.length === 1;
      if (label.hidden) return;
      label.textContent = pane.label;
      const right = mode === 'wipe' && i === 1;
      label.classList.toggle('em-right', right);
      label.style.left = right ? '' : `${pane.scissor.x + 12}px`;
      label.style.top = `${pane.scissor.y + 12}px`;
    });
    this.handle.hidden = mode !== 'wipe';
    this.handle.style.left = `${wipe * 100}%`;
    this.handle.setAttribute('aria-valuenow', Math.round(wipe * 100));
    this.divider.hidden = mode !== 'side';
    this.divider.classList.toggle('em-flat', this.size.width < this.size.height);
    this.triad?.turn?.(this.view.axes());
  }

  pick(x, y) {
    if (!this.size.width || !this.store.get().visible) return -1;
    if (this.frame !== undefined) this.draw();
    return this.scene.pick(this.panes, this.view, x, y);
  }

  #hover() {
    this.hoverFrame = undefined;
    if (this.hoverAt) this.store.set({ hovered: this.pick(...this.hoverAt) });
    this.#placeTip();
  }

  async #showTip(cell) {
    this.tip.hidden = cell < 0;
    if (cell < 0) return;
    const { values } = this.store.get();
    const { cellName } = await this.mesh.details();
    if (this.store.get().hovered !== cell) return;
    const value = values && `${words(values.name)} ${valueText(values, values.before[cell])}` +
      (this.mesh.after ? ` → ${valueText(values, values.after[cell])}` : '');
    this.tip.replaceChildren(...[h('strong', null, `${kinds[this.mesh.kind[cell]].name} ${cellName(cell)}`),
      value && h('span', null, value)].filter(Boolean));
    this.#placeTip();
  }

  #placeTip() {
    if (!this.hoverAt || this.tip.hidden) return;
    const [x, y] = this.hoverAt;
    const { offsetWidth: width, offsetHeight: height } = this.tip;
    this.tip.style.left = `${Math.max(4, Math.min(x + 14, this.size.width - width - 6))}px`;
    this.tip.style.top = `${y + 18 + height > this.size.height ? y - height - 10 : y + 18}px`;
  }

  /** Moves the camera to a cell, to the side that it is seen from. */
  goTo(cell) {
    const { mesh, view } = this;
    const points = mesh.after ?? mesh.before;
    const target = middleOfCell(mesh, points, cell);
    const pose = { target, halfHeight: Math.min(7 * cellSize(mesh, points, cell), 0.5 * view.whole().halfHeight) };
    if (mesh.dimension === 3) {
      const normal = mesh.type === 'volume' ? outward(mesh, target) : normalOf(mesh, points, cell);
      // Of the two sides of a surface the one nearer to the eye.
      const { eye } = view.axes();
      const turned = mesh.type !== 'volume' && dot(normal, eye) < 0 && !closedOutward(mesh, target, normal);
      Object.assign(pose, poseAlong(normal.map((n) => (turned ? -n : n))));
    }
    view.fly(pose);
  }

  /**
   * The cut, as state, that lays a cell of a volume open: along the line from the middle of the mesh
   * to it, just outside of it. None if one of its faces is on the boundary, where nothing hides it.
   */
  cutTo(cell) {
    if (this.scene.onBoundary(cell)) return { cutAxis: 'off' };
    const middle = middleOfCell(this.mesh, this.mesh.before, cell);
    const normal = outward(this.mesh, middle);
    const [low, high] = spanAlong(this.mesh, normal);
    const cutPlace = high > low ? (dot(middle, normal) - low) / (high - low) : 1;
    return { cutAxis: 'view', cutNormal: normal, cutPlace: Math.min(1, cutPlace + 1e-4), cutFlip: false };
  }

  /** Where the middle of a cell is on the canvas, in CSS pixels. @param side  'before' or 'after' */
  project(cell, side = 'after') {
    const { panes, view, mesh } = this;
    const pane = panes.length === 1 || side === 'after' ? panes.at(-1) : panes[0];
    const [from, to] = [pane.from, pane.to].map((points) => middleOfCell(mesh, points, cell));
    const middle = from.map((value, i) => value + (to[i] - value) * pane.mixing - view.target[i]);
    const { right, up } = view.axes();
    const { x, y, width, height } = pane.viewport;
    const unit = height / 2 / view.halfHeight;
    return { x: x + width / 2 + dot(middle, right) * unit, y: y + height / 2 - dot(middle, up) * unit };
  }

  /** The canvas as it is, with the labels and below it the meaning of the colours, on a 2D canvas. */
  snapshot() {
    this.draw();
    const ratio = this.canvas.width / this.size.width;
    const { values } = this.store.get();
    const strip = values ? 34 : 0;
    const picture = h('canvas', { width: this.canvas.width, height: this.canvas.height + strip * ratio });
    const context = picture.getContext('2d');
    context.drawImage(this.canvas, 0, 0);
    context.scale(ratio, ratio);
    if (values) drawLegend(context, values, { y: this.size.height, width: this.size.width, height: strip }, getComputedStyle(this.element));
    context.font = '600 13px system-ui, sans-serif';
    for (const label of this.labels) {
      if (label.hidden) continue;
      const style = getComputedStyle(label);
      const { offsetLeft: x, offsetTop: y, offsetWidth: w, offsetHeight: t } = label;
      context.fillStyle = style.backgroundColor;
      context.fillRect(x, y, w, t);
      context.fillStyle = style.color;
      context.textBaseline = 'middle';
      context.fillText(label.textContent, x + 9, y + t / 2 + 1);
    }
    return picture;
  }

  dispose() {
    this.observer.disconnect();
    this.view.stop();
    if (this.frame !== undefined) cancelAnimationFrame(this.frame);
    for (const stop of this.unsubscribe) stop();
    this.scene.dispose();
  }
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

function labelOf(stops, scrub) {
  const near = Math.round(scrub);
  if (Math.abs(scrub - near) < 1e-6) return stops[near].label;
  const from = Math.floor(scrub);
  return `${stops[from].label} → ${stops[from + 1].label}, ${Math.round(100 * (scrub - from))} %`;
}

/** Longest edge of a cell. */
function cellSize(mesh, points, cell) {
  const first = mesh.first[cell];
  const lengths = edgesOf(mesh, cell).map(([a, b]) => {
    const p = 4 * mesh.vertices[first + a];
    const q = 4 * mesh.vertices[first + b];
    return Math.hypot(points[p] - points[q], points[p + 1] - points[q + 1], points[p + 2] - points[q + 2]);
  });
  return Math.max(...lengths, 1e-5 * mesh.box.diagonal);
}

function middleOfBox({ low, high }) {
  return low.map((value, axis) => (value + high[axis]) / 2);
}

/** From the middle of the mesh to a place, seen a little from above. */
function outward(mesh, place) {
  const middle = middleOfBox(mesh.box);
  const away = place.map((value, axis) => value - middle[axis]);
  const size = Math.hypot(...away);
  return size > 1e-6 * mesh.box.diagonal ? away.map((value) => value / size) : [0.5, -0.8, 0.6];
}

function normalOf(mesh, points, cell) {
  const [a, b, c] = [0, 1, 2].map((i) => 4 * mesh.vertices[mesh.first[cell] + i]);
  const u = [0, 1, 2].map((axis) => points[b + axis] - points[a + axis]);
  const v = [0, 1, 2].map((axis) => points[c + axis] - points[a + axis]);
  const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const size = Math.hypot(...n);
  return size > 0 ? n.map((value) => value / size) : outward(mesh, [points[a], points[a + 1], points[a + 2]]);
}

/** Whether a normal points away from the middle, as those of most closed surfaces do. */
function closedOutward(mesh, place, normal) {
  return dot(normal, outward(mesh, place)) > 0.2;
}

/** Three short axes that turn with the view. */
function makeTriad() {
  const parts = ['x', 'y', 'z'].map((name) => ({
    line: svg('line', { x1: 0, y1: 0, class: `em-axis em-axis-${name}` }),
    text: svg('text', { class: `em-axis-name em-axis-${name}` }, name),
  }));
  const element = svg('svg', { viewBox: '-34 -34 68 68', class: 'em-triad', 'aria-hidden': 'true' },
    ...parts.flatMap(({ line, text }) => [line, text]));
  return {
    element,
    turn({ right, up }) {
      parts.forEach(({ line, text }, axis) => {
        const x = right[axis];
        const y = -up[axis];
        line.setAttribute('x2', 20 * x);
        line.setAttribute('y2', 20 * y);
        text.setAttribute('x', 28 * x);
        text.setAttribute('y', 28 * y + 4);
      });
    },
  };
}
