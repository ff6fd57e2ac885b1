// SPDX-License-Identifier: MIT

import { facesOf, kinds } from './kinds.js';

/**
 * The faces of a mesh, each with the one or two cells that it bounds.
 *
 * Faces are found equal by their number of vertices and the three lowest of these. A surface cell is a face of its own; where it
 * lies on a volume cell it is that face's other side, so that the two are never drawn
 * into each other. `other` is -1 where there is none.
 */
export function findFaces(mesh) {
  const total = countFaces(mesh);
  const faces = {
    count: 0,
    cell: new Int32Array(total),
    side: new Uint8Array(total),  // which face of the cell
    other: new Int32Array(total).fill(-1),
    otherSide: new Uint8Array(total),
  };
  if (mesh.type !== 'volume') {
    for (let cell = 0; cell < mesh.cellCount; ++cell) faces.cell[faces.count++] = cell;
    return faces;
  }

  const find = makeTable(total);
  const visit = (volume) => {
    for (let cell = 0; cell < mesh.cellCount; ++cell) {
      const kind = kinds[mesh.kind[cell]];
      if (kind.volume !== volume) continue;
      const own = facesOf(mesh, cell);
      for (let side = 0; side < own.length; ++side) {
        const known = find(mesh.vertices, mesh.first[cell], own[side], faces.count);
        if (known === faces.count) {
          faces.cell[known] = cell;
          faces.side[known] = side;
          ++faces.count;
        } else if (faces.other[known] < 0) {
          faces.other[known] = cell;
          faces.otherSide[known] = side;
        }
        // A surface cell between two volume cells is not drawn: their faces are.
      }
    }
  };
  visit(true);
  visit(false);
  return faces;
}

function countFaces(mesh) {
  let total = 0;
  for (let cell = 0; cell < mesh.cellCount; ++cell) total += facesOf(mesh, cell).length;
  return total;
}

/** A hash table of faces: the number of an equal face found before, or `next` if there is none. */
function makeTable(total) {
  let size = 16;
  while (size < 2 * total) size *= 2;
  const slots = new Int32Array(size).fill(-1);
  const keys = new Uint32Array(4 * total);
  return (vertices, first, corners, next) => {
    let a = vertices[first + corners[0]];
    let b = vertices[first + corners[1]];
    let c = vertices[first + corners[2]];
    let t;
    if (a > b) { t = a; a = b; b = t; }
    if (b > c) { t = b; b = c; c = t; }
    if (a > b) { t = a; a = b; b = t; }
    if (corners.length === 4) {
      const d = vertices[first + corners[3]];
      if (d < a) { c = b; b = a; a = d; } else if (d < b) { c = b; b = d; } else if (d < c) c = d;
    }
    let slot = (Math.imul(a, 73856093) ^ Math.imul(b, 19349663) ^ Math.imul(c, 83492791)) >>> 0;
    slot = (slot ^ (slot >>> 15)) & (size - 1);
    for (;; slot = (slot + 1) & (size - 1)) {
      const known = slots[slot];
      if (known < 0) break;
      const k = 4 * known;
      if (keys[k] === a && keys[k + 1] === b && keys[k + 2] === c && keys[k + 3] === corners.length) return known;
    }
    slots[slot] = next;
    keys[4 * next] = a;
    keys[4 * next + 1] = b;
    keys[4 * next + 2] = c;
    keys[4 * next + 3] = corners.length;
    return next;
  };
}

/**
 * Corners of the triangles to draw: two integers each, the vertex and 8 cell + edges.
 *
 * Bit i of edges says that the side of the triangle opposite its corner i is an edge of the cell, and
 * not the diagonal of a quad.
 * @param shown  per cell, 0 if it is hidden
 * @param all    all faces of the cells shown, not only those that bound them (shrunk cells)
 */
export function cornersOfFaces(mesh, faces, shown, all) {
  const chosen = chooseFaces(mesh, faces, shown, all);
  let triangles = 0;
  for (let i = 0; i < chosen.length; i += 2) {
    triangles += facesOf(mesh, chosen[i])[chosen[i + 1]].length - 2;
  }
  const corners = new Uint32Array(6 * triangles);
  let n = 0;
  for (let i = 0; i < chosen.length; i += 2) {
    const cell = chosen[i];
    const face = facesOf(mesh, cell)[chosen[i + 1]];
    const first = mesh.first[cell];
    if (face.length > 4) {
      n = putPolygon(corners, n, mesh, face.map((corner) => mesh.vertices[first + corner]), cell);
      continue;
    }
    let a = mesh.vertices[first + face[0]];
    let b = mesh.vertices[first + face[1]];
    let c = mesh.vertices[first + face[2]];
    if (face.length === 3) {
      n = putTriangle(corners, n, a, b, c, 8 * cell + 0b111);
      continue;
    }
    let d = mesh.vertices[first + face[3]];
    if (foldsAtDiagonal(mesh.before, a, b, c, d) || (mesh.after && foldsAtDiagonal(mesh.after, a, b, c, d))) {
      [a, b, c, d] = [b, c, d, a];
    }
    n = putTriangle(corners, n, a, b, c, 8 * cell + 0b101);
    n = putTriangle(corners, n, a, c, d, 8 * cell + 0b011);
  }
  return corners;
}

/** A fan around the first corner from which no triangle folds over the others, around the first of all if each has one. */
function putPolygon(corners, n, mesh, ring, cell) {
  const states = [mesh.before, mesh.after].filter(Boolean);
  const turned = (start) => ring.map((_, i) => ring[(start + i) % ring.length]);
  const start = ring.findIndex((_, i) => states.every((points) => !foldsInFan(points, turned(i))));
  const fan = turned(Math.max(0, start));
  const last = ring.length - 2;
  for (let i = 1; i <= last; ++i) {
    const edges = 0b001 | (i === last ? 0b010 : 0) | (i === 1 ? 0b100 : 0);
    n = putTriangle(corners, n, fan[0], fan[i], fan[i + 1], 8 * cell + edges);
  }
  return n;
}

function foldsInFan(points, ring) {
  const from = (v) => [0, 1, 2].map((axis) => points[4 * v + axis] - points[4 * ring[0] + axis]);
  const normals = [];
  for (let i = 1; i + 1 < ring.length; ++i) {
    const [a, b] = [from(ring[i]), from(ring[i + 1])];
    normals.push([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]);
  }
  const sum = [0, 1, 2].map((axis) => normals.reduce((total, normal) => total + normal[axis], 0));
  return normals.some((normal) => normal[0] * sum[0] + normal[1] * sum[1] + normal[2] * sum[2] < 0);
}

/** Whether a quad is concave so that its triangles beside the diagonal from a to c would cover more than the quad. */
function foldsAtDiagonal(points, a, b, c, d) {
  const at = (v, axis) => points[4 * v + axis] - points[4 * a + axis];
  const [bx, by, bz] = [at(b, 0), at(b, 1), at(b, 2)];
  const [cx, cy, cz] = [at(c, 0), at(c, 1), at(c, 2)];
  const [dx, dy, dz] = [at(d, 0), at(d, 1), at(d, 2)];
  return (by * cz - bz * cy) * (cy * dz - cz * dy) + (bz * cx - bx * cz) * (cz * dx - cx * dz) +
    (bx * cy - by * cx) * (cx * dy - cy * dx) < 0;
}

function putTriangle(corners, n, a, b, c, cellAndEdges) {
  corners[n] = a;
  corners[n + 2] = b;
  corners[n + 4] = c;
  corners[n + 1] = corners[n + 3] = corners[n + 5] = cellAndEdges;
  return n + 6;
}

/** Pairs of a cell and one of its sides. */
function chooseFaces(mesh, faces, shown, all) {
  const chosen = new Int32Array(4 * faces.count);
  let n = 0;
  const put = (cell, side) => {
    chosen[n++] = cell;
    chosen[n++] = side;
  };
  for (let i = 0; i < faces.count; ++i) {
    const cell = faces.cell[i];
    const other = faces.other[i];
    const one = shown[cell] > 0;
    const two = other >= 0 && shown[other] > 0;
    if (one && two) {
      if (all) {
        put(cell, faces.side[i]);
        put(other, faces.otherSide[i]);
      } else if (!kinds[mesh.kind[other]].volume) {
        put(cell, faces.side[i]);  // a surface cell on the boundary
      }
    } else if (one) {
      put(cell, faces.side[i]);
    } else if (two) {
      put(other, faces.otherSide[i]);
    }
  }
  return chosen.subarray(0, n);
}
