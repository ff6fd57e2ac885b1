// SPDX-License-Identifier: MIT

import assert from 'node:assert/strict';
import test from 'node:test';
import { bytesFromBase64 } from '../src/data/base64.js';
import { decodeIntegers, makeArrays } from '../src/data/decode.js';
import { encodeArray } from './encode.mjs';

const spec = (count, components, planes, rule) => ({ count, components, planes, rule });

test('planes are joined with the lowest byte first', () => {
  // 0x0102 and 0xa0b0c0d0, four planes of two bytes.
  const bytes = Uint8Array.from([0x02, 0xd0, 0x01, 0xc0, 0x00, 0xb0, 0x00, 0xa0]);
  assert.deepEqual([...decodeIntegers(bytes, spec(2, 1, 4, 'unsigned'))], [0x0102, 0xa0b0c0d0]);
});

test('zigzag gives signed integers', () => {
  const bytes = Uint8Array.from([0, 1, 2, 3, 255]);
  assert.deepEqual([...decodeIntegers(bytes, spec(5, 1, 1, 'signed'))], [0, -1, 1, -2, -128]);
});

test('delta adds to the entry before, component by component', () => {
  // Steps (1, -1), (2, 0), (-1, 5).
  const bytes = Uint8Array.from([2, 1, 4, 0, 1, 10]);
  assert.deepEqual([...decodeIntegers(bytes, spec(6, 2, 1, 'delta'))], [1, -1, 3, -1, 2, 4]);
});

test('highwater counts up where the code is 0', () => {
  // The first triangle names 0 1 2, the second 2 1 3.
  const bytes = Uint8Array.from([0, 0, 0, 1, 2, 0]);
  assert.deepEqual([...decodeIntegers(bytes, spec(6, 1, 1, 'highwater'))], [0, 1, 2, 2, 1, 3]);
});

test('every rule gives back what was encoded, to the limits of 32 bits', async () => {
  const cases = [
    ['unsigned', 1, [0, 1, 255, 256, 65535, 65536, 4294967295]],
    ['signed', 3, [0, -1, 1, 2147483647, -2147483648, 70000]],
    ['delta', 3, [5, -5, 1000000, -7, 0, 3, -1000000, 1, 1]],
    ['highwater', 1, [0, 1, 2, 1, 0, 3, 4, 0]],
    ['delta', 1, []],
  ];
  for (const [rule, components, values] of cases) {
    const { stream, spec: entry } = encodeArray(values, rule, components);
    const array = makeArrays({ it: { offset: 0, ...entry } }, new Uint8Array(stream));
    assert.deepEqual([...await array('it')], values, rule);
  }
});

test('an array is decoded when asked for, once; one that is absent is null', async () => {
  const { stream, spec: entry } = encodeArray([1, 2, 3], 'unsigned');
  const array = makeArrays({ it: { offset: 0, ...entry }, broken: { offset: 0, ...entry, bytes: 2 } }, new Uint8Array(stream));
  assert.equal(array('it'), array('it'));
  assert.equal(await array('absent'), null);
  assert.equal(await array('toString'), null);
});

test('damage is named with the array that has it', async () => {
  const { stream, spec: entry } = encodeArray([1, 2, 3], 'unsigned');
  const array = makeArrays({
    short: { offset: 0, ...entry, bytes: stream.length - 3 },
    beyond: { offset: 5, ...entry },
    miscounted: { offset: 0, ...entry, count: 4 },
    unruly: { offset: 0, ...entry, rule: 'other' },
  }, new Uint8Array(stream));
  await assert.rejects(array('short'), /array "short" is damaged/);
  await assert.rejects(array('beyond'), /array "beyond" ends at byte .* cut short/);
  await assert.rejects(array('miscounted'), /array "miscounted" is damaged: 4 bytes expected, 3 found/);
  await assert.rejects(array('unruly'), /unknown rule "other"/);
});

test('base64 may have line ends, and must be base64', () => {
  assert.deepEqual([...bytesFromBase64('AQID\nBAU=\n')], [1, 2, 3, 4, 5]);
  assert.throws(() => bytesFromBase64('%%%'), /not valid base64/);
});
