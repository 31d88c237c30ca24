// Prints functions in the text format of WebAssembly (Core Specification 2.0, section 6), with the names of columns as
// comments beside the addresses.
import { LOCALS } from './emit-checks.ts';
import type { ModuleSource } from './encode.ts';
import { type Instruction, opcodeOf } from './instructions.ts';

/** In the order of their indices. */
const NAMES = Object.keys(LOCALS);

/** A module as text. */
export function printModule(source: ModuleSource): string {
  const { imports, name, parameters, result, locals, code } = source;
  const nameOf = (index: number) => `$${NAMES[index] ?? `v${index}`}`;
  const lines = ['(module', '  (import "env" "memory" (memory 1))'];
  for (const each of imports) {
    lines.push(
      `  (import "math" "${each.name}" (func $${each.name} (param ${each.parameters.join(' ')}) (result f64)))`,
    );
  }
  lines.push(`  (func (export "${name}")`);
  lines.push(...parameters.map((type, i) => `    (param ${nameOf(i)} ${type})`));
  lines.push(`    (result ${result})`);
  lines.push(...locals.map((type, i) => `    (local ${nameOf(parameters.length + i)} ${type})`));
  let depth = 2;
  for (const instruction of code.instructions) {
    if (instruction.name === 'end' || instruction.name === 'else') depth--;
    lines.push(`${'  '.repeat(depth)}${printInstruction(instruction, source, nameOf)}`);
    if (/^(block|loop|if|else)$/.test(instruction.name)) depth++;
  }
  return `${lines.join('\n')}))\n`;
}

function printInstruction(
  { name, immediates, note }: Instruction,
  { imports }: ModuleSource,
  nameOf: (index: number) => string,
): string {
  const { kind } = opcodeOf(name);
  const [first] = immediates;
  const comment = note === undefined ? '' : `  ;; ${note}`;
  if (name.startsWith('local.')) return `${name} ${nameOf(first)}`;
  if (name === 'call') return `${name} $${imports[first].name}`;
  if (kind === 'memory') return `${name}${first === 0 ? '' : ` offset=${first}`}${comment}`;
  if (kind === 'vector') return `${name} ${printVector(immediates)}`;
  return immediates.length === 0 ? name : `${name} ${immediates.join(' ')}`;
}

/** Prints the bits of a vector, and its number if all lanes are equal. */
function printVector(bytes: readonly number[]): string {
  const { buffer } = Uint8Array.from(bytes);
  const words = Array.from(new Uint32Array(buffer), (word) => `0x${word.toString(16).padStart(8, '0')}`);
  const isSingle = words.every((word) => word === words[0]);
  const value = isSingle ? new Float32Array(buffer)[0] : new Float64Array(buffer)[0];
  return `i32x4 ${words.join(' ')}  ;; ${value}`;
}
