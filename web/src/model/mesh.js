// SPDX-License-Identifier: MIT

import { kinds } from './kinds.js';

/**
 * Texels per row of the textures that hold one entry per vertex or per cell. Arrays that
 * become such textures are padded to whole rows, so that they can be sent as they are.
 */
export const rowLength = 2048;
export const padded = (count) => Math.max(1, Math.ceil(count / rowLength)) * rowLength;

/**
 * A mesh decoded from a report: connectivity and points, and what can be asked of them later.
 *
 * Points are floats relative to the middle of the bounding box, four per vertex (the fourth
 * is 0). What the first picture does not need is a promise behind a function.
 */
export async function loadMesh(report, array) {
  const { mesh: description } = report;
  const [kind, cellVertices, points, moves, polygonSize] = await Promise.all(
    ['cell_kind', 'cell_vertices', 'points', 'moves', 'polygon_size'].map(array));
  if (!kind || !cellVertices || !points) throw new Error('the report holds no mesh');

  const first = findFirsts(kind, polygonSize ?? [], cellVertices.length);
  const vertexCount = points.length / 3;
  checkVertices(cellVertices, vertexCount);

  const middle = middleOfBox(points);
  const { scale, origin } = description.points;
  const before = localPoints(points, null, middle, scale);
  const after = moves ? localPoints(points, moves, middle, scale) : null;
  const stops = makeStops(description, before, after, async (k) => {
    const iterate = await array(`iterate_${k}`);
    if (!iterate) throw new Error(`the positions of iterate ${k} are missing`);
    return localPoints(points, iterate, middle, scale);
  });

  return {
    dimension: description.dimension,
    type: description.type,
    cellCount: kind.length,
    vertexCount,
    kind,
    first,
    vertices: cellVertices,
    before,
    after,
    stops,
    box: boxOf(before, vertexCount),
    /** Coordinates as in the file, of a local point. */
    toFile: (p) => p.map((value, i) => value + origin[i] + scale * middle[i]),
    metrics: description.metrics ?? [],
    metric: (name) => loadMetric(name, description, array, kind.length),
    details: () => loadDetails(report, array, kind.length, vertexCount),
    featureEdges: () => array('feature_edges'),
  };
}

/** Where the vertices of each cell begin, and where those of the last end. */
function findFirsts(kind, polygonSize, length) {
  const first = new Uint32Array(kind.length + 1);
  let polygons = 0;
  for (let i = 0; i < kind.length; ++i) {
    if (kind[i] >= kinds.length) throw new Error(`cell ${i} is of unknown kind ${kind[i]}`);
    const size = kinds[kind[i]].vertices ?? polygonSize[polygons++];
    if (!(size >= 3)) throw new Error(`polygon ${i} has no size, or less than three corners`);
    first[i + 1] = first[i] + size;
  }
  if (first[kind.length] !== length) {
    throw new Error(`the cells have ${first[kind.length]} corners, the data ${length}`);
  }
  return first;
}

function checkVertices(vertices, count) {
  for (let i = 0; i < vertices.length; ++i) {
    if (!(vertices[i] >= 0 && vertices[i] < count)) {
      throw new Error(`a cell uses vertex ${vertices[i]}, but the mesh has ${count} points`);
    }
  }
}

function middleOfBox(integers) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < integers.length; ++i) {
    const axis = i % 3;
    if (integers[i] < low[axis]) low[axis] = integers[i];
    if (integers[i] > high[axis]) high[axis] = integers[i];
  }
  return low.map((value, axis) => (integers.length ? Math.round((value + high[axis]) / 2) : 0));
}

function localPoints(integers, moves, middle, scale) {
  const count = integers.length / 3;
  const points = new Float32Array(4 * padded(count));
  for (let i = 0; i < count; ++i) {
    for (let axis = 0; axis < 3; ++axis) {
      const moved = moves ? moves[3 * i + axis] : 0;
      points[4 * i + axis] = scale * (integers[3 * i + axis] - middle[axis] + moved);
    }
  }
  return points;
}

export function boxOf(points, count) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < count; ++i) {
    for (let axis = 0; axis < 3; ++axis) {
      const value = points[4 * i + axis];
      if (value < low[axis]) low[axis] = value;
      if (value > high[axis]) high[axis] = value;
    }
  }
  const diagonal = count ? Math.hypot(...high.map((value, axis) => value - low[axis])) : 0;
  return { low, high, diagonal: diagonal || 1 };
}

/**
 * What the scrub slider runs through: before, the stored iterates between, after.
 * Each is {label, points()}; an iterate is decoded when first asked for.
 */
function makeStops(description, before, after, loadIterate) {
  const stops = [{ label: 'before', points: async () => before }];
  if (!after) return stops;
  (description.iterates ?? []).forEach((iteration, k) => {
    if (iteration === 0) return;  // the input again
    let points;
    stops.push({ label: `iterate ${iteration}`, points: () => (points ??= loadIterate(k)) });
  });
  stops.push({ label: 'after', points: async () => after });
  return stops;
}

async function loadMetric(name, description, array, cellCount) {
  const metric = (description.metrics ?? []).find((candidate) => candidate.name === name);
  if (!metric) throw new Error(`the report has no metric "${name}"`);
  const [before, after] = await Promise.all([array(`before_${name}`), array(`after_${name}`)]);
  const one = before ?? after;
  if (!one) throw new Error(`the values of metric "${name}" are missing`);
  for (const values of [before, after]) {
    if (values && values.length !== cellCount) {
      throw new Error(`${values.length} values of "${name}" for ${cellCount} cells`);
    }
  }
  return { ...metric, before: before ?? one, after: after ?? one };
}

/** Names, groups, holds and flags: what the panel of a cell shows. */
async function loadDetails(report, array, cellCount, vertexCount) {
  const [cellId, vertexId, group, hold, flags] = await Promise.all(
    ['cell_id', 'vertex_id', 'cell_group', 'vertex_hold', 'cell_flags'].map(array));
  const { cell_names: cellNames, vertex_names: vertexNames } = report.mesh;
  const name = (names, ids) => (i) => String(names?.[i] ?? ids?.[i] ?? i);
  return {
    cellName: name(cellNames, cellId),
    vertexName: name(vertexNames, vertexId),
    groupName: (cell) => (group?.[cell] ? report.groups?.[group[cell] - 1] ?? '' : ''),
    hold: hold ?? new Uint8Array(vertexCount),
    hasHolds: Boolean(hold?.some((value) => value > 0)),
    flags: flags ?? new Uint8Array(cellCount),
  };
}

/** Value of a metric from its byte; undefined (inverted or no size) is NaN. */
export const valueOfByte = (metric, byte) =>
  byte === 255 ? NaN : metric.low + ((metric.high - metric.low) * byte) / 254;

/** Mean of the corners of a cell. */
export function middleOfCell(mesh, points, cell) {
  const sum = [0, 0, 0];
  const start = mesh.first[cell];
  const end = mesh.first[cell + 1];
  for (let i = start; i < end; ++i) {
    for (let axis = 0; axis < 3; ++axis) sum[axis] += points[4 * mesh.vertices[i] + axis];
  }
  return sum.map((value) => value / (end - start));
}

/** Means of the corners of all cells, four floats each, padded to whole rows. */
export function middlesOfCells(mesh, points) {
  const middles = new Float32Array(4 * padded(mesh.cellCount));
  const { first, vertices } = mesh;
  for (let cell = 0; cell < mesh.cellCount; ++cell) {
    const start = first[cell];
    const end = first[cell + 1];
    let x = 0, y = 0, z = 0;
    for (let i = start; i < end; ++i) {
      const p = 4 * vertices[i];
      x += points[p];
      y += points[p + 1];
      z += points[p + 2];
    }
    const weight = 1 / (end - start);
    middles[4 * cell] = x * weight;
    middles[4 * cell + 1] = y * weight;
    middles[4 * cell + 2] = z * weight;
  }
  return middles;
}
