// SPDX-License-Identifier: MIT
//
// Makes dist/ from src/. `--check` makes nothing and fails if dist/ is not what src/ gives.

import { build } from 'esbuild';
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

async function bundleScript() {
  const { outputFiles } = await build({
    entryPoints: [here('src/index.js')],
    bundle: true,
    minify: true,
    format: 'iife',
    target: ['es2022'],
    charset: 'ascii',          // the file it is embedded in may be read as anything
    legalComments: 'none',     // dist/LICENSES.txt has them in full
    write: false,
  });
  // A script element ends at the first "</script", wherever it stands; "<!--" changes how it is read.
  const text = outputFiles[0].text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
  if (/sourceMappingURL/.test(text)) throw new Error('the bundle names a file beside it');
  return text;
}

async function bundleStyle() {
  const parts = ['node_modules/uplot/dist/uPlot.min.css', 'src/report.css'];
  const text = (await Promise.all(parts.map((part) => readFile(here(part), 'utf8')))).join('\n');
  const { outputFiles } = await build({
    stdin: { contents: text, loader: 'css' }, minify: true, charset: 'ascii', legalComments: 'none', write: false,
    target: ['chrome111', 'firefox121', 'safari16.4'],
  });
  return outputFiles[0].text;
}

async function licences() {
  const parts = [['evenmesh', '../LICENSE'], ['three.js', 'node_modules/three/LICENSE'], ['uPlot', 'node_modules/uplot/LICENSE']];
  const texts = await Promise.all(parts.map(async ([name, path]) =>
    `${name}\n${'='.repeat(name.length)}\n\n${(await readFile(here(path), 'utf8')).trim()}\n`));
  return `report.js and report.css hold code of the following projects.\n\n${texts.join('\n\n')}`;
}

const made = { 'report.js': await bundleScript(), 'report.css': await bundleStyle(), 'LICENSES.txt': await licences() };

if (process.argv.includes('--check')) {
  for (const [name, text] of Object.entries(made)) {
    const committed = await readFile(here(`dist/${name}`), 'utf8').catch(() => '');
    if (committed !== text) {
      console.error(`dist/${name} is not what the sources give: run "npm run build" and commit it`);
      process.exitCode = 1;
    }
  }
} else {
  await mkdir(here('dist'), { recursive: true });
  for (const [name, text] of Object.entries(made)) await writeFile(here(`dist/${name}`), text);
  for (const [name, text] of Object.entries(made)) console.log(`dist/${name}  ${(text.length / 1024).toFixed(0)} KB`);
}
