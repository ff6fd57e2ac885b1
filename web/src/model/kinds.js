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
  { name: 'polygon', volume: false },  // every one has a size of its own
];

function edgesOfFaces(faces) {
  const seen = new Map();
  for (const face of faces) {
    face.forEach((a, i) => {
      const b = face[(i + 1) % face.length];
      seen.set(`${Math.min(a, b)} ${Math.max(a, b)}`, [a, b]);
    });
  }
  return [...seen.values()];
}

const edgesOfKind = kinds.map(({ faces }) => faces && edgesOfFaces(faces));
const facesOfPolygons = [];  // by the number of corners

/** Faces of a cell as lists of its corners. */
export function facesOf(mesh, cell) {
  const { faces } = kinds[mesh.kind[cell]];
  if (faces) return faces;
  const size = mesh.first[cell + 1] - mesh.first[cell];
  return (facesOfPolygons[size] ??= [Array.from({ length: size }, (_, corner) => corner)]);
}

/** Edges of a cell as pairs of its corners, each once. */
export const edgesOf = (mesh, cell) => edgesOfKind[mesh.kind[cell]] ?? edgesOfFaces(facesOf(mesh, cell));

/** What `vertex_hold` says, by number. */
export const holds = ['free', 'fixed', 'slides on a curve', 'slides on a surface', 'tied', 'held'];
