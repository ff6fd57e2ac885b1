// SPDX-License-Identifier: MIT

import { middlesOfCells } from './mesh.js';
import { rankOfByte, worstRange } from './histogram.js';

/** What `shown` says of a cell. */
export const hidden = 0, shown = 1, faded = 2;

/**
 * Which cells are seen. The same cells are seen before and after and between, so that pictures
 * compare: a cut goes by where the middles were before.
 *
 * @param filter  {range, show, others, cut} of the state
 * @param listed  numbers of the cells in the list of the worst
 * @return        {of: hidden, shown or faded per cell, count: of those shown}
 */
export function findVisible(mesh, metric, filter, listed) {
  const of = new Uint8Array(mesh.cellCount).fill(shown);
  const rest = filter.others === 'fade' ? faded : hidden;
  if (filter.show === 'listed') {
    of.fill(rest);
    for (const cell of listed) of[cell] = shown;
  } else if (filter.show !== 'all' && metric) {
    keepRange(of, metric, metric.after, worstRange(metric, metric.after, Number(filter.show)), rest);
  }
  if (filter.range && metric) keepRange(of, metric, metric[filter.rangeOf], filter.range, rest);
  if (filter.cut) keepBehind(of, cellMiddles(mesh), filter.cut);

  let count = 0;
  for (let i = 0; i < of.length; ++i) count += of[i] === shown;
  return { of, count };
}

function keepRange(of, metric, values, [low, high], rest) {
  const keep = Uint8Array.from({ length: 256 }, (_, byte) => {
    const rank = rankOfByte(metric, byte);
    return rank >= low && rank <= high;
  });
  for (let i = 0; i < of.length; ++i) if (!keep[values[i]]) of[i] = rest;
}

/** Hides the cells whose middle is beyond the plane. */
function keepBehind(of, middles, { normal: [x, y, z], distance }) {
  for (let i = 0; i < of.length; ++i) {
    const m = 4 * i;
    if (x * middles[m] + y * middles[m + 1] + z * middles[m + 2] > distance) of[i] = hidden;
  }
}

const middlesOfMesh = new WeakMap();

/** Middles of the cells before, four floats each. */
export function cellMiddles(mesh) {
  if (!middlesOfMesh.has(mesh)) middlesOfMesh.set(mesh, middlesOfCells(mesh, mesh.before));
  return middlesOfMesh.get(mesh);
}

/** The least and greatest distance of a middle along a direction. */
export function spanAlong(mesh, [x, y, z]) {
  const middles = cellMiddles(mesh);
  let low = Infinity;
  let high = -Infinity;
  for (let i = 0; i < mesh.cellCount; ++i) {
    const m = 4 * i;
    const distance = x * middles[m] + y * middles[m + 1] + z * middles[m + 2];
    if (distance < low) low = distance;
    if (distance > high) high = distance;
  }
  return [low, high];
}

/** Numbers of the vertices of cells that are shown. */
export function verticesShown(mesh, visible) {
  const used = new Uint8Array(mesh.vertexCount);
  for (let cell = 0; cell < mesh.cellCount; ++cell) {
    if (visible.of[cell] !== shown) continue;
    for (let i = mesh.first[cell]; i < mesh.first[cell + 1]; ++i) used[mesh.vertices[i]] = 1;
  }
  return used;
}
