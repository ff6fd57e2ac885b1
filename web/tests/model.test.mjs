// SPDX-License-Identifier: MIT

import assert from 'node:assert/strict';
import test from 'node:test';
import { makeArrays } from '../src/data/decode.js';
import { holdSummary } from '../src/model/cell.js';
import { colourAt } from '../src/model/colour.js';
import { cornersOfFaces, findFaces } from '../src/model/faces.js';
import { worstRange } from '../src/model/histogram.js';
import { edgesOf, facesOf } from '../src/model/kinds.js';
import { loadMesh, valueOfByte } from '../src/model/mesh.js';
import { findVisible } from '../src/model/visibility.js';
import { number } from '../src/ui/format.js';
import { encodeReport } from './encode.mjs';
import { bar, oneOfEach, planarGrid } from './shapes.mjs';

async function load(shape, more) {
  const { report, data } = encodeReport(shape, more);
  return loadMesh(report, makeArrays(report.arrays, new Uint8Array(data)));
}
const filter = (more) => ({ range: null, rangeOf: 'after', show: 'all', others: 'hide', cut: null, ...more });

test('points come back to the resolution they were stored with', async () => {
  const shape = planarGrid(5);
  const mesh = await load(shape);
  const { report } = encodeReport(shape);
  // Vertices are numbered as the cells name them: the first cell is 0, 1, 7, 6 of the grid.
  const [x, y, z] = mesh.toFile([...mesh.before.subarray(4 * 2, 4 * 2 + 3)]);
  assert.ok(Math.abs(x - shape.before[7][0]) < report.mesh.points.scale);
  assert.ok(Math.abs(y - shape.before[7][1]) < report.mesh.points.scale);
  assert.equal(z, 0);
  const [a, b] = mesh.toFile([...mesh.after.subarray(4 * 2, 4 * 2 + 3)]);
  assert.ok(Math.abs(a - 1) < 2 * report.mesh.points.scale && Math.abs(b - 1) < 2 * report.mesh.points.scale);
});

test('numbers of edges and faces of every kind', () => {
  const sizes = [3, 4, 4, 5, 6, 8, 5, 7];
  const kind = [0, 1, 2, 3, 4, 5, 6, 6];
  const first = [0];
  for (const size of sizes) first.push(first.at(-1) + size);
  const each = (of) => kind.map((_, cell) => of({ kind, first }, cell).length);
  assert.deepEqual(each(edgesOf), [3, 4, 6, 8, 9, 12, 5, 7]);
  assert.deepEqual(each(facesOf), [1, 1, 4, 5, 5, 6, 1, 1]);
});

/** A quad, an L of six corners as one polygon, a triangle; one metric. */
function withPolygon() {
  const before = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [3, 0, 0], [3, 1, 0], [2, 1, 0], [2, 2, 0], [1, 2, 0]];
  const cells = [
    { kind: 1, vertices: [0, 1, 2, 3] },
    { kind: 6, vertices: [5, 6, 7, 8, 1, 4] },
    { kind: 0, vertices: [3, 2, 8] },
  ];
  const values = [1, 0.5, 0.8];
  return {
    type: 'planar', dimension: 2, cells, before, after: before,
    metrics: [{ name: 'shape', better: 'higher', unit: '', low: 0, high: 1, before: values, after: values }],
  };
}

test('a polygon is drawn as a fan that covers only itself, and only its sides are edges', async () => {
  const mesh = await load(withPolygon());
  const faces = findFaces(mesh);
  const corners = cornersOfFaces(mesh, faces, Uint8Array.from([0, 1, 0]), false);
  let area = 0;
  let edges = 0;
  for (let i = 0; i < corners.length; i += 6) {
    const [a, b, c] = [0, 2, 4].map((k) => [...mesh.before.subarray(4 * corners[i + k], 4 * corners[i + k] + 2)]);
    area += Math.abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    assert.equal(corners[i + 1] >> 3, 1);
    for (const bit of [1, 2, 4]) edges += (corners[i + 1] & bit) > 0;
  }
  assert.ok(Math.abs(area - 3) < 1e-3, `area ${area}`);
  assert.equal(edges, 6);
});

test('the boundary of a box of hexes is its outer faces', async () => {
  const mesh = await load(bar(3, 2, 2));
  const faces = findFaces(mesh);
  const outer = 2 * (3 * 2 + 3 * 2 + 2 * 2);
  const shown = new Uint8Array(mesh.cellCount).fill(1);
  assert.equal(faces.count, (12 * 6 + outer) / 2);
  assert.equal(cornersOfFaces(mesh, faces, shown, false).length / 6, 2 * outer);
  assert.equal(cornersOfFaces(mesh, faces, shown, true).length / 6, 2 * 12 * 6);
  shown.fill(0);
  shown[0] = 1;
  assert.equal(cornersOfFaces(mesh, faces, shown, false).length / 6, 2 * 6);
});

test('the boundary of a box of tets has two triangles per outer square', async () => {
  const mesh = await load(bar(3, 2, 2, { tets: true }));
  const outer = 2 * 2 * (3 * 2 + 3 * 2 + 2 * 2);
  const shown = new Uint8Array(mesh.cellCount).fill(1);
  assert.equal(cornersOfFaces(mesh, findFaces(mesh), shown, false).length / 6, outer);
});

test('a surface cell on a volume cell is drawn only when that is hidden', async () => {
  const shape = oneOfEach();
  shape.cells.push({ kind: 0, vertices: [0, 1, 2] });
  for (const metric of shape.metrics) { metric.before.push(1); metric.after.push(1); }
  const mesh = await load(shape);
  const faces = findFaces(mesh);
  const drawn = (shown) => {
    const corners = cornersOfFaces(mesh, faces, Uint8Array.from(shown), false);
    return Array.from({ length: corners.length / 6 }, (_, i) => corners[6 * i + 1] >> 3);
  };
  assert.ok(!drawn([1, 1, 1, 1, 1]).includes(4));
  assert.equal(drawn([1, 1, 1, 1, 1]).filter((cell) => cell === 0).length, 4);
  assert.deepEqual(drawn([0, 0, 0, 0, 1]), [4]);
});

test('only real edges are marked: not the diagonals of quads', async () => {
  const mesh = await load(planarGrid(1));
  const corners = cornersOfFaces(mesh, findFaces(mesh), new Uint8Array(1).fill(1), false);
  // Triangles (0 1 2) and (0 2 3); the diagonal is opposite corner 1 of the first, corner 2 of the second.
  assert.deepEqual([...corners], [0, 5, 1, 5, 2, 5, 0, 3, 2, 3, 3, 3]);
});

test('a concave quad is split where it folds, so that it covers only itself', async () => {
  const shape = planarGrid(1);
  // Corner 1 of the quad is pushed in across the diagonal from 0 to 2.
  shape.before[1] = [0.3, 0.7, 0];
  const mesh = await load(shape);
  const corners = cornersOfFaces(mesh, findFaces(mesh), new Uint8Array(1).fill(1), false);
  assert.deepEqual([...corners].filter((_, i) => i % 2 === 0), [1, 2, 3, 1, 3, 0]);
});

test('the worst share keeps undefined cells first, in both directions', () => {
  const values = Uint8Array.from([255, 10, 20, 30, 200, 210, 220, 230, 240, 250]);
  assert.deepEqual(worstRange({ better: 'higher' }, values, 0.3), [-1, 20]);
  assert.deepEqual(worstRange({ better: 'lower' }, values, 0.3), [240, 255]);
  assert.deepEqual(worstRange({ better: 'higher' }, values, 0.1), [-1, -1]);
});

test('a filter hides by value, list and plane', async () => {
  const mesh = await load(planarGrid(4, { shake: 0 }));
  const metric = { better: 'higher', before: Uint8Array.from({ length: 16 }, (_, i) => 10 * i), after: Uint8Array.from({ length: 16 }, (_, i) => (i === 0 ? 255 : 100)) };
  assert.equal(findVisible(mesh, metric, filter(), []).count, 16);
  assert.equal(findVisible(mesh, metric, filter({ range: [0, 40], rangeOf: 'before' }), []).count, 5);
  assert.equal(findVisible(mesh, metric, filter({ range: [-1, 99] }), []).count, 1);
  assert.equal(findVisible(mesh, metric, filter({ range: [0, 254] }), []).count, 15);
  assert.equal(findVisible(mesh, metric, filter({ show: 'listed' }), [3, 7]).count, 2);
  const cut = { normal: [1, 0, 0], distance: 0 };
  const half = findVisible(mesh, metric, filter({ cut }), []);
  assert.equal(half.count, 8);
  assert.equal(findVisible(mesh, metric, filter({ range: [0, 254], others: 'fade' }), []).of[0], 2);
});

test('damaged meshes are refused with a reason', async () => {
  const { report: polygons, data: bytes } = encodeReport(withPolygon());
  delete polygons.arrays.polygon_size;
  await assert.rejects(loadMesh(polygons, makeArrays(polygons.arrays, new Uint8Array(bytes))), /no size/);
  const { report, data } = encodeReport(planarGrid(3));
  const array = makeArrays(report.arrays, new Uint8Array(data));
  const replaced = (name, values) => (asked) => (asked === name ? Promise.resolve(values) : array(asked));
  await assert.rejects(loadMesh(report, replaced('cell_kind', Uint8Array.from([1, 1, 9, 1, 1, 1, 1, 1, 1]))), /cell 2 is of unknown kind 9/);
  await assert.rejects(loadMesh(report, replaced('cell_kind', Uint8Array.from([1]))), /4 corners, the data 36/);
  await assert.rejects(loadMesh(report, replaced('cell_vertices', new Int32Array(36).fill(99))), /vertex 99, but the mesh has 16 points/);
  await assert.rejects(loadMesh(report, replaced('points', null)), /holds no mesh/);
});

test('values, colours, holds and numbers as people read them', () => {
  assert.equal(valueOfByte({ low: 0, high: 1 }, 127), 0.5);
  assert.ok(Number.isNaN(valueOfByte({ low: 0, high: 1 }, 255)));
  // Both ends of viridis.
  assert.ok(colourAt(0).every((c, i) => Math.abs(c - [68, 1, 84][i]) < 4));
  assert.ok(colourAt(1).every((c, i) => Math.abs(c - [253, 231, 37][i]) < 5));
  assert.equal(holdSummary([1, 1, 1, 2]), '3 fixed, 1 slides on a curve');
  assert.equal(holdSummary([0, 0]), 'all free');
  assert.equal(holdSummary([0, 5, 0]), '1 held, 2 free');
  assert.equal(number(null), '∞');
  assert.equal(number(0.00001234), '1.23e−5');
  assert.equal(number(39.2643), '39.26');
  assert.equal(number(NaN), '–');
});
