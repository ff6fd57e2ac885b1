// SPDX-License-Identifier: MIT
//
// Meshes for the tests, each with a before that is shaken and an after that is even.

/** Numbers in [0, 1), the same at every run. */
export function makeRandom(seed = 1) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 4294967296;
  };
}

const minus = (a, b) => a.map((x, i) => x - b[i]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const square = (a) => dot(a, a);

/** docs/quality.md, "shape", of triangles, quads, tets and hexes; NaN if inverted. */
export function shapeOf({ kind, vertices }, points) {
  const p = vertices.map((v) => points[v]);
  if (kind === 0 || kind === 1) {
    const n = p.length;
    const own = cross(minus(p[1], p[0]), minus(p[n - 1], p[0]));
    const up = points.up ?? own;
    const length = Math.sqrt(square(up)) || 1;
    const values = p.map((_, i) => {
      const a = minus(p[(i + 1) % n], p[i]);
      const b = minus(p[(i + n - 1) % n], p[i]);
      const j = dot(cross(a, b), up) / length;
      return n === 3 ? (Math.sqrt(3) * j) / (square(a) + square(b) - dot(a, b)) : (2 * j) / (square(a) + square(b));
    });
    const worst = Math.min(...values);
    return worst > 0 ? worst : NaN;
  }
  if (kind === 2) {
    const [a, b, c] = [1, 2, 3].map((i) => minus(p[i], p[0]));
    const j = dot(cross(a, b), c);
    const edges = [a, b, c, minus(b, a), minus(c, a), minus(c, b)].reduce((sum, e) => sum + square(e), 0);
    return j > 0 ? (6 * (Math.SQRT2 * j) ** (2 / 3)) / edges : NaN;
  }
  if (kind === 5) {
    const next = [[1, 3, 4], [2, 0, 5], [3, 1, 6], [0, 2, 7], [7, 5, 0], [4, 6, 1], [5, 7, 2], [6, 4, 3]];
    const worst = Math.min(...next.map((ends, i) => {
      const [a, b, c] = ends.map((e) => minus(p[e], p[i]));
      const j = dot(cross(a, b), c);
      return j > 0 ? (3 * j ** (2 / 3)) / (square(a) + square(b) + square(c)) : -1;
    }));
    return worst > 0 ? worst : NaN;
  }
  return 0.7;
}

const sides = [[[0, 1], [1, 2], [2, 0]], [[0, 1], [1, 2], [2, 3], [3, 0]], [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]],
  [[0, 1], [1, 2], [2, 3], [3, 0], [0, 4], [1, 4], [2, 4], [3, 4]],
  [[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3], [0, 3], [1, 4], [2, 5]],
  [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]]];

export function edgeRatioOf({ kind, vertices }, points) {
  const lengths = sides[kind].map(([a, b]) => Math.sqrt(square(minus(points[vertices[a]], points[vertices[b]]))));
  return Math.max(...lengths) / Math.min(...lengths);
}

function withMetrics(mesh) {
  const values = (of, points) => mesh.cells.map((cell) => of(cell, points));
  const shape = { name: 'shape', better: 'higher', unit: '', low: 0, high: 1, before: values(shapeOf, mesh.before), after: values(shapeOf, mesh.after) };
  const before = values(edgeRatioOf, mesh.before);
  const after = values(edgeRatioOf, mesh.after);
  const high = before.concat(after).reduce((a, b) => Math.max(a, b));
  mesh.cells.forEach((cell, i) => {
    cell.flags = (cell.flags ?? 0) | (Number.isNaN(shape.before[i]) ? 1 : 0) | (Number.isNaN(shape.after[i]) ? 2 : 0);
  });
  return { ...mesh, metrics: [shape, { name: 'edge_ratio', better: 'lower', unit: '', low: 1, high, before, after }] };
}

/** n x n unit squares in the plane; split: each into two triangles where (i + j) % split is 0. */
export function planarGrid(n, { shake = 0.45, split = 0, seed = 1, iterates = 0 } = {}) {
  const random = makeRandom(seed);
  const at = (i, j) => j * (n + 1) + i;
  const up = [0, 0, 1];
  const after = [];
  const before = [];
  const hold = [];
  for (let j = 0; j <= n; ++j) {
    for (let i = 0; i <= n; ++i) {
      const onX = i === 0 || i === n;
      const onY = j === 0 || j === n;
      after.push([i, j, 0]);
      before.push([i + (onX ? 0 : shake * 2 * (random() - 0.5)), j + (onY ? 0 : shake * 2 * (random() - 0.5)), 0]);
      hold.push(onX && onY ? 1 : onX || onY ? 2 : 0);
    }
  }
  const cells = [];
  for (let j = 0; j < n; ++j) {
    for (let i = 0; i < n; ++i) {
      const quad = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
      const group = i < n / 2 ? 1 : 2;
      if (split && (i + j) % split === 0) {
        cells.push({ kind: 0, vertices: [quad[0], quad[1], quad[2]], group }, { kind: 0, vertices: [quad[0], quad[2], quad[3]], group });
      } else {
        cells.push({ kind: 1, vertices: quad, group });
      }
    }
  }
  const featureEdges = [];
  for (let i = 0; i < n; ++i) featureEdges.push([at(i, 0), at(i + 1, 0)], [at(i, n), at(i + 1, n)], [at(0, i), at(0, i + 1)], [at(n, i), at(n, i + 1)]);
  before.up = after.up = up;
  const mesh = withMetrics({ dimension: 2, type: 'planar', cells, before, after, hold, featureEdges });
  return iterates ? { ...mesh, iterates: between(mesh, iterates) } : mesh;
}

/** Positions on curved ways from before to after. */
function between({ before, after }, count) {
  return Array.from({ length: count }, (_, k) => {
    const t = (k + 1) / (count + 1);
    return {
      iteration: 2 * (k + 1),
      points: before.map((p, v) => p.map((x, axis) => x + (after[v][axis] - x) * (1 - (1 - t) ** 3))),
    };
  });
}

/** A bumpy ball of 2 n (n - 1) x 2 triangles or quads; mixed: quads with triangles here and there. */
export function bumpyBall(n, { mixed = false, seed = 2, shake = 0.5 } = {}) {
  const random = makeRandom(seed);
  const m = 2 * n;
  const on = (a, b) => {
    const u = (Math.PI * a) / n;
    const v = (2 * Math.PI * b) / m;
    const r = 1 + 0.13 * Math.sin(3 * u) * Math.cos(4 * v);
    return [r * Math.sin(u) * Math.cos(v), r * Math.sin(u) * Math.sin(v), r * Math.cos(u)];
  };
  const before = [];
  const after = [];
  for (let j = 1; j < n; ++j) {
    for (let i = 0; i < m; ++i) {
      after.push(on(j, i));
      before.push(on(j + shake * (random() - 0.5), i + shake * (random() - 0.5)));
    }
  }
  const south = after.length;
  for (const list of [before, after]) list.push(on(0, 0), on(n, 0));
  const at = (i, j) => (j - 1) * m + (i % m);
  const cells = [];
  for (let i = 0; i < m; ++i) cells.push({ kind: 0, vertices: [south, at(i, 1), at(i + 1, 1)], group: 1 });
  for (let j = 1; j < n - 1; ++j) {
    for (let i = 0; i < m; ++i) {
      const quad = [at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)];
      const group = j < n / 2 ? 1 : 2;
      if (mixed && (i * 7 + j * 3) % 5 !== 0) cells.push({ kind: 1, vertices: quad, group });
      else cells.push({ kind: 0, vertices: [quad[0], quad[1], quad[2]], group }, { kind: 0, vertices: [quad[0], quad[2], quad[3]], group });
    }
  }
  for (let i = 0; i < m; ++i) cells.push({ kind: 0, vertices: [south + 1, at(i + 1, n - 1), at(i, n - 1)], group: 2 });
  const equator = Math.floor(n / 2);
  return withMetrics({
    dimension: 3, type: 'surface', cells, before, after, hold: after.map((_, v) => (v >= south ? 1 : 3)),
    featureEdges: Array.from({ length: m }, (_, i) => [at(i, equator), at(i + 1, equator)]),
  });
}

/** A bent bar of hexes or tets, a x b x c cubes. */
export function bar(a, b, c, { tets = false, seed = 3, shake = 0.32 } = {}) {
  const random = makeRandom(seed);
  const at = (i, j, k) => (k * (b + 1) + j) * (a + 1) + i;
  const bend = ([x, y, z]) => {
    const turn = (0.9 * x) / a;
    const r = 1.4 * a - z;
    return [r * Math.sin(turn), y, 1.4 * a - r * Math.cos(turn)];
  };
  const before = [];
  const after = [];
  const hold = [];
  for (let k = 0; k <= c; ++k) {
    for (let j = 0; j <= b; ++j) {
      for (let i = 0; i <= a; ++i) {
        const on = [i === 0 || i === a, j === 0 || j === b, k === 0 || k === c];
        const many = on.filter(Boolean).length;
        after.push(bend([i, j, k]));
        before.push(bend([i, j, k].map((x, axis) => x + (on[axis] ? 0 : shake * 2 * (random() - 0.5)))));
        hold.push(many === 3 ? 1 : many === 2 ? 2 : many === 1 ? 3 : 0);
      }
    }
  }
  const cells = [];
  for (let k = 0; k < c; ++k) {
    for (let j = 0; j < b; ++j) {
      for (let i = 0; i < a; ++i) {
        const v = [at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k),
          at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)];
        const group = i < a / 2 ? 1 : 2;
        if (!tets) cells.push({ kind: 5, vertices: v, group, flags: k === 0 ? 4 : 0 });
        else {
          for (const t of [[0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6], [0, 5, 1, 6]]) {
            cells.push({ kind: 2, vertices: t.map((corner) => v[corner]), group });
          }
        }
      }
    }
  }
  const featureEdges = [];
  const edge = (n, of) => { for (let i = 0; i < n; ++i) featureEdges.push([of(i), of(i + 1)]); };
  for (const [p, q] of [[0, 0], [0, 1], [1, 0], [1, 1]]) {
    edge(a, (i) => at(i, p * b, q * c));
    edge(b, (j) => at(p * a, j, q * c));
    edge(c, (k) => at(p * a, q * b, k));
  }
  return withMetrics({ dimension: 3, type: 'volume', cells, before, after, hold, featureEdges });
}

/** One cell of every kind, side by side, for pictures and picking. */
export function oneOfEach() {
  const points = [];
  const cells = [];
  const put = (kind, corners) => {
    const first = points.length;
    points.push(...corners);
    cells.push({ kind, vertices: corners.map((_, i) => first + i) });
  };
  put(2, [[0, 0, 0], [1, 0, 0], [0.5, 0.9, 0], [0.5, 0.3, 0.8]]);
  put(3, [[2, 0, 0], [3, 0, 0], [3, 1, 0], [2, 1, 0], [2.5, 0.5, 0.8]]);
  put(4, [[4, 0, 0], [5, 0, 0], [4.5, 0.9, 0], [4, 0, 1], [5, 0, 1], [4.5, 0.9, 1]]);
  put(5, [[6, 0, 0], [7, 0, 0], [7, 1, 0], [6, 1, 0], [6, 0, 1], [7, 0, 1], [7, 1, 1], [6, 1, 1]]);
  return withMetrics({ dimension: 3, type: 'volume', cells, before: points, after: points.map((p) => [...p]), hold: points.map(() => 0), featureEdges: [] });
}

/** What a run would say about a mesh: lists that are as long as real ones. */
export function storyOf(mesh, more = {}) {
  const [shape] = mesh.metrics;
  const order = mesh.cells.map((_, i) => i)
    .sort((a, b) => (Number.isNaN(shape.after[a]) ? -1 : shape.after[a]) - (Number.isNaN(shape.after[b]) ? -1 : shape.after[b]));
  const round = (v) => (Number.isNaN(v) ? -0.1 : Math.round(v * 1e4) / 1e4);
  const stats = (values) => {
    const sorted = values.map((v) => (Number.isNaN(v) ? 0 : v)).sort((a, b) => a - b);
    const at = (p) => round(sorted[Math.min(sorted.length - 1, Math.floor(p * sorted.length))]);
    return { worst: at(0), p1: at(0.01), p5: at(0.05), median: at(0.5), mean: round(sorted.reduce((a, b) => a + b) / sorted.length) };
  };
  const inverted = mesh.cells.filter(({ flags }) => flags & 1).length;
  return {
    title: 'bracket.inp',
    run: {
      schema_version: '1.3', status: 'ok', exit_code: 0,
      message: 'converged after 14 iterations; worst shape rose from 0.041 to 0.352',
    },
    verdicts: [
      { name: 'no inverted cells', pass: true, text: `${inverted} before, 0 after` },
      { name: 'worst value of no metric lower', pass: true, text: 'all six are at least those of the input' },
      { name: 'target shape >= 0.3', pass: false, text: '2 cells below, the worst has 0.271' },
      { name: 'deviation of the surface', pass: null, text: '0.21 % of the diagonal' },
    ],
    ledger: [
      { name: 'moved', value: '1234 of 5678 vertices' }, { name: 'fixed', value: '48 vertices' }, { name: 'stopped', value: '3 vertices' },
      { name: 'largest move', value: '0.482 (1.2 % of the diagonal)' }, { name: 'mean move', value: '0.071' },
    ],
    quality: [
      { metric: 'shape', better: 'higher', ideal: 1, unit: '', before: stats(shape.before), after: stats(shape.after) },
      { metric: 'min_angle', better: 'higher', ideal: 60, unit: '°', before: { worst: 2.74, p1: 8.5, p5: 14.2, median: 39.1, mean: 39.26 }, after: { worst: 10.02, p1: 19.4, p5: 28.8, median: 48.9, mean: 47.69 } },
      { metric: 'aspect_ratio', better: 'lower', ideal: 1, unit: '', before: { worst: null, p1: 12.4, p5: 6.1, median: 1.61, mean: null }, after: { worst: 8.3, p1: 4.2, p5: 2.4, median: 1.22, mean: 1.37 } },
    ],
    worst: order.slice(0, 10).map((cell, i) => ({
      name: String(cell + 1), kind: ['triangle', 'quad', 'tet', 'pyramid', 'wedge', 'hex'][mesh.cells[cell].kind], cell,
      shape_before: round(shape.before[cell]), shape_after: round(shape.after[cell]), inverted: Boolean(mesh.cells[cell].flags & 2),
      held_by: i % 3 === 0 ? ['fixed vertices: 3', 'slide on line: 1'] : i % 3 === 1 ? ['validity of its neighbours'] : [],
    })),
    history: Array.from({ length: 15 }, (_, i) => ({
      iteration: i, cost: 1800 * Math.exp(-0.5 * i) + 512, gradient: Math.exp(-0.9 * i), max_move: i ? 0.5 * Math.exp(-0.6 * i) : 0,
      inverted: Math.max(0, inverted - 3 * i), function: i > 5 ? 1 : 0,
    })),
    command: "evenmesh bracket.inp -o even.inp --slide 'boundary on circle' --target 'shape>=0.3'",
    notes: ['two cells are held by fixed vertices on all sides: their shape cannot be changed'],
    groups: ['STEEL', 'BOLT'],
    ...more,
  };
}
