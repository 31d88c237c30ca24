/**
 * Numbers the types of functions anew in both builds of a module: alike in both, and by the first function that has them.
 * The build in f32 has more types, since what is always f64 differs there from what is a real, so the compiler numbers
 * them differently; numbered alike, the types of its functions go by those of the first build, which takes the packer
 * next to nothing. WebAssembly lets a module have a type twice.
 */
import { number, readNumber } from './body-sizes.mjs';

const TYPES = 1;
const FUNCTIONS = 3;

/**
 * @param {Uint8Array} f64
 * @param {Uint8Array} f32
 * @returns {{ f64: Uint8Array, f32: Uint8Array }}
 */
export function orderTypes(f64, f32) {
  const [wide, narrow] = [f64, f32].map(typesOfFunctions);
  if (wide.length !== narrow.length) return { f64, f32 };
  const pairs = wide.map((type, i) => `${type};${narrow[i]}`);
  const order = [...new Set(pairs)];
  const first = order.map((pair) => pairs.indexOf(pair));
  const functions = pairs.map((pair) => order.indexOf(pair));
  const types = (/** @type {number[][]} */ all) => first.map((i) => all[i]);
  return { f64: withTypes(f64, types(wide), functions), f32: withTypes(f32, types(narrow), functions) };
}

/**
 * The bytes of the type of each function.
 * @param {Uint8Array} wasm
 */
function typesOfFunctions(wasm) {
  /** @type {number[][]} */
  let types = [];
  /** @type {number[][]} */
  let ofFunctions = [];
  for (const { id, from } of sectionsOf(wasm)) {
    if (id === TYPES) types = readTypes(wasm, from);
    if (id === FUNCTIONS) ofFunctions = readNumbers(wasm, from).map((index) => types[index]);
  }
  return ofFunctions;
}

/**
 * @param {Uint8Array} wasm
 * @param {number[][]} types
 * @param {number[]} functions
 */
function withTypes(wasm, types, functions) {
  const sections = sectionsOf(wasm).map(({ id, from, end }) => {
    let content = wasm.subarray(from, end);
    if (id === TYPES) content = Uint8Array.from([...number(types.length), ...types.flat()]);
    if (id === FUNCTIONS) content = Uint8Array.from([...number(functions.length), ...functions.flatMap(number)]);
    return Buffer.concat([Uint8Array.of(id, ...number(content.length)), content]);
  });
  return Buffer.concat([wasm.subarray(0, 8), ...sections]);
}

/** @param {Uint8Array} wasm */
function sectionsOf(wasm) {
  const sections = [];
  for (let at = 8; at < wasm.length; ) {
    const size = readNumber(wasm, at + 1);
    const end = size.end + size.value;
    sections.push({ id: wasm[at], from: size.end, end });
    at = end;
  }
  return sections;
}

/**
 * The bytes of each type: parameters and results, behind a byte that says it is one of a function.
 * @param {Uint8Array} wasm
 * @param {number} from
 */
function readTypes(wasm, from) {
  const types = [];
  let { value: left, end: at } = readNumber(wasm, from);
  for (; left > 0; left--) {
    const start = at;
    for (let list = 0, next = at + 1; list < 2; list++) {
      const count = readNumber(wasm, next);
      at = next = count.end + count.value;
    }
    types.push([...wasm.subarray(start, at)]);
  }
  return types;
}

/**
 * @param {Uint8Array} wasm
 * @param {number} from
 */
function readNumbers(wasm, from) {
  const numbers = [];
  let { value: left, end: at } = readNumber(wasm, from);
  for (; left > 0; left--) {
    const read = readNumber(wasm, at);
    numbers.push(read.value);
    at = read.end;
  }
  return numbers;
}
