/** The sections of a WebAssembly module, and the lists in them (Core Specification 2.0, sections 5.2 and 5.5). */

export const TYPES = 1;
export const FUNCTIONS = 3;
export const EXPORTS = 7;
export const CODE = 10;

/** Where the first section begins. */
const HEADER = 8;

/**
 * The content of a section, which the module must have.
 * @param {Uint8Array} wasm
 * @param {number} id
 */
export function contentOf(wasm, id) {
  const found = sectionsOf(wasm).find((section) => section.id === id);
  if (found === undefined) throw new Error(`A kernel module has no section ${id}.`);
  return found.content;
}

/**
 * The module with other contents of some sections; the rest stays as it is, byte by byte.
 * @param {Uint8Array} wasm
 * @param {Record<number, (content: Uint8Array) => ArrayLike<number>>} changes by the section's id
 * @returns {Uint8Array}
 */
export function changeSections(wasm, changes) {
  const sections = sectionsOf(wasm).map(({ id, whole, content }) => {
    if (!(id in changes)) return whole;
    const changed = Uint8Array.from(changes[id](content));
    return Buffer.concat([Uint8Array.of(id, ...number(changed.length)), changed]);
  });
  return Buffer.concat([wasm.subarray(0, HEADER), ...sections]);
}

/** @param {Uint8Array} wasm */
function sectionsOf(wasm) {
  const sections = [];
  for (let at = HEADER; at < wasm.length; ) {
    const size = readNumber(wasm, at + 1);
    const end = size.end + size.value;
    sections.push({ id: wasm[at], whole: wasm.subarray(at, end), content: wasm.subarray(size.end, end) });
    at = end;
  }
  return sections;
}

/**
 * The items of a list, which begins with how many there are.
 * @template T
 * @param {Uint8Array} content
 * @param {(content: Uint8Array, at: number) => { value: T, end: number }} read an item, and where it ends
 */
export function readList(content, read) {
  const items = [];
  let { value: left, end: at } = readNumber(content, 0);
  for (; left > 0; left--) {
    const { value, end } = read(content, at);
    items.push(value);
    at = end;
  }
  return items;
}

/**
 * The bytes of each type of function: parameters and results, behind a byte that says it is one of a function.
 * @param {Uint8Array} content of the section of types
 */
export function readTypes(content) {
  return readList(content, (_, at) => {
    let end = at + 1;
    for (let list = 0; list < 2; list++) {
      const count = readNumber(content, end);
      end = count.end + count.value;
    }
    return { value: [...content.subarray(at, end)], end };
  });
}

/**
 * The bodies of the functions, without their sizes.
 * @param {Uint8Array} content of the code section
 */
export function readBodies(content) {
  return readList(content, (_, at) => {
    const size = readNumber(content, at);
    const end = size.end + size.value;
    return { value: content.subarray(size.end, end), end };
  });
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
