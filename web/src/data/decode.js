// SPDX-License-Identifier: MIT
//
// The integer arrays of a report: zlib, byte planes, then one of four rules.
// README.md, section "Data", is the contract.

const unzigzag = (u) => (u >>> 1) ^ -(u & 1);

/** Plane p holds bits 8p..8p+7 of every value. */
function joinPlanes(bytes, count, planes) {
  if (planes === 1) return bytes;
  const values = new Uint32Array(count);
  for (let p = 0; p < planes; ++p) {
    const shift = 8 * p;
    const start = p * count;
    for (let i = 0; i < count; ++i) values[i] |= bytes[start + i] << shift;
  }
  return values;
}

const rules = {
  unsigned: (u) => u,
  signed: (u) => Int32Array.from(u, unzigzag),
  delta(u, components) {
    const values = new Int32Array(u.length);
    for (let i = 0; i < components && i < u.length; ++i) values[i] = unzigzag(u[i]);
    for (let i = components; i < u.length; ++i) values[i] = values[i - components] + unzigzag(u[i]);
    return values;
  },
  highwater(u) {
    const values = new Int32Array(u.length);
    let high = 0;
    for (let i = 0; i < u.length; ++i) {
      values[i] = high - u[i];
      if (u[i] === 0) ++high;
    }
    return values;
  },
};

/**
 * Integers from the bytes that inflating gave.
 * @param spec  {count, components, planes, rule} as in the report's "arrays"
 */
export function decodeIntegers(bytes, { count, components = 1, planes, rule }) {
  if (!Object.hasOwn(rules, rule)) throw new Error(`unknown rule "${rule}"`);
  if (!(planes >= 1 && planes <= 4)) throw new Error(`${planes} byte planes, where 1 to 4 are possible`);
  if (bytes.length !== count * planes) {
    throw new Error(`${count * planes} bytes expected, ${bytes.length} found`);
  }
  return rules[rule](joinPlanes(bytes, count, planes), components);
}

async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/**
 * Access to the arrays of a report by name; each is decoded when first asked for, and once.
 *
 * `array(name)` is a promise of its integers, or of null where the report has none of that name.
 */
export function makeArrays(specs, data) {
  const decoded = new Map();
  async function decode(name) {
    if (!Object.hasOwn(specs, name)) return null;
    const spec = specs[name];
    const end = spec.offset + spec.bytes;
    if (!(spec.offset >= 0 && end <= data.length)) {
      throw new Error(`array "${name}" ends at byte ${end} of ${data.length}: the file is cut short`);
    }
    try {
      return decodeIntegers(await inflate(data.subarray(spec.offset, end)), spec);
    } catch (error) {
      throw new Error(`array "${name}" is damaged: ${error.message}`);
    }
  }
  return (name) => {
    if (!decoded.has(name)) decoded.set(name, decode(name));
    return decoded.get(name);
  };
}
