// SPDX-License-Identifier: MIT

import { OrthographicCamera, Vector3 } from 'three';

const half = Math.PI / 2;
const clamp = (value, low, high) => Math.min(high, Math.max(low, value));

/**
 * A parallel view that turns about a point: z stays upright, nothing gets smaller with distance, so that
 * sizes and angles can be compared.
 *
 * Plain data (target, azimuth, elevation, halfHeight) plus the three.js camera that follows from it.
 */
export class View {
  constructor(mesh, changed) {
    this.mesh = mesh;
    this.changed = changed;
    this.planar = mesh.dimension === 2;
    this.camera = new OrthographicCamera();
    this.aspect = 1;
    this.fitted = true;  // follow the size of the window until someone moves the camera
    Object.assign(this, this.home(), { target: [0, 0, 0], halfHeight: 1 });
  }

  /** From where a mesh is seen at first: from above if planar, else a bit from all sides, most from the broad one. */
  home() {
    if (this.planar) return { azimuth: -half, elevation: half };
    const { low, high } = this.mesh.box;
    const extent = high.map((value, axis) => value - low[axis]);
    const longest = Math.max(...extent) || 1;
    const [x, y, z] = extent.map((value) => 1 + 1.6 * (1 - value / longest));
    const eye = [0.62 * x, -1.05 * y, 0.68 * z];
    return {
      azimuth: Math.atan2(eye[1], eye[0]),
      elevation: Math.atan2(eye[2], Math.hypot(eye[0], eye[1])),
    };
  }

  /** Unit vectors: to the right and up on the screen, and towards the eye. */
  axes() {
    const { azimuth: a, elevation: e } = this;
    const eye = [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
    const up = [-Math.sin(e) * Math.cos(a), -Math.sin(e) * Math.sin(a), Math.cos(e)];
    const right = [-Math.sin(a), Math.cos(a), 0];
    return { right, up, eye };
  }

  /** Brings the three.js camera to a viewport of the given aspect. */
  cameraFor(aspect) {
    const { camera, mesh, target, halfHeight } = this;
    const { up, eye } = this.axes();
    const reach = 3 * mesh.box.diagonal;
    camera.up.fromArray(up);
    camera.position.fromArray(target).addScaledVector(new Vector3().fromArray(eye), reach);
    camera.lookAt(...target);
    camera.top = halfHeight;
    camera.bottom = -halfHeight;
    camera.right = halfHeight * aspect;
    camera.left = -camera.right;
    camera.near = 0;
    camera.far = 2 * reach;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    return camera;
  }

  set(patch, { keepFitted = false } = {}) {
    Object.assign(this, patch);
    this.elevation = clamp(this.elevation, -half, half);
    if (!keepFitted) this.fitted = false;
    this.changed();
  }

  turn(dx, dy) {
    if (this.planar) return;
    this.set({ azimuth: this.azimuth - dx * 0.008, elevation: this.elevation + dy * 0.008 });
  }

  /** Moves what is seen by so many screen pixels. */
  pan(dx, dy, height) {
    const { right, up } = this.axes();
    const unit = (2 * this.halfHeight) / height;
    this.set({ target: this.target.map((t, i) => t - right[i] * dx * unit + up[i] * dy * unit) });
  }

  /** @param x, y  what stays in place, from the middle of the viewport, in half heights */
  zoom(factor, x = 0, y = 0) {
    const { right, up } = this.axes();
    const size = clamp(this.halfHeight * factor, 1e-6 * this.mesh.box.diagonal, 5 * this.mesh.box.diagonal);
    const shift = this.halfHeight - size;
    this.set({ halfHeight: size, target: this.target.map((t, i) => t + (right[i] * x + up[i] * y) * shift) });
  }

  /** The target and half height that show the whole mesh. */
  whole(pose = this) {
    const { right, up } = View.prototype.axes.call(pose);
    const { before, after, vertexCount } = this.mesh;
    const step = Math.max(1, Math.floor(vertexCount / 50000));
    let left = Infinity, rightmost = -Infinity, bottom = Infinity, top = -Infinity;
    for (const points of after ? [before, after] : [before]) {
      for (let i = 0; i < vertexCount; i += step) {
        const p = 4 * i;
        const x = points[p] * right[0] + points[p + 1] * right[1];
        const y = points[p] * up[0] + points[p + 1] * up[1] + points[p + 2] * up[2];
        left = Math.min(left, x);
        rightmost = Math.max(rightmost, x);
        bottom = Math.min(bottom, y);
        top = Math.max(top, y);
      }
    }
    if (!(rightmost >= left)) return { target: [0, 0, 0], halfHeight: 1 };
    const x = (left + rightmost) / 2;
    const y = (bottom + top) / 2;
    const size = Math.max((top - bottom) / 2, (rightmost - left) / 2 / this.aspect) * 1.08;
    return { target: right.map((r, i) => r * x + up[i] * y), halfHeight: size || 1 };
  }

  fit() {
    this.stop();
    this.set({ ...this.whole() }, { keepFitted: true });
    this.fitted = true;
  }

  get flying() {
    return this.flight !== undefined;
  }

  stop() {
    if (this.flight !== undefined) cancelAnimationFrame(this.flight);
    this.flight = undefined;
  }

  /** Moves smoothly to another pose: any of target, halfHeight, azimuth, elevation. */
  fly(pose, { fitted = false } = {}) {
    this.stop();
    const from = { target: this.target, halfHeight: this.halfHeight, azimuth: this.azimuth, elevation: this.elevation };
    const to = { ...from, ...pose };
    to.azimuth = from.azimuth + turnOf(to.azimuth - from.azimuth);
    const finish = () => {
      this.flight = undefined;
      this.set(to, { keepFitted: fitted });
      if (fitted) this.fitted = true;
    };
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) return finish();
    const start = performance.now();
    const step = (now) => {
      const t = clamp((now - start) / 450, 0, 1);
      if (t >= 1) return finish();
      const s = t * t * (3 - 2 * t);
      const between = (a, b) => a + (b - a) * s;
      this.set({
        target: from.target.map((a, i) => between(a, to.target[i])),
        halfHeight: from.halfHeight * (to.halfHeight / from.halfHeight) ** s,
        azimuth: between(from.azimuth, to.azimuth),
        elevation: between(from.elevation, to.elevation),
      });
      this.flight = requestAnimationFrame(step);
    };
    this.flight = requestAnimationFrame(step);
  }
}

/** The same turn the short way round. */
function turnOf(angle) {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}

/** Azimuth and elevation that look along a direction, which points towards the eye. */
export function poseAlong([x, y, z]) {
  const flat = Math.hypot(x, y);
  return { azimuth: flat > 1e-9 ? Math.atan2(y, x) : -half, elevation: Math.atan2(z, flat) };
}
