// SPDX-License-Identifier: MIT
//
// The page in a real browser.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test, { after, before } from 'node:test';
import { launch, open, picture, pixels, skip, writePage, writeReport } from './browser.mjs';
import { encodeReport, htmlOf } from './encode.mjs';
import { bar, bumpyBall, oneOfEach, planarGrid, storyOf } from './shapes.mjs';
import { colourAt } from '../src/model/colour.js';

let browser;
before(async () => { if (!skip) browser = await launch(); });
after(() => browser?.close());

const check = (name, run) => test(name, { skip, timeout: 120000 }, run);
const near = (a, b, tolerance) => a.every((value, i) => Math.abs(value - b[i]) <= tolerance);

/** A place inside a cell of the picture, off its edges, in CSS pixels of the canvas. */
const place = (page, cell, side) => page.evaluate(([c, s]) => window.evenmesh.project(c, s), [cell, side]);
const set = (page, patch) => page.evaluate((p) => window.evenmesh.set(p), patch);

async function withReport(mesh, run, { more, ...options } = {}) {
  const opened = await open(browser, writeReport(mesh, storyOf(mesh, more)), options);
  assert.equal(await opened.page.evaluate(() => window.evenmesh.error), undefined);
  await opened.settle();
  await run(opened.page, opened);
  await opened.finish();
}

/** Moves the mouse to a place of the canvas, scrolled into sight. */
async function mouseTo(page, { x, y }) {
  await page.locator('canvas.em-canvas').scrollIntoViewIfNeeded();
  const box = await page.locator('canvas.em-canvas').boundingBox();
  await page.mouse.move(box.x + x, box.y + y);
}

check('cells of a planar mesh have the colours of their values', async () => {
  const mesh = planarGrid(6);
  const [shape] = mesh.metrics;
  await withReport(mesh, async (page) => {
    for (const side of ['before', 'after']) {
      const places = await Promise.all(mesh.cells.map((_, cell) => place(page, cell, side)));
      const seen = await pixels(page, places);
      mesh.cells.forEach((_, cell) => {
        const value = shape[side][cell];
        if (Number.isNaN(value)) return;
        const wanted = colourAt(Math.round(254 * value) / 254);
        assert.ok(near(seen[cell], wanted, 6), `${side} ${cell}: ${seen[cell]} for ${wanted}`);
      });
    }
  });
});

check('undefined cells are magenta, and lower is better turns the colours', async () => {
  const mesh = planarGrid(4, { shake: 0.2 });
  const [shape, ratio] = mesh.metrics;
  shape.after[5] = NaN;
  await withReport(mesh, async (page, { settle }) => {
    const [seen] = await pixels(page, [await place(page, 5)]);
    assert.ok(seen[0] > 140 && seen[1] < 40 && seen[2] > 55 && seen[2] < 120, seen.join());
    await page.selectOption('[aria-label="Metric"]', 'edge_ratio');
    await page.waitForFunction(() => window.evenmesh.state().decoded === 'edge_ratio');
    await settle();
    const [best] = await pixels(page, [await place(page, 5)]);
    assert.ok(near(best, colourAt(1), 6), `${best}: ratio ${ratio.after[5]} is the best`);
  });
});

for (const [name, make, cells] of [
  ['planar quads and triangles', () => planarGrid(8, { split: 3 }), [0, 17, 40]],
  ['a ball', () => bumpyBall(10), null],
  ['mixed surface', () => bumpyBall(9, { mixed: true }), null],
  ['tets', () => bar(4, 3, 3, { tets: true }), null],
  ['hexes', () => bar(5, 3, 3), null],
  ['every kind', () => oneOfEach(), null],
]) {
  check(`picking names the cell under the pointer: ${name}`, async () => {
    await withReport(make(), async (page) => {
      const { cells: count } = await page.evaluate(() => window.evenmesh.state());
      const chosen = cells ?? Array.from({ length: count }, (_, i) => i);
      // What is seen at a cell's middle is that cell or one before it, or nothing at the rim of a ball.
      const hits = await page.evaluate((list) => list.map((cell) => {
        const { x, y } = window.evenmesh.project(cell);
        return [cell, window.evenmesh.pick(x, y)];
      }), chosen);
      if (cells) assert.deepEqual(hits, cells.map((cell) => [cell, cell]));
      assert.ok(hits.filter(([cell, hit]) => cell === hit).length >= 1);
      assert.ok(hits.every(([, hit]) => hit >= -1 && hit < count));
    });
  });
}

check('where cells of a plane lie on each other, the one turned over is on top', async () => {
  const square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]];
  const shape = { name: 'shape', better: 'higher', unit: '', low: 0, high: 1, before: [NaN, 0.9], after: [0.9, 0.2] };
  await withReport({
    dimension: 2, type: 'planar', before: square, after: square, metrics: [shape],
    cells: [{ kind: 1, vertices: [0, 3, 2, 1], flags: 1 }, { kind: 1, vertices: [0, 1, 2, 3] }],
  }, async (page) => {
    const seen = await page.evaluate(() => ['before', 'after'].map((side) => {
      const { x, y } = window.evenmesh.project(0, side);
      return window.evenmesh.pick(x, y);
    }));
    assert.deepEqual(seen, [0, 1]);
  });
});

check('a surface picks the front cell at the middle of each cell that faces the eye', async () => {
  const mesh = bumpyBall(12, { shake: 0 });
  await withReport(mesh, async (page) => {
    const { azimuth: a, elevation: e } = await page.evaluate(() => window.evenmesh.camera());
    const eye = [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
    const facing = mesh.cells.map(({ vertices }, cell) => {
      const middle = [0, 1, 2].map((axis) => vertices.reduce((sum, v) => sum + mesh.after[v][axis], 0) / 3);
      return { cell, along: middle.reduce((sum, x, axis) => sum + x * eye[axis], 0) / Math.hypot(...middle) };
    }).filter(({ along }) => along > 0.9);
    assert.ok(facing.length > 8);
    for (const { cell } of facing) {
      const hit = await page.evaluate((c) => { const { x, y } = window.evenmesh.project(c); return window.evenmesh.pick(x, y); }, cell);
      assert.equal(hit, cell);
    }
  });
});

check('hover names a cell, a click keeps it in the panel', async () => {
  const mesh = planarGrid(6);
  mesh.cells.forEach((cell, i) => { cell.id = 1000 + 7 * i; });
  await withReport(mesh, async (page) => {
    const cell = 14;
    await mouseTo(page, await place(page, cell));
    await page.waitForFunction((c) => window.evenmesh.state().hovered === c, cell);
    await page.waitForSelector('.em-tip:not([hidden])');
    assert.match(await page.textContent('.em-tip'), new RegExp(`quad ${1000 + 7 * cell}`));
    await page.mouse.down();
    await page.mouse.up();
    await page.waitForFunction((c) => window.evenmesh.state().selected === c, cell);
    await page.waitForSelector('.em-cell h3:has-text("quad")');
    const panel = await page.textContent('.em-cell');
    assert.match(panel, new RegExp(`quad ${1000 + 7 * cell}`));
    assert.match(panel, /STEEL/);
    assert.match(panel, /shape.*edge ratio/s);
    assert.match(panel, /all free/);
    // The corner of the mesh: one vertex fixed, two slide.
    await page.evaluate(() => window.evenmesh.select(0));
    await page.waitForSelector('.em-cell:has-text("1 fixed, 2 slides on a curve, 1 free")');
    await page.keyboard.press('Escape');
    assert.equal((await page.evaluate(() => window.evenmesh.state())).selected, -1);
  });
});

check('before is picked on the left, after on the right', async () => {
  const mesh = planarGrid(5);
  await withReport(mesh, async (page) => {
    const left = await place(page, 12, 'before');
    const right = await place(page, 12, 'after');
    const { width } = await page.locator('canvas.em-canvas').boundingBox();
    assert.ok(left.x < width / 2 && right.x > width / 2);
    for (const at of [left, right]) assert.equal(await page.evaluate(({ x, y }) => window.evenmesh.pick(x, y), at), 12);
    assert.equal(await page.evaluate(() => window.evenmesh.pick(3, 3)), -1);
  });
});

check('dragging over the histogram shows the cells of that range only', async () => {
  const mesh = planarGrid(12, { shake: 0.35 });
  const [shape] = mesh.metrics;
  await withReport(mesh, async (page, { settle, state }) => {
    await page.click('.em-side button:has-text("before")');
    const whole = await picture(page);
    const box = await page.locator('.em-histogram').boundingBox();
    const x = (bar) => box.x + (box.width / 320) * (34 + ((320 - 42) / 53) * (2 + bar + 0.5));
    await page.mouse.move(x(20), box.y + 40);
    await page.mouse.down();
    await page.mouse.move(x(30), box.y + 40, { steps: 4 });
    await page.mouse.up();
    await settle();
    // Bars 20 to 30 hold the bytes 100 to 154.
    const wanted = shape.before.filter((v) => Math.round(254 * v) >= 100 && Math.round(254 * v) <= 154).length;
    assert.ok(wanted > 5);
    assert.deepEqual((await state()).range, [100, 154]);
    assert.equal((await state()).visibleCells, wanted);
    assert.match(await page.textContent('.em-count'), new RegExp(`^${wanted} of 144 cells`));
    const some = await picture(page);
    assert.notEqual(some, whole);
    await page.click('.em-side button:has-text("hidden")');
    await settle();
    assert.notEqual(await picture(page), some);
    await page.click('button:has-text("Reset")');
    await settle();
    assert.equal((await state()).visibleCells, 144);
    // The same by typing.
    await page.fill('[aria-label="Greatest value shown"]', '0.5');
    await page.keyboard.press('Enter');
    await settle();
    assert.equal((await state()).visibleCells, shape.before.filter((v) => Number.isNaN(v) || Math.round(254 * v) <= 127).length);
  });
});

check('choosing a row of the worst cells moves the camera there and marks the cell', async () => {
  const mesh = bumpyBall(12, { mixed: true });
  await withReport(mesh, async (page, { settle, state }) => {
    const at = await page.evaluate(() => window.evenmesh.camera());
    await page.click('.em-worst tbody tr:nth-child(2) td:nth-child(2)');
    await settle();
    const cell = storyOf(mesh).worst[1].cell;
    assert.equal((await state()).selected, cell);
    const there = await page.evaluate(() => window.evenmesh.camera());
    assert.ok(there.halfHeight < 0.7 * at.halfHeight);
    const { x, y } = await place(page, cell);
    const { width, height } = await page.locator('canvas.em-canvas').boundingBox();
    assert.ok(Math.abs(x - 0.75 * width) < 3 && Math.abs(y - 0.5 * height) < 3, `${x} ${y}`);
    // Held by, from the table.
    await page.waitForSelector('.em-cell:has-text("validity of its neighbours")');
    // And by key: Enter on the name of the next.
    await page.focus('.em-worst tbody tr:nth-child(4) button');
    await page.keyboard.press('Enter');
    await settle();
    assert.equal((await state()).selected, storyOf(mesh).worst[3].cell);
    assert.equal(await page.locator('.em-chosen').count(), 1);
  });
});

check('a cell inside a volume is laid open', async () => {
  const mesh = bar(7, 5, 5);
  const cell = 2 * 35 + 2 * 7 + 3;
  await withReport(mesh, async (page, { settle, state }) => {
    const { x, y } = await place(page, cell);
    assert.notEqual(await page.evaluate(([a, b]) => window.evenmesh.pick(a, b), [x, y]), cell);
    await page.evaluate((c) => window.evenmesh.goTo(c), cell);
    await settle();
    assert.equal((await state()).cutAxis, 'view');
    const there = await place(page, cell, 'after');
    assert.equal(await page.evaluate(([a, b]) => window.evenmesh.pick(a, b), [there.x, there.y]), cell);
  });
});

check('cut, flip and shrink change what is seen, and the cut keeps whole cells', async () => {
  const mesh = bar(8, 3, 3);
  await withReport(mesh, async (page, { settle, state }) => {
    const pictures = [await picture(page)];
    const next = async () => { await settle(); pictures.push(await picture(page)); };
    await page.click('[aria-label="Cut along"] button:has-text("x")');
    await page.locator('[aria-label="Place of the cut"]').fill('0.5');
    await next();
    const half = (await state()).visibleCells;
    const middles = mesh.cells.map(({ vertices }) => vertices.reduce((sum, v) => sum + mesh.before[v][0], 0) / 8);
    const low = Math.min(...middles);
    const high = Math.max(...middles);
    assert.equal(half, middles.filter((x) => x <= (low + high) / 2).length);
    await page.click('button:has-text("Flip")');
    await next();
    assert.equal((await state()).visibleCells, 72 - half);
    await page.locator('[aria-label="Shrink cells"]').fill('0.6');
    await next();
    assert.ok(Math.abs((await state()).shrink - 0.7) < 1e-9);
    await page.click('[aria-label="Cut along"] button:has-text("view")');
    await next();
    assert.equal(new Set(pictures).size, pictures.length);
  });
});

check('wipe, single and blink show before and after where they say', async () => {
  const mesh = planarGrid(6);
  const [shape] = mesh.metrics;
  await withReport(mesh, async (page, { settle, state }) => {
    await page.keyboard.press('2');
    await settle();
    assert.equal((await state()).mode, 'wipe');
    await set(page, { wipe: 0.98 });
    await settle();
    const cell = shape.before.findIndex((v) => v < 0.6);
    const wanted = (side) => colourAt(Math.round(254 * shape[side][cell]) / 254);
    let [seen] = await pixels(page, [await place(page, cell, 'before')]);
    assert.ok(near(seen, wanted('before'), 6));
    await page.focus('.em-wipe');
    for (let i = 0; i < 50; ++i) await page.keyboard.press('ArrowLeft');
    assert.ok(Math.abs((await state()).wipe - 0.02) < 1e-9);
    await settle();
    [seen] = await pixels(page, [await place(page, cell, 'after')]);
    assert.ok(near(seen, wanted('after'), 6));

    await page.keyboard.press('3');
    await settle();
    const one = await picture(page);
    await page.keyboard.press('b');
    await settle();
    assert.deepEqual([(await state()).mode, (await state()).scrub], ['single', 0]);
    [seen] = await pixels(page, [await place(page, cell)]);
    assert.ok(near(seen, wanted('before'), 6));
    await page.keyboard.press('b');
    await settle();
    assert.equal(await picture(page), one);
  });
});

check('the scrub slider goes through the iterates', async () => {
  const mesh = planarGrid(5, { iterates: 3 });
  await withReport(mesh, async (page, { settle, state }) => {
    await set(page, { mode: 'single' });
    assert.equal((await state()).scrub, 4);
    for (const [value, label] of [['2', 'iterate 4'], ['2.5', 'iterate 4 → iterate 6, 50 %'], ['0', 'before'], ['4', 'after']]) {
      await page.locator('[aria-label="From before to after"]').fill(value);
      await settle();
      assert.equal(await page.textContent('.em-label:not([hidden])'), label);
    }
    await page.locator('[aria-label="From before to after"]').fill('2');
    await settle();
    // Where vertex 7 of the grid, a corner of cell 0, is at that iterate: all cells of the file in one scale.
    const wanted = mesh.cells[6].vertices.map((v) => mesh.iterates[1].points[v])
      .reduce((sum, p) => [sum[0] + p[0] / 4, sum[1] + p[1] / 4], [0, 0]);
    const { x, y } = await place(page, 6);
    const { target, halfHeight } = await page.evaluate(() => window.evenmesh.camera());
    const [width, height] = await page.evaluate(() => [window.evenmesh.canvas.clientWidth, window.evenmesh.canvas.clientHeight]);
    const unit = height / 2 / halfHeight;
    // Local coordinates are relative to the middle of the box, (2.5, 2.5).
    assert.ok(Math.abs((x - width / 2) / unit + target[0] + 2.5 - wanted[0]) < 1e-3);
    assert.ok(Math.abs(-(y - height / 2) / unit + target[1] + 2.5 - wanted[1]) < 1e-3);
  });
});

check('edges, shape edges, marks and arrows can be shown and hidden', async () => {
  await withReport(bar(4, 3, 3), async (page, { settle }) => {
    for (const key of ['e', 'o', 'm', 'v']) {
      const without = await picture(page);
      await page.keyboard.press(key);
      await settle();
      await page.waitForTimeout(50);
      await settle();
      const changed = await picture(page);
      assert.notEqual(changed, without, key);
      await page.keyboard.press(key);
      await settle();
      assert.equal(await picture(page), without, key);
    }
  });
});

check('worst cells only', async () => {
  await withReport(planarGrid(10), async (page, { settle, state }) => {
    await page.selectOption('[aria-label="Cells to show"]', 'listed');
    await settle();
    assert.equal((await state()).visibleCells, 10);
    await page.selectOption('[aria-label="Cells to show"]', 'all');
    assert.equal((await state()).visibleCells, 100);
  });
});

check('the mouse turns, moves and zooms', async () => {
  await withReport(bumpyBall(8), async (page, { settle }) => {
    const camera = () => page.evaluate(() => window.evenmesh.camera());
    const at = await camera();
    await mouseTo(page, { x: 200, y: 200 });
    await page.mouse.down();
    await page.mouse.move(500, 600, { steps: 3 });
    await page.mouse.up();
    await settle();
    const turned = await camera();
    assert.notEqual(turned.azimuth, at.azimuth);
    await page.keyboard.down('Shift');
    await page.mouse.down();
    await page.mouse.move(450, 560, { steps: 3 });
    await page.mouse.up();
    await page.keyboard.up('Shift');
    const moved = await camera();
    assert.equal(moved.azimuth, turned.azimuth);
    assert.notDeepEqual(moved.target, turned.target);
    await page.mouse.wheel(0, -200);
    await page.waitForFunction((h) => window.evenmesh.camera().halfHeight < h, moved.halfHeight);
    await page.keyboard.press('f');
    await settle();
    const fitted = await camera();
    assert.equal(fitted.azimuth, moved.azimuth);
    assert.ok(fitted.halfHeight > moved.halfHeight * 0.8);
  });
});

check('a zoom keeps the place under the pointer, in both pictures', async () => {
  await withReport(planarGrid(6), async (page, { settle }) => {
    for (const side of ['before', 'after']) {
      const at = await place(page, 8, side);
      await mouseTo(page, at);
      await page.mouse.wheel(0, -100);
      await page.waitForTimeout(60);
      await settle();
      const now = await place(page, 8, side);
      assert.ok(Math.hypot(now.x - at.x, now.y - at.y) < 1.5, `${side}: ${now.x - at.x} ${now.y - at.y}`);
    }
  });
});

check('keys reach everything, focus is seen, controls have names', async () => {
  await withReport(bar(4, 3, 3), async (page, { settle, state }) => {
    await page.keyboard.press('?');
    assert.ok(await page.locator('dialog[open]').count());
    await page.keyboard.press('Escape');
    assert.equal(await page.locator('dialog[open]').count(), 0);
    await page.keyboard.press('n');
    await settle();
    assert.notEqual((await state()).selected, -1);
    await page.focus('canvas');
    const { azimuth } = await page.evaluate(() => window.evenmesh.camera());
    await page.keyboard.press('ArrowLeft');
    assert.notEqual((await page.evaluate(() => window.evenmesh.camera())).azimuth, azimuth);
    await page.keyboard.press('t');
    assert.equal(await page.getAttribute('#evenmesh-app', 'data-theme'), 'dark');

    const nameless = await page.evaluate(() => [...document.querySelectorAll('#evenmesh-app :is(button, input, select, [role=slider], canvas)')]
      .filter((e) => !(e.getAttribute('aria-label') || e.textContent.trim() || e.closest('label')?.textContent.trim() || e.closest('[role=img]'))).map((e) => e.outerHTML));
    assert.deepEqual(nameless, []);
    await page.keyboard.press('Tab');
    const outline = await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle);
    assert.equal(outline, 'solid');
  });
});

check('hostile texts are shown as they are', async () => {
  const mesh = planarGrid(4);
  const bad = '<img src=x onerror="window.hacked=1">';
  const end = '</script><script>window.hacked=2</script>';
  const cruel = `${bad}${end}`;
  const named = { ...mesh, cellNames: mesh.cells.map((_, i) => `${cruel}${i}`) };
  await withReport(named, async (page) => {
    assert.equal(await page.textContent('h1:not(#evenmesh-static h1)'), cruel);
    await page.evaluate(() => window.evenmesh.goTo(5));
    await page.waitForSelector('.em-cell h3:has-text("onerror")');
    assert.match(await page.textContent('.em-cell h3'), /^quad <img src=x.*<\/script>5$/);
    await page.click('summary');
    const all = await page.textContent('#evenmesh-app');
    for (const where of ['verdict', 'ledger', 'note', 'held', 'command', 'message', 'group']) assert.ok(all.includes(`${where}${bad}`), where);
    assert.equal(await page.evaluate(() => window.hacked), undefined);
    assert.equal(await page.locator('#evenmesh-app img').count(), 0);
  }, {
    more: {
      title: cruel, program: cruel, command: `command${bad}`, notes: [`note${bad}`, end], groups: [`group${bad}`, end],
      verdicts: [{ name: `verdict${bad}`, pass: false, text: end }], ledger: [{ name: `ledger${bad}`, value: end }],
      worst: [{ name: cruel, kind: bad, cell: 5, shape_before: 0.1, shape_after: 0.2, inverted: false, held_by: [`held${bad}`, end] }],
      quality: [{ metric: bad, better: 'higher', unit: end, before: { worst: null, p1: 0, p5: 0, median: 1, mean: null } }],
      run: { status: 'ok', message: `message${bad}` },
    },
  });
});

check('a check has one picture and nothing of after', async () => {
  const mesh = planarGrid(5);
  delete mesh.after;
  for (const metric of mesh.metrics) metric.after = metric.before;
  const story = storyOf(mesh, { run: undefined, history: [], verdicts: [] });
  await withReport(mesh, async (page, { state }) => {
    assert.equal((await state()).mode, 'single');
    assert.equal(await page.locator('button:has-text("Blink")').count(), 0);
    assert.equal(await page.locator('.em-label:not([hidden])').count(), 0);
    await page.keyboard.press('b');
    assert.equal((await state()).mode, 'single');
  }, { more: { ...story, kind: 'check' } });
});

check('without WebGL the static report stays, with one line of explanation', async () => {
  const poor = await launch(['--disable-3d-apis', '--disable-gpu']);
  const mesh = planarGrid(4);
  const { page, finish } = await open(poor, writeReport(mesh, storyOf(mesh)));
  assert.match(await page.textContent('.em-message'), /needs WebGL 2/);
  assert.ok(await page.isVisible('#evenmesh-static'));
  assert.equal(await page.locator('canvas').count(), 0);
  await finish();
  await poor.close();
});

for (const [name, spoil, reason] of [
  ['of another format', (given) => { given.report.format = 7; }, /data format 7/],
  ['cut short', (given) => { given.data = given.data.subarray(0, given.data.length / 2); }, /cut short/],
  ['with a broken stream', (given) => { given.data.fill(7, given.report.arrays.points.offset, given.report.arrays.points.offset + 20); }, /"points" is damaged/],
  ['with no arrays', (given) => { delete given.report.arrays; }, /holds no mesh/],
]) {
  check(`a report ${name} says so and leaves the static part`, async () => {
    const mesh = planarGrid(4);
    const given = encodeReport(mesh, storyOf(mesh));
    spoil(given);
    const { page, finish } = await open(browser, writePage(htmlOf(given)));
    assert.match(await page.textContent('.em-message'), reason);
    assert.ok(await page.isVisible('#evenmesh-static'));
    await finish();
  });
}

check('a policy without the right hash stops the page: the tests would notice', async () => {
  const mesh = planarGrid(3);
  const html = htmlOf(encodeReport(mesh, storyOf(mesh))).replace(/script-src 'sha256-./, "script-src 'sha256-_");
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.setContent(html);
  assert.equal(await page.evaluate(() => window.evenmesh), undefined);
  await context.close();
});

check('printing shows the static report and the picture', async () => {
  await withReport(planarGrid(5), async (page) => {
    assert.ok(!await page.isVisible('#evenmesh-static'));
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    await page.emulateMedia({ media: 'print' });
    assert.ok(await page.isVisible('#evenmesh-static'));
    assert.ok(!await page.isVisible('#evenmesh-app'));
    assert.ok(await page.isVisible('img.em-printed'));
    assert.ok(await page.evaluate(() => document.querySelector('img.em-printed').naturalWidth) > 300);
  });
});

check('dark and narrow: everything fits', async () => {
  for (const width of [360, 800, 1400]) {
    await withReport(bumpyBall(8, { mixed: true }), async (page) => {
      const { wide, dark } = await page.evaluate(() => ({
        wide: document.documentElement.scrollWidth - document.documentElement.clientWidth,
        dark: document.getElementById('evenmesh-app').dataset.theme,
      }));
      assert.equal(wide, 0, `${width}: ${wide} pixels too wide`);
      assert.equal(dark, 'dark');
    }, { width, height: 800, colorScheme: 'dark' });
  }
});

check('command and record are copied', async () => {
  const mesh = planarGrid(3);
  await withReport(mesh, async (page) => {
    await page.evaluate(() => document.addEventListener('copy', () => { window.copied = String(document.getSelection()); }));
    await page.click('button:has-text("Copy command")');
    await page.waitForSelector('button:has-text("Copied")');
    await page.click('summary');
    await page.waitForFunction(() => document.querySelector('.em-json').textContent);
    assert.equal(JSON.parse(await page.textContent('.em-json')).status, 'ok');
  }, { permissions: ['clipboard-read', 'clipboard-write'] });
});

check('the picture can be saved', async () => {
  await withReport(planarGrid(3), async (page) => {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('button:has-text("Save picture")')]);
    assert.equal(download.suggestedFilename(), 'bracket.inp.png');
    assert.equal(readFileSync(await download.path()).subarray(1, 4).toString(), 'PNG');
  });
});
