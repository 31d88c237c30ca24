/**
 * Numbers the types of functions anew in both builds of a module: alike in both, and by the first function that has them.
 * The build in f32 has more types, since what is always f64 differs there from what is a real, so the compiler numbers
 * them differently; numbered alike, the types of its functions go by those of the first build, which takes the packer
 * next to nothing. WebAssembly lets a module have a type twice.
 */
import {
  changeSections,
  contentOf,
  FUNCTIONS,
  number,
  readList,
  readNumber,
  readTypes,
  TYPES,
} from './wasm-sections.mjs';

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
  const types = readTypes(contentOf(wasm, TYPES));
  return readList(contentOf(wasm, FUNCTIONS), readNumber).map((index) => types[index]);
}

/**
 * @param {Uint8Array} wasm
 * @param {number[][]} types
 * @param {number[]} functions
 */
function withTypes(wasm, types, functions) {
  return changeSections(wasm, {
    [TYPES]: () => [...number(types.length), ...types.flat()],
    [FUNCTIONS]: () => [...number(functions.length), ...functions.flatMap(number)],
  });
}
