// SPDX-License-Identifier: MIT

import {
  BufferAttribute, BufferGeometry, Color, GLSL3, InstancedBufferAttribute, InstancedBufferGeometry, Mesh,
  Points, RawShaderMaterial, Scene as ThreeScene, Sphere, Vector2, Vector3, WebGLRenderer, WebGLRenderTarget,
} from 'three';
import { CannotShow } from '../cannot_show.js';
import { cornersOfFaces, findFaces } from '../model/faces.js';
import { edgesOf } from '../model/kinds.js';
import { undefinedColour, undefinedStripe } from '../model/colour.js';
import { verticesShown } from '../model/visibility.js';
import { cellTexture, colourTexture, PointTextures } from './textures.js';
import * as shaders from './shaders.js';

/**
 * Whether edges of what is drawn can be smoothed in time. A processor that stands in for graphics hardware takes more
 * than twice as long with it, which is seconds for large meshes; the lines between cells are smooth anyway.
 */
function canSmooth(mesh) {
  return mesh.cellCount < 50000 || !isSoftware();
}

function isSoftware() {
  const context = document.createElement('canvas').getContext('webgl2');
  if (!context) return true;
  let name = context.getParameter(context.RENDERER);
  if (/^WebKit/.test(name)) {  // what Chromium says instead of the name
    const extension = context.getExtension('WEBGL_debug_renderer_info');
    if (extension) name = context.getParameter(extension.UNMASKED_RENDERER_WEBGL);
  }
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

/** Made once: the first context of a page can take most of a second. */
function contextOf(canvas, mesh) {
  const context = canvas.getContext('webgl2', { antialias: canSmooth(mesh) });
  if (!context) throw new CannotShow('The interactive view needs WebGL 2, which this browser does not offer.');
  return context;
}

const unit = (bytes) => new Vector3(...bytes).divideScalar(255);

/**
 * What is drawn: cells, edges of the shape, marks on held vertices, arrows, the outline of the
 * selected cell. It is told everything; it decides nothing.
 */
export class Scene {
  /** @throws CannotShow  there is no WebGL 2 */
  constructor(canvas, mesh) {
    this.mesh = mesh;
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, context: contextOf(canvas, mesh) });
    this.renderer.autoClear = false;
    this.textures = new PointTextures(mesh);
    this.cells = cellTexture(mesh.cellCount);
    this.uniforms = this.#makeUniforms();
    this.scene = new ThreeScene();
    this.numbersScene = new ThreeScene();
    this.numbers = new WebGLRenderTarget(1, 1, { samples: 0 });
    this.numbersFresh = false;
    this.#makeCells();
    this.lines = this.#makeLines(2.2, 6, 4e-4);
    this.arrows = this.#makeLines(1.7, 9, 8e-4, { arrows: { value: true } });
    this.outlines = [this.#makeLines(6, 6, 0), this.#makeLines(2.6, 6, 0)];
    for (const outline of this.outlines) {
      outline.material.depthTest = false;
      outline.renderOrder = 3;
    }
    this.marks = this.#makeMarks();
  }

  #makeUniforms() {
    const u = (value) => ({ value });
    return {
      beforePoints: u(this.textures.ofPoints(this.mesh.before)),
      fromPoints: u(null),
      toPoints: u(null),
      fromMiddles: u(null),
      toMiddles: u(null),
      mixing: u(0),
      progress: u(0),
      shrink: u(1),
      cells: u(this.cells),
      colours: u(colourTexture()),
      lowerIsBetter: u(false),
      hasValues: u(false),
      shading: u(this.mesh.dimension === 2 ? 0 : 1),
      planar: u(this.mesh.dimension === 2),
      showEdges: u(true),
      pixelRatio: u(1),
      viewport: u(new Vector2()),
      hovered: u(-1),
      edgeColour: u(new Vector3()),
      fadedColour: u(new Vector3()),
      plainColour: u(new Vector3()),
      rim: u(new Vector3()),
      undefinedColour: u(unit(undefinedColour)),
      undefinedStripe: u(unit(undefinedStripe)),
      arrowScale: u(1),
      holdColours: u(Array.from({ length: 6 }, () => new Vector3())),
    };
  }

  #material(vertexShader, fragmentShader, own = {}) {
    return new RawShaderMaterial({
      glslVersion: GLSL3, vertexShader, fragmentShader, side: 2, uniforms: { ...this.uniforms, ...own },
    });
  }

  #makeCells() {
    const geometry = new BufferGeometry();
    this.body = new Mesh(geometry, this.#material(shaders.cellsVertex, shaders.cellsFragment));
    this.numbersBody = new Mesh(geometry, this.#material(shaders.cellsVertex, shaders.numbersFragment));
    for (const body of [this.body, this.numbersBody]) body.frustumCulled = false;
    this.scene.add(this.body);
    this.numbersScene.add(this.numbersBody);
  }

  #makeLines(width, corners, lift, own = {}) {
    const material = this.#material(shaders.linesVertex, shaders.plainFragment, {
      colour: { value: new Vector3() },
      width: { value: width },
      lift: { value: lift },
      arrows: { value: false },
      ...own,
    });
    const lines = new Mesh(new InstancedBufferGeometry(), material);
    lines.userData = { corners, width };
    lines.frustumCulled = false;
    lines.visible = false;
    lines.renderOrder = 1;
    this.scene.add(lines);
    return lines;
  }

  #makeMarks() {
    const marks = new Points(new BufferGeometry(),
      this.#material(shaders.marksVertex, shaders.marksFragment, { lift: { value: 1e-3 } }));
    marks.frustumCulled = false;
    marks.visible = false;
    marks.renderOrder = 2;
    this.scene.add(marks);
    return marks;
  }

  /** @param colours  of the theme, each an [r, g, b] in bytes */
  setTheme(colours) {
    const { uniforms } = this;
    this.clearColour = new Color(`rgb(${colours.canvas.join(',')})`);
    this.renderer.setClearColor(this.clearColour);
    uniforms.edgeColour.value = unit(colours.edge);
    uniforms.fadedColour.value = unit(colours.faded);
    uniforms.plainColour.value = unit(colours.plain);
    uniforms.rim.value = unit(colours.rim);
    uniforms.holdColours.value = colours.holds.map(unit);
    this.lines.material.uniforms.colour.value = unit(colours.feature);
    this.arrows.material.uniforms.colour.value = unit(colours.arrow);
    this.outlines[0].material.uniforms.colour.value = unit([15, 18, 24]);
    this.outlines[1].material.uniforms.colour.value = unit([255, 255, 255]);
  }

  setMetric(metric) {
    const { data } = this.cells.image;
    for (let i = 0; i < this.mesh.cellCount; ++i) {
      data[4 * i] = metric ? metric.before[i] : 0;
      data[4 * i + 1] = metric ? metric.after[i] : 0;
    }
    this.cells.needsUpdate = true;
    this.uniforms.hasValues.value = Boolean(metric);
    this.uniforms.lowerIsBetter.value = metric?.better === 'lower';
  }

  /** @param shrunk  cells have gaps between them, so that their inner faces are seen */
  setVisible(visible, shrunk) {
    const { data } = this.cells.image;
    for (let i = 0; i < this.mesh.cellCount; ++i) data[4 * i + 2] = visible.of[i];
    this.cells.needsUpdate = true;
    this.numbersFresh = false;
    const volume = this.mesh.type === 'volume';
    if (this.faces && !volume) return;
    this.faces ??= findFaces(this.mesh);
    // All cells of a surface stay in the buffer; the texture hides them.
    const shown = volume ? visible.of : new Uint8Array(this.mesh.cellCount).fill(1);
    this.#setCorners(cornersOfFaces(this.mesh, this.faces, shown, volume && shrunk));
  }

  /** Whether a cell has a face that bounds no other cell. */
  onBoundary(cell) {
    const { faces } = this;
    for (let i = 0; i < faces.count; ++i) {
      if (faces.other[i] < 0 && faces.cell[i] === cell) return true;
    }
    return false;
  }

  #setCorners(corners) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('corner', new BufferAttribute(corners, 2));
    geometry.setDrawRange(0, corners.length / 2);
    geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
    this.body.geometry.dispose();
    this.body.geometry = this.numbersBody.geometry = geometry;
    this.body.visible = this.numbersBody.visible = corners.length > 0;
  }

  #setEnds(lines, ends) {
    const geometry = new InstancedBufferGeometry();
    geometry.setAttribute('ends', new InstancedBufferAttribute(Uint32Array.from(ends), 2));
    geometry.instanceCount = ends.length / 2;
    geometry.setDrawRange(0, lines.userData.corners);
    lines.geometry.dispose();
    lines.geometry = geometry;
    lines.userData.count = ends.length / 2;
  }

  setFeatureEdges(ends) {
    this.#setEnds(this.lines, ends ?? []);
  }

  /** Arrows along the moves of the vertices of cells that are shown. */
  setArrows(visible) {
    const { mesh } = this;
    const used = verticesShown(mesh, visible);
    const tiny = 1e-7 * mesh.box.diagonal;
    const ends = [];
    for (let v = 0; v < mesh.vertexCount; ++v) {
      if (!used[v]) continue;
      const p = 4 * v;
      const move = Math.abs(mesh.after[p] - mesh.before[p]) + Math.abs(mesh.after[p + 1] - mesh.before[p + 1]) +
        Math.abs(mesh.after[p + 2] - mesh.before[p + 2]);
      if (move > tiny) ends.push(v, v);
    }
    this.#setEnds(this.arrows, ends);
  }

  setMarks(visible, hold) {
    const used = verticesShown(this.mesh, visible);
    const marks = [];
    for (let v = 0; v < hold.length; ++v) if (used[v] && hold[v] > 0 && hold[v] < 6) marks.push(v, hold[v]);
    const geometry = new BufferGeometry();
    geometry.setAttribute('mark', new BufferAttribute(Uint32Array.from(marks), 2));
    geometry.setDrawRange(0, marks.length / 2);
    this.marks.geometry.dispose();
    this.marks.geometry = geometry;
    this.marks.userData.count = marks.length / 2;
  }

  setSelected(cell) {
    const { mesh } = this;
    const ends = cell < 0 ? [] : edgesOf(mesh, cell).flatMap((edge) =>
      edge.map((corner) => mesh.vertices[mesh.first[cell] + corner]));
    for (const outline of this.outlines) {
      this.#setEnds(outline, ends);
      outline.visible = cell >= 0;
    }
  }

  /** @param look  {edges, features, marks, vectors, vectorScale, shrink, hovered} of the state */
  setLook(look) {
    const { uniforms } = this;
    uniforms.showEdges.value = look.edges;
    uniforms.hovered.value = look.hovered;
    uniforms.arrowScale.value = look.vectorScale;
    uniforms.shrink.value = look.shrink;
    this.lines.visible = look.features && this.lines.userData.count > 0;
    this.marks.visible = look.marks && this.marks.userData.count > 0;
    this.arrows.visible = look.vectors && this.arrows.userData.count > 0;
  }

  resize(width, height, pixelRatio) {
    this.renderer.setPixelRatio(pixelRatio);
    this.renderer.setSize(width, height, false);
    this.uniforms.pixelRatio.value = pixelRatio;
    this.numbers.setSize(Math.max(1, width), Math.max(1, height));
  }

  /**
   * @param panes  {viewport, scissor: {x, y, width, height} in CSS pixels from the upper left, from, to, mixing, progress}
   * @param view   a View, which gives the camera
   */
  render(panes, view, canvasHeight) {
    const { renderer } = this;
    renderer.setRenderTarget(null);
    renderer.setScissorTest(true);
    for (const pane of panes) {
      const { viewport: v, scissor: s } = pane;
      if (s.width < 1 || s.height < 1) continue;
      this.#usePane(pane);
      renderer.setViewport(v.x, canvasHeight - v.y - v.height, v.width, v.height);
      renderer.setScissor(s.x, canvasHeight - s.y - s.height, s.width, s.height);
      renderer.clear();
      renderer.render(this.scene, view.cameraFor(v.width / v.height));
    }
    this.numbersFresh = false;
  }

  #usePane({ viewport, from, to, mixing, progress }) {
    const { uniforms, textures } = this;
    const ratio = uniforms.pixelRatio.value;
    uniforms.fromPoints.value = textures.ofPoints(from);
    uniforms.toPoints.value = textures.ofPoints(to);
    if (uniforms.shrink.value < 1) {
      uniforms.fromMiddles.value = textures.ofMiddles(from);
      uniforms.toMiddles.value = textures.ofMiddles(to);
    }
    uniforms.mixing.value = mixing;
    uniforms.progress.value = progress;
    uniforms.viewport.value.set(viewport.width * ratio, viewport.height * ratio);
    for (const lines of [this.lines, this.arrows, ...this.outlines]) {
      lines.material.uniforms.width.value = lines.userData.width * ratio;
    }
  }

  /** Number of the cell seen at a place of the canvas in CSS pixels, -1 if none. */
  pick(panes, view, x, y) {
    const { renderer, numbers } = this;
    if (!this.numbersFresh) {
      renderer.setClearColor(0, 0);
      for (const pane of panes) {
        const { viewport: v, scissor: s } = pane;
        if (s.width < 1 || s.height < 1) continue;
        this.#usePane(pane);
        numbers.viewport.set(v.x, numbers.height - v.y - v.height, v.width, v.height);
        numbers.scissor.set(s.x, numbers.height - s.y - s.height, s.width, s.height);
        numbers.scissorTest = true;
        renderer.setRenderTarget(numbers);
        renderer.clear();
        renderer.render(this.numbersScene, view.cameraFor(v.width / v.height));
      }
      renderer.setRenderTarget(null);
      renderer.setClearColor(this.clearColour, 1);
      this.numbersFresh = true;
    }
    if (x < 0 || y < 0 || x >= numbers.width || y >= numbers.height) return -1;
    const four = new Uint8Array(4);
    renderer.readRenderTargetPixels(numbers, Math.floor(x), numbers.height - 1 - Math.floor(y), 1, 1, four);
    return (four[0] | (four[1] << 8) | (four[2] << 16) | (four[3] << 24)) - 1;
  }

  /** Waits until what was asked for is drawn. */
  finish() {
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  dispose() {
    for (const object of [this.body, this.numbersBody, this.lines, this.arrows, this.marks, ...this.outlines]) {
      object.geometry.dispose();
      object.material.dispose();
    }
    this.cells.dispose();
    this.uniforms.colours.value.dispose();
    this.textures.dispose();
    this.numbers.dispose();
    this.renderer.dispose();
  }
}
