/**
 * Numbers the locals of every function anew, by type and then by where each is first used, which makes the next number
 * easier to guess than the compiler's order by how often each is used: 0.1 KB of a game with contacts. Locals that
 * nothing uses go. The numbers of parameters stay, so callers see no difference.
 */
import {
  CODE,
  changeSections,
  contentOf,
  FUNCTIONS,
  number,
  readBodies,
  readList,
  readNumber,
  readTypes,
  TYPES,
} from './wasm-sections.mjs';

/**
 * @param {Uint8Array} wasm
 * @returns {Uint8Array}
 */
export function orderLocals(wasm) {
  const parameters = readTypes(contentOf(wasm, TYPES)).map(parametersOf);
  const functions = readList(contentOf(wasm, FUNCTIONS), readNumber);
  return changeSections(wasm, {
    [CODE]: (content) => {
      const bodies = readBodies(content).map((body, i) => orderBody(body, parameters[functions[i]]));
      return [...number(bodies.length), ...bodies.flatMap((body) => [...number(body.length), ...body])];
    },
  });
}

/**
 * The types of the parameters of a type of function.
 * @param {number[]} type its bytes
 */
function parametersOf(type) {
  const count = readNumber(Uint8Array.from(type), 1);
  return type.slice(count.end, count.end + count.value);
}

/**
 * @param {Uint8Array} body
 * @param {number[]} parameters
 */
function orderBody(body, parameters) {
  const types = [...parameters];
  let { value: groups, end: at } = readNumber(body, 0);
  for (; groups > 0; groups--) {
    const count = readNumber(body, at);
    for (let left = count.value; left > 0; left--) types.push(body[count.end]);
    at = count.end + 1;
  }
  /** Instructions as they are, and the locals that stand between. @type {(Uint8Array | number)[]} */
  const pieces = [];
  /** @type {Set<number>} */
  const used = new Set();
  for (let from = at; at < body.length; ) {
    const local = body[at] >= 0x20 && body[at] <= 0x22;
    at = local ? at + 1 : instructionEnd(body, at);
    if (!local && at < body.length) continue;
    pieces.push(body.subarray(from, at));
    if (!local) break;
    const { value, end } = readNumber(body, at);
    pieces.push(value);
    used.add(value);
    from = at = end;
  }
  /** @type {Map<number, number[]>} */
  const ofType = new Map();
  for (const local of used) {
    if (local < parameters.length) continue;
    const type = types[local];
    ofType.set(type, [...(ofType.get(type) ?? []), local]);
  }
  const order = [...parameters.keys(), ...[...ofType.values()].flat()];
  const header = [...ofType].flatMap(([type, locals]) => [...number(locals.length), type]);
  const code = pieces.flatMap((piece) => (typeof piece === 'number' ? number(order.indexOf(piece)) : [...piece]));
  return [...number(ofType.size), ...header, ...code];
}

/**
 * Where an instruction ends that is not of a local: after the numbers and then the other bytes that belong to its opcode
 * (Core Specification 2.0, section 5.4).
 * @param {Uint8Array} body
 * @param {number} at
 */
function instructionEnd(body, at) {
  const op = body[at];
  const prefixed = op >= 0xfc ? readNumber(body, at + 1) : { value: -1, end: at + 1 };
  const [numbers, bytes] = op === 0xfd ? simdOperands(prefixed.value) : operands(op, prefixed.value, body, at + 1);
  let end = prefixed.end;
  for (let left = numbers; left > 0; left--) end = readNumber(body, end).end;
  return end + bytes;
}

/** @param {number} simd the opcode after the prefix */
function simdOperands(simd) {
  if (simd === 12 || simd === 13) return [0, 16];
  const lane = simd >= 0x54 && simd <= 0x5b;
  const memory = simd <= 11 || lane || simd === 0x5c || simd === 0x5d;
  return [memory ? 2 : 0, lane || (simd >= 0x15 && simd <= 0x22) ? 1 : 0];
}

/**
 * @param {number} op
 * @param {number} prefixed the opcode after the prefix, if there is one
 * @param {Uint8Array} body
 * @param {number} at where its operands begin
 */
function operands(op, prefixed, body, at) {
  if (op === 0xfc) return [prefixed === 10 ? 2 : Number(prefixed === 11), 0];
  if (op === 0x0e) return [readNumber(body, at).value + 2, 0];
  if (op === 0x43) return [0, 4];
  if (op === 0x44) return [0, 8];
  if (op >= 0x28 && op <= 0x3e) return [2, 0];
  const one = (op >= 0x02 && op <= 0x04) || op === 0x0c || op === 0x0d || op === 0x10;
  return [one || op === 0x23 || op === 0x24 || (op >= 0x3f && op <= 0x42) ? 1 : 0, 0];
}
