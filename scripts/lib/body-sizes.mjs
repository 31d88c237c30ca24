/**
 * Gives the size of every function body two bytes, whatever it is, so that whoever unpacks a module can put it there
 * once the end of the body is known, and it need not be packed. WebAssembly allows numbers that are longer than they
 * need to be (Core Specification 2.0, section 5.2.2).
 */

const CODE_SECTION = 10;
const MOST_BYTES = 1 << 14;

/**
 * @param {Uint8Array} wasm
 * @returns {Uint8Array}
 */
export function padBodySizes(wasm) {
  const sections = [wasm.subarray(0, 8)];
  for (let at = 8; at < wasm.length; ) {
    const size = readNumber(wasm, at + 1);
    const end = size.end + size.value;
    if (wasm[at] !== CODE_SECTION) sections.push(wasm.subarray(at, end));
    else {
      const bodies = padBodies(wasm, size.end);
      sections.push(Uint8Array.of(CODE_SECTION, ...number(bodies.length)), bodies);
    }
    at = end;
  }
  return Buffer.concat(sections);
}

/**
 * @param {Uint8Array} wasm
 * @param {number} from where the content of the code section begins
 */
function padBodies(wasm, from) {
  const count = readNumber(wasm, from);
  const parts = [wasm.subarray(from, count.end)];
  for (let left = count.value, at = count.end; left > 0; left--) {
    const { value, end } = readNumber(wasm, at);
    if (value >= MOST_BYTES) throw new Error(`A kernel has ${value} bytes, the packer takes ${MOST_BYTES - 1}.`);
    at = end + value;
    parts.push(Uint8Array.of((value & 127) | 128, value >> 7), wasm.subarray(end, at));
  }
  return Buffer.concat(parts);
}

/**
 * An unsigned number of seven bits a byte, the lowest first.
 * @param {Uint8Array} bytes
 * @param {number} at
 */
export function readNumber(bytes, at) {
  let value = 0;
  for (let shift = 0, end = at; ; shift += 7) {
    const byte = bytes[end++];
    value += (byte & 127) * 2 ** shift;
    if (byte < 128) return { value, end };
  }
}

/** @param {number} value */
export function number(value) {
  const bytes = [];
  for (let left = value; ; left >>>= 7) {
    if (left < 128) return [...bytes, left];
    bytes.push((left & 127) | 128);
  }
}
