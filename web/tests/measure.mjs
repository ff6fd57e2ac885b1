// SPDX-License-Identifier: MIT
//
// How large reports are and how fast they open: node tests/measure.mjs [FILE.html ...]
//
// Without files it makes surfaces of 10, 200 and 1000 thousand triangles. Times are the page's own marks, from
// the start of navigation to the first picture drawn, in a fresh tab; the median of three.

import { statSync } from 'node:fs';
import { basename } from 'node:path';
import { launch, open, skip, writeReport } from './browser.mjs';
import { bumpyBall, storyOf } from './shapes.mjs';

if (skip) {
  console.error(skip);
  process.exit(1);
}
const files = process.argv.slice(2);
const subjects = files.length > 0 ? files.map((path) => ({ name: basename(path), path }))
  : [50, 224, 500].map((n) => {
    const mesh = bumpyBall(n);
    return { name: `${mesh.cells.length} triangles`, path: writeReport(mesh, storyOf(mesh)) };
  });

const browser = await launch(['--enable-precise-memory-info']);
const row = (...cells) => console.log(cells.map((cell, i) => (i === 0 ? cell.padEnd(28) : cell.padStart(12))).join(''));
row('report', 'size', 'script at', 'decoded', 'first frame', 'a frame', 'JS heap');
for (const { name, path } of subjects) {
  const runs = [];
  for (let i = 0; i < 3; ++i) {
    const { page, finish } = await open(browser, path);
    runs.push(await page.evaluate(async () => {
      if (window.evenmesh.error) throw new Error(window.evenmesh.error);
      const at = (mark) => performance.getEntriesByName(mark)[0].startTime;
      const heap = performance.memory.usedJSHeapSize;
      const start = performance.now();
      window.evenmesh.redraw();
      return { start: at('evenmesh-start'), decoded: at('evenmesh-decoded'), first: at('evenmesh-first-frame'), heap, frame: performance.now() - start };
    }));
    await finish();
  }
  const median = (key) => runs.map((run) => run[key]).sort((a, b) => a - b)[1];
  const ms = (key) => `${Math.round(median(key))} ms`;
  row(name, `${(statSync(path).size / 1e6).toFixed(2)} MB`, ms('start'), ms('decoded'), ms('first'), ms('frame'), `${(median('heap') / 1e6).toFixed(0)} MB`);
}
await browser.close();
