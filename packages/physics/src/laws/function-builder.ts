// A function being written: its instructions, locals and imports.
import type { ValueType } from './encode.ts';
import { Code } from './instructions.ts';
import type { Operation } from './node.ts';

/** How columns are stored and how lanes compute: energies are summed in doubles, whatever the columns are. */
export interface LaneTypes {
  readonly stored: 'f32' | 'f64';
  readonly computed: 'f32' | 'f64';
}

/** Writes a function in which the bodies at hand are at the byte offset in local `offset` of each column of reals. */
export class FunctionBuilder {
  readonly code = new Code();
  readonly locals: ValueType[] = [];
  readonly imports: Operation[] = [];
  /** Bodies in a vector. */
  readonly lanes: 2 | 4;

  /**
   * @param parameters number of the function's parameters
   * @param offset the local that holds the byte offset of the bodies at hand
   * @param noteOf what stands at an address, for people
   */
  constructor(
    readonly types: LaneTypes,
    readonly parameters: number,
    readonly offset: number,
    readonly noteOf: (address: number) => string | undefined,
  ) {
    this.lanes = types.computed === 'f32' ? 4 : 2;
  }

  /** A new local. */
  local(type: ValueType): number {
    this.locals.push(type);
    return this.parameters + this.locals.length - 1;
  }

  /** The instruction of this name for the lanes at hand. */
  lane(name: string, ...immediates: readonly number[]): void {
    this.code.add(`${this.lanes === 4 ? 'f32x4' : 'f64x2'}.${name}`, ...immediates);
  }

  /** A number in all lanes, as bytes. */
  vectorOf(value: number): number[] {
    const numbers = this.lanes === 4 ? new Float32Array(4) : new Float64Array(2);
    return [...new Uint8Array(numbers.fill(value).buffer)];
  }

  /** The index of an imported function. */
  importOf(name: Operation): number {
    const known = this.imports.indexOf(name);
    return known >= 0 ? known : this.imports.push(name) - 1;
  }
}
