// SPDX-License-Identifier: MIT

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

const read = (path) => readFileSync(new URL(path, import.meta.url), 'utf8');

test('dist/ is what the sources give', () => {
  execFileSync(process.execPath, [fileURLToPath(new URL('../build.mjs', import.meta.url)), '--check'], { stdio: 'pipe' });
});

test('the bundle can be put into a script element, and asks for nothing', () => {
  const script = read('../dist/report.js');
  assert.ok(!/<\/script|<!--/i.test(script));
  assert.ok(!/\beval\(|new Function\(|importScripts/.test(script));
  // Names of vocabularies, and a paper in a comment of a shader; nothing is loaded from them.
  const addresses = new Set(script.match(/https?:\/\/[^\s"'`)]+/g));
  assert.deepEqual([...addresses].sort(), ['http://www.w3.org/1999/xhtml', 'http://www.w3.org/2000/svg', 'https://jcgt.org/published/0007/04/01/']);
  assert.ok(!/url\((?!data:)|@import/.test(read('../dist/report.css')));
});

test('our sources make no markup of text and set no style attributes', () => {
  for (const name of ['dom', 'summary', 'worst', 'cell', 'stage', 'command', 'legend', 'histogram', 'convergence', 'quality']) {
    assert.ok(!/innerHTML|outerHTML|insertAdjacentHTML|setAttribute\('style'/.test(read(`../src/ui/${name}.js`)), name);
  }
});

test('licences of all that is bundled are there', () => {
  const text = read('../dist/LICENSES.txt');
  for (const name of ['evenmesh', 'three.js', 'uPlot']) assert.ok(text.includes(`${name}\n=`), name);
});
