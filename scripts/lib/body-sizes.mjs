/**
 * Gives the size of every function body two bytes, whatever it is, so that whoever unpacks a module can put it there
 * once the end of the body is known, and it need not be packed. WebAssembly allows numbers that are longer than they
 * need to be (Core Specification 2.0, section 5.2.2).
 */

import { CODE, changeSections, number, readBodies } from './wasm-sections.mjs';

const MOST_BYTES = 1 << 14;

/**
 * @param {Uint8Array} wasm
 * @returns {Uint8Array}
 */
export function padBodySizes(wasm) {
  return changeSections(wasm, { [CODE]: padBodies });
}

/** @param {Uint8Array} content of the code section */
function padBodies(content) {
  const bodies = readBodies(content);
  const padded = bodies.map((body) => {
    const { length } = body;
    if (length >= MOST_BYTES) throw new Error(`A kernel has ${length} bytes, the packer takes ${MOST_BYTES - 1}.`);
    return Buffer.concat([Uint8Array.of((length & 127) | 128, length >> 7), body]);
  });
  return Buffer.concat([Uint8Array.from(number(bodies.length)), ...padded]);
}
