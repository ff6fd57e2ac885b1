// SPDX-License-Identifier: MIT

/**
 * Mouse and fingers on the canvas: turn, shift and zoom the view; hover and click report a place.
 *
 * @param on  {paneAt(x, y), hover(x, y), leave(), click(x, y), moved()}
 */
export function listenToPointers(canvas, view, on) {
  const pointers = new Map();
  let travelled = 0;

  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const zoomAt = (factor, x, y) => {
    const { viewport } = on.paneAt(x, y);
    const unit = viewport.height / 2;
    view.zoom(factor, (x - viewport.x - viewport.width / 2) / unit, -(y - viewport.y - viewport.height / 2) / unit);
  };

  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
    if (pointers.size === 0) travelled = 0;
    pointers.set(event.pointerId, { at: place(event), button: event.button, shift: event.shiftKey });
    view.stop();
  });
  canvas.addEventListener('pointermove', (event) => {
    const now = place(event);
    const pointer = pointers.get(event.pointerId);
    if (!pointer) return on.hover(...now);
    const [dx, dy] = now.map((value, i) => value - pointer.at[i]);
    travelled += Math.abs(dx) + Math.abs(dy);
    if (travelled < 4) return undefined;
    on.leave();
    const { height } = on.paneAt(...now).viewport;
    if (pointers.size === 2) {
      const other = [...pointers.values()].find((candidate) => candidate !== pointer).at;
      const distance = ([x, y]) => Math.hypot(x - other[0], y - other[1]) || 1;
      view.pan(dx / 2, dy / 2, height);
      zoomAt(distance(pointer.at) / distance(now), (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
    } else if (view.planar || pointer.button !== 0 || pointer.shift) {
      view.pan(dx, dy, height);
    } else {
      view.turn(dx, dy);
    }
    pointer.at = now;
    return undefined;
  });
  const release = (event) => {
    const pointer = pointers.get(event.pointerId);
    pointers.delete(event.pointerId);
    if (event.type === 'pointerup' && pointer?.button === 0 && travelled < 4) on.click(...place(event));
  };
  canvas.addEventListener('pointerup', release);
  canvas.addEventListener('pointercancel', release);
  canvas.addEventListener('pointerleave', () => on.leave());
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    view.stop();
    const lines = event.deltaMode === 1 ? 20 : 1;
    zoomAt(Math.exp(Math.max(-120, Math.min(120, event.deltaY * lines)) * 0.0022), ...place(event));
  }, { passive: false });
}
