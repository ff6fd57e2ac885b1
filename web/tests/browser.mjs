// SPDX-License-Identifier: MIT
//
// Opens reports in a real browser, and sees to it that they ask for nothing and complain about nothing.

import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';
import { encodeReport, htmlOf } from './encode.mjs';

const candidates = [process.env.CHROMIUM, '/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'];
export const executable = candidates.find((path) => path && existsSync(path));

/** For node:test's option `skip`. */
export const skip = executable ? false : 'no Chromium found: install it, or name it in the variable CHROMIUM';

const quiet = ['--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'];

export async function launch(more = []) {
  return chromium.launch({
    executablePath: executable,
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', ...quiet, ...more],
  });
}

export const folder = mkdtempSync(join(tmpdir(), 'evenmesh-web-'));
process.on('exit', () => rmSync(folder, { recursive: true, force: true }));

let files = 0;
export function writeReport(mesh, more) {
  return writePage(htmlOf(encodeReport(mesh, more)));
}
export function writePage(html) {
  const path = join(folder, `report${++files}.html`);
  writeFileSync(path, html);
  return path;
}

/**
 * A page with a report. `finish()` closes it and fails if there was a complaint or a request.
 * @param expected  complaints that are wanted, as a regular expression
 */
export async function open(browser, path, { width = 1400, height = 1000, expected = null, ...options } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, ...options });
  const page = await context.newPage();
  const complaints = [];
  const requests = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type()) && !/GPU stall due to ReadPixels/.test(message.text())) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('request', (request) => requests.push(request.url()));
  await page.addInitScript(() => {
    window.violations = [];
    document.addEventListener('securitypolicyviolation', (event) => window.violations.push(`${event.violatedDirective} ${event.blockedURI} ${event.sample}`));
  });
  const url = pathToFileURL(path).href;
  await page.goto(url);
  await page.evaluate(() => window.evenmesh.ready);
  return {
    page,
    settle: () => page.evaluate(() => window.evenmesh.settled()),
    state: () => page.evaluate(() => window.evenmesh.state()),
    async finish() {
      const violations = await page.evaluate(() => window.violations);
      await context.close();
      assert.deepEqual(violations, []);
      assert.deepEqual(complaints.filter((text) => !expected?.test(text)), []);
      assert.deepEqual(requests.filter((request) => request !== url && !request.startsWith('data:')), []);
    },
  };
}

/** Colours of places on the canvas, in CSS pixels, as drawn just now. */
export async function pixels(page, places) {
  return page.evaluate(async (list) => {
    const { canvas } = window.evenmesh;
    const image = new Image();
    image.src = await window.evenmesh.snapshot();
    await image.decode();
    const copy = document.createElement('canvas');
    copy.width = image.width;
    copy.height = image.height;
    const context = copy.getContext('2d', { willReadFrequently: true });
    context.drawImage(image, 0, 0);
    const ratio = image.width / canvas.clientWidth;
    return list.map(({ x, y }) => [...context.getImageData(Math.round(x * ratio), Math.round(y * ratio), 1, 1).data.slice(0, 3)]);
  }, places);
}

/** A number that changes if the picture does. */
export const picture = (page) => page.evaluate(() => window.evenmesh.snapshot());
