// Builds a function: its instructions, locals and imports.
import type { ValueType } from './encode.ts';
import { Code } from './instructions.ts';
import type { Operation } from './node.ts';

/** Storage type of columns and lane type of the computation: energies are summed in f64 for columns of either type. */
export interface LaneTypes {
  readonly stored: 'f32' | 'f64';
  readonly computed: 'f32' | 'f64';
}

/**
 * Builds a function in which the local `offset` holds the byte offset of the current bodies in each column of reals.
 */
export class FunctionBuilder {
  readonly code = new Code();
  readonly locals: ValueType[] = [];
  readonly imports: Operation[] = [];
  /** Bodies per vector. */
  readonly lanes: 2 | 4;
  /** The binary logarithm of the bytes of a stored real. */
  readonly realShift: 2 | 3;

  /**
   * @param parameters number of the function's parameters
   * @param offset the local that holds the byte offset of the current bodies
   * @param noteOf describes an address in printed code
   */
  constructor(
    readonly types: LaneTypes,
    readonly parameters: number,
    readonly offset: number,
    readonly noteOf: (address: number) => string | undefined,
  ) {
    this.lanes = types.computed === 'f32' ? 4 : 2;
    this.realShift = types.stored === 'f32' ? 2 : 3;
  }

  /** Adds a local. */
  local(type: ValueType): number {
    this.locals.push(type);
    return this.parameters + this.locals.length - 1;
  }

  /** Adds the instruction of this name for the current lane type. */
  lane(name: string, ...immediates: readonly number[]): void {
    this.code.add(`${this.lanes === 4 ? 'f32x4' : 'f64x2'}.${name}`, ...immediates);
  }

  /** Returns the bytes of a vector with a number in all lanes. */
  vectorOf(value: number): number[] {
    const numbers = this.lanes === 4 ? new Float32Array(4) : new Float64Array(2);
    return [...new Uint8Array(numbers.fill(value).buffer)];
  }

  /** Returns the index of an imported function. */
  importOf(name: Operation): number {
    const index = this.imports.indexOf(name);
    return index >= 0 ? index : this.imports.push(name) - 1;
  }
}
