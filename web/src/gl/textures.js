// SPDX-License-Identifier: MIT

import {
  DataTexture, FloatType, NearestFilter, RGBAFormat, RGBAIntegerFormat, UnsignedByteType,
} from 'three';
import { middlesOfCells, padded, rowLength } from '../model/mesh.js';
import { colourTable } from '../model/colour.js';

function finish(texture) {
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.generateMipmaps = false;
  texture.needsUpdate = true;
  return texture;
}

function floatTexture(values) {
  return finish(new DataTexture(values, rowLength, values.length / 4 / rowLength, RGBAFormat, FloatType));
}

/** Textures of points, and of the middles of cells, made when first asked for; the latest few are kept. */
export class PointTextures {
  constructor(mesh) {
    this.mesh = mesh;
    this.points = new Map();
    this.middles = new Map();
  }

  ofPoints(points) {
    return this.#get(this.points, points, () => floatTexture(points));
  }

  ofMiddles(points) {
    return this.#get(this.middles, points, () => floatTexture(middlesOfCells(this.mesh, points)));
  }

  #get(kept, points, make) {
    const texture = kept.get(points) ?? make();
    kept.delete(points);
    kept.set(points, texture);
    const [oldest] = kept.keys();
    if (kept.size > 6) {
      kept.get(oldest).dispose();
      kept.delete(oldest);
    }
    return texture;
  }

  dispose() {
    for (const kept of [this.points, this.middles]) for (const texture of kept.values()) texture.dispose();
  }
}

/** Per cell: byte before, byte after, visibility, unused. */
export function cellTexture(cellCount) {
  const data = new Uint8Array(4 * padded(cellCount));
  const texture = new DataTexture(data, rowLength, data.length / 4 / rowLength, RGBAIntegerFormat, UnsignedByteType);
  texture.internalFormat = 'RGBA8UI';
  return finish(texture);
}

export function colourTexture() {
  return finish(new DataTexture(colourTable(), 256, 1, RGBAFormat, UnsignedByteType));
}
