// SPDX-License-Identifier: MIT

import { holds, kinds } from './kinds.js';
import { middleOfCell } from './mesh.js';

/** All that is known of a cell, for people. `details` as from mesh.details(). */
export function describeCell(mesh, details, cell) {
  const vertices = [...mesh.vertices.subarray(mesh.first[cell], mesh.first[cell + 1])];
  const flags = details.flags[cell];
  return {
    name: details.cellName(cell),
    kind: kinds[mesh.kind[cell]].name,
    group: details.groupName(cell),
    vertices: vertices.map(details.vertexName),
    held: details.hasHolds ? holdSummary(vertices.map((v) => details.hold[v])) : null,
    flags: [
      flags & 1 && (flags & 2 ? 'inverted before and after' : 'inverted before'),
      flags & 2 && !(flags & 1) && 'inverted after',
      flags & 4 && 'wall layer',
    ].filter(Boolean),
    inverted: Boolean(flags & 3),
    middle: mesh.toFile(middleOfCell(mesh, mesh.after ?? mesh.before, cell)),
    largestMove: mesh.after ? Math.max(...vertices.map((v) => moveOf(mesh, v))) : null,
  };
}

function moveOf({ before, after }, vertex) {
  return Math.hypot(...[0, 1, 2].map((axis) => after[4 * vertex + axis] - before[4 * vertex + axis]));
}

/** "3 fixed, 1 slides on a curve"; all free: "all free". */
export function holdSummary(codes) {
  if (codes.every((code) => code === 0)) return 'all free';
  return holds
    .map((name, code) => [codes.filter((one) => one === code).length, name])
    .filter(([n]) => n > 0)
    .sort(([, a], [, b]) => (a === 'free') - (b === 'free'))
    .map(([n, name]) => `${n} ${name}`)
    .join(', ');
}
