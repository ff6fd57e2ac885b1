// SPDX-License-Identifier: MIT

/**
 * Kinds of cells by their number in the data, in VTK's order of vertices.
 * A surface cell is its own and only face.
 */
export const kinds = [
  { name: 'triangle', vertices: 3, volume: false, faces: [[0, 1, 2]] },
  { name: 'quad', vertices: 4, volume: false, faces: [[0, 1, 2, 3]] },
  { name: 'tet', vertices: 4, volume: true, faces: [[0, 1, 3], [1, 2, 3], [2, 0, 3], [0, 2, 1]] },
  {
    name: 'pyramid', vertices: 5, volume: true,
    faces: [[0, 3, 2, 1], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
  },
  {
    name: 'wedge', vertices: 6, volume: true,
    faces: [[0, 1, 2], [3, 5, 4], [0, 3, 4, 1], [1, 4, 5, 2], [2, 5, 3, 0]],
  },
  {
    name: 'hex', vertices: 8, volume: true,
    faces: [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]],
  },
];

/** Edges of each kind as pairs of corners, each once. */
export const edgesOfKind = kinds.map(({ faces }) => {
  const seen = new Map();
  for (const face of faces) {
    face.forEach((a, i) => {
      const b = face[(i + 1) % face.length];
      seen.set(`${Math.min(a, b)} ${Math.max(a, b)}`, [a, b]);
    });
  }
  return [...seen.values()];
});

/** What `vertex_hold` says, by number. */
export const holds = ['free', 'fixed', 'slides on a curve', 'slides on a surface', 'tied', 'held'];
