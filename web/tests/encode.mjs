// SPDX-License-Identifier: MIT
//
// Writes reports as README.md, section "Data", says, from meshes given as plain arrays. The page's tests
// read what this writes; it shares no code with src/.

import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { deflateSync } from 'node:zlib';

const zigzag = (v) => ((v << 1) ^ (v >> 31)) >>> 0;

const encoders = {
  unsigned: (values) => values,
  signed: (values) => values.map(zigzag),
  delta: (values, components) => values.map((v, i) => zigzag(v - (i < components ? 0 : values[i - components]))),
  highwater(values) {
    let high = 0;
    return values.map((v) => {
      const u = high - v;
      if (u < 0) throw new Error('vertices are not numbered in the order of first use');
      if (u === 0) ++high;
      return u;
    });
  },
};

/** One array: its zlib stream and its entry in "arrays", but for the offset. */
export function encodeArray(values, rule, components = 1) {
  const list = Array.from(values);
  const u = encoders[rule](list, components);
  let most = 0;
  for (const value of u) if (value > most) most = value;
  const planes = most < 256 ? 1 : most < 65536 ? 2 : most < 16777216 ? 3 : 4;
  const bytes = new Uint8Array(list.length * planes);
  for (let p = 0; p < planes; ++p) {
    for (let i = 0; i < u.length; ++i) bytes[p * u.length + i] = (u[i] >>> (8 * p)) & 255;
  }
  const stream = deflateSync(bytes, { level: 6 });
  return { stream, spec: { bytes: stream.length, count: list.length, components, planes, rule } };
}

const corners = [3, 4, 4, 5, 6, 8];

/** Numbers vertices in the order in which cells first name them. */
function renumber(mesh) {
  const next = new Map();
  const cells = mesh.cells.map(({ kind, vertices, ...rest }) => ({
    ...rest, kind,
    vertices: vertices.map((v) => {
      if (!next.has(v)) next.set(v, next.size);
      return next.get(v);
    }),
  }));
  const order = [...next.keys()];
  const take = (list) => list && order.map((v) => list[v]);
  return {
    ...mesh, cells, before: take(mesh.before), after: take(mesh.after), hold: take(mesh.hold),
    iterates: mesh.iterates?.map(({ iteration, points }) => ({ iteration, points: take(points) })),
    vertexId: order.map((v) => mesh.vertexId?.[v] ?? v + 1),
    featureEdges: mesh.featureEdges?.map((edge) => edge.map((v) => next.get(v))).filter((edge) => edge.every((v) => v !== undefined)),
  };
}

/**
 * The report and its data.
 *
 * @param given  {type, dimension, cells: [{kind, vertices, group, flags}], before, after, hold, featureEdges,
 *               iterates: [{iteration, points}], metrics: [{name, better, unit, low, high, before, after}]};
 *               values of metrics that are NaN are undefined
 * @param more   what else the report says: title, verdicts, worst, history and so on
 */
export function encodeReport(given, more = {}) {
  const mesh = renumber(given);
  for (const { kind, vertices } of mesh.cells) {
    if (kind === 6 ? vertices.length < 5 : vertices.length !== corners[kind]) throw new Error('wrong number of corners');
  }
  const flat = mesh.before.flat();
  const origin = [0, 1, 2].map((axis) => Math.min(...sample(mesh.before.map((p) => p[axis]))));
  const extent = Math.max(...[0, 1, 2].map((axis) => reach(mesh.before.map((p) => p[axis])))) || 1;
  const scale = extent / 60000;
  const quantise = (points) => points.flatMap((p) => p.map((x, axis) => Math.round((x - origin[axis]) / scale)));
  const before = quantise(mesh.before);
  const movesTo = (points) => quantise(points).map((v, i) => v - before[i]);

  const arrays = {};
  const streams = [];
  let offset = 0;
  const put = (name, values, rule, components) => {
    const { stream, spec } = encodeArray(values, rule, components);
    arrays[name] = { offset, ...spec };
    offset += stream.length;
    streams.push(stream);
  };
  put('points', before, 'delta', 3);
  if (mesh.after) put('moves', movesTo(mesh.after), 'signed', 3);
  put('cell_kind', mesh.cells.map(({ kind }) => kind), 'unsigned');
  const sizes = mesh.cells.filter(({ kind }) => kind === 6).map(({ vertices }) => vertices.length);
  if (sizes.length) put('polygon_size', sizes, 'unsigned');
  put('cell_vertices', mesh.cells.flatMap(({ vertices }) => vertices), 'highwater');
  if (!mesh.cellNames) put('cell_id', mesh.cells.map(({ id }, i) => id ?? i + 1), 'delta');
  put('vertex_id', mesh.vertexId, 'delta');
  if (mesh.cells.some(({ group }) => group)) put('cell_group', mesh.cells.map(({ group }) => group ?? 0), 'unsigned');
  if (mesh.hold) put('vertex_hold', mesh.hold, 'unsigned');
  put('cell_flags', mesh.cells.map(({ flags }) => flags ?? 0), 'unsigned');
  if (mesh.featureEdges) put('feature_edges', mesh.featureEdges.flat(), 'delta', 2);
  for (const metric of mesh.metrics) {
    const byte = (v) => (Number.isNaN(v) ? 255
      : Math.max(0, Math.min(254, Math.round((254 * (v - metric.low)) / (metric.high - metric.low)))));
    put(`before_${metric.name}`, metric.before.map(byte), 'unsigned');
    if (mesh.after) put(`after_${metric.name}`, metric.after.map(byte), 'unsigned');
  }
  mesh.iterates?.forEach(({ points }, k) => put(`iterate_${k}`, movesTo(points), 'signed', 3));

  const report = {
    format: 1, title: 'mesh.obj', kind: mesh.after ? 'smooth' : 'check', program: 'evenmesh 0.9',
    verdicts: [], ledger: [], quality: [], worst: [], history: [], command: 'evenmesh mesh.obj -o even.obj', notes: [], groups: [],
    ...more,
    mesh: {
      dimension: mesh.dimension, type: mesh.type,
      cells: { shown: mesh.cells.length, of: mesh.cells.length, ...more.cells },
      points: { count: flat.length / 3, scale, origin },
      has_after: Boolean(mesh.after),
      metrics: mesh.metrics.map(({ name, better, unit, low, high }) => ({ name, better, unit, low, high })),
      iterates: mesh.iterates?.map(({ iteration }) => iteration) ?? [],
      ...(mesh.cellNames && { cell_names: mesh.cellNames }),
    },
    arrays,
  };
  delete report.cells;
  return { report, data: Buffer.concat(streams) };
}

function sample(values) {
  // Math.min takes no million arguments.
  return [values.reduce((a, b) => Math.min(a, b))];
}
const reach = (values) => values.reduce((a, b) => Math.max(a, b)) - values.reduce((a, b) => Math.min(a, b));

const dist = (name) => readFileSync(new URL(`../dist/${name}`, import.meta.url));
const sha256 = (bytes) => createHash('sha256').update(bytes).digest('base64');
const escape = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

/** The whole file. */
export function htmlOf({ report, data }) {
  const script = dist('report.js');
  const style = dist('report.css');
  const json = JSON.stringify(report).replaceAll('<', '\\u003c');
  const base64 = data.toString('base64').replace(/.{1,76000}/g, '$&\n');
  return `<!doctype html><html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'sha256-${sha256(script)}'; style-src 'sha256-${sha256(style)}'; img-src data:; base-uri 'none'; form-action 'none'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>evenmesh: ${escape(report.title)}</title><style>${style}</style></head>
<body>
<main id="evenmesh-static"><h1>${escape(report.title)}</h1><p>The static report.</p>
<table><tr><th>metric</th><th>before</th><th>after</th></tr><tr><td>shape</td><td>0.1</td><td>0.4</td></tr></table></main>
<div id="evenmesh-app" hidden></div>
<script type="application/json" id="evenmesh-report">${json}</script>
<script type="application/octet-stream" id="evenmesh-data">${base64}</script>
<script>${script}</script>
</body></html>
`;
}
