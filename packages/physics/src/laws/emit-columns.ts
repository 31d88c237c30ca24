// Emits loads and stores of the columns of the current bodies, in lanes.
import { UniformEmitter } from './emit-uniform.ts';

/** Emits values that are read per body. */
export class ColumnEmitter extends UniformEmitter {
  /** Which of the vectors of an iteration is emitted. */
  protected vector = 0;

  /** Bytes from `offset` to the current vector in a column whose values have 2^shift bytes. */
  #ahead(shift: number): number {
    return (this.vector * this.lanes) << shift;
  }

  /** Pushes the byte offset of the current vector in each column of reals. */
  pushOffset(): void {
    const { code } = this;
    code.add('local.get', this.offset);
    if (this.vector > 0) code.add('i32.const', this.#ahead(this.realShift)).add('i32.add');
  }

  /** Stores a local in a column of reals. */
  storeReal(address: number, local: number, note: string | undefined): void {
    const { code } = this;
    code.add('local.get', this.offset).add('local.get', local);
    code.memory('v128.store', address + this.#ahead(this.realShift), note);
  }

  /** Loads reals of a column. */
  pushReal(address: number): void {
    const { stored, computed } = this.types;
    this.code.add('local.get', this.offset);
    const name = stored === computed ? 'v128.load' : 'v128.load64_zero';
    this.code.memory(name, address + this.#ahead(this.realShift), this.noteOf(address));
    if (stored !== computed) this.code.add('f64x2.promote_low_f32x4');
  }

  /** Loads four (f32) or two (f64) 32-bit integers. */
  loadWords(address: number): void {
    const { code } = this;
    code.add('local.get', this.offset);
    if (this.types.stored === 'f64') code.add('i32.const', 1).add('i32.shr_u');
    const name = this.lanes === 4 ? 'v128.load' : 'v128.load64_zero';
    code.memory(name, address + this.#ahead(2), this.noteOf(address));
  }

  /** Loads integers of a column, converted to reals. */
  pushWord(address: number): void {
    this.loadWords(address);
    this.code.add(this.lanes === 4 ? 'f32x4.convert_i32x4_u' : 'f64x2.convert_low_i32x4_u');
  }

  /** Tests whether all given component bits of the bodies are set. */
  pushHas(address: number, bits: number): void {
    const { code } = this;
    this.loadWords(address);
    const expected = this.lanes === 4 ? Uint32Array.of(bits, bits, bits, bits) : Uint32Array.of(bits, 0, bits, 0);
    const bytes = new Uint8Array(expected.buffer);
    if (this.lanes === 2) code.add('i64x2.extend_low_i32x4_u');
    code
      .add('v128.const', ...bytes)
      .add('v128.and')
      .add('v128.const', ...bytes);
    code.add(this.lanes === 4 ? 'i32x4.eq' : 'i64x2.eq');
  }

  /** Pushes the row of the body in a lane. */
  pushRow(lane: number): void {
    const { code } = this;
    code
      .add('local.get', this.offset)
      .add('i32.const', this.types.stored === 'f32' ? 2 : 3)
      .add('i32.shr_u');
    const row = this.vector * this.lanes + lane;
    if (row > 0) code.add('i32.const', row).add('i32.add');
  }

  /** Pushes the entity ids as reals. */
  pushEntity(): void {
    this.pushRow(0);
    this.code
      .add('i32x4.splat')
      .add('v128.const', ...new Uint8Array(Uint32Array.of(0, 1, 2, 3).buffer))
      .add('i32x4.add');
    this.code.add(this.lanes === 4 ? 'f32x4.convert_i32x4_u' : 'f64x2.convert_low_i32x4_u');
  }
}
