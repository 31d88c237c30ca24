// The columns of the bodies at hand, as lanes.
import { UniformEmitter } from './emit-uniform.ts';

/** Emits what is read of bodies. */
export class ColumnEmitter extends UniformEmitter {
  /** Reals of a column. */
  pushReal(address: number): void {
    const { stored, computed } = this.types;
    this.code.add('local.get', this.offset);
    const name = stored === computed ? 'v128.load' : 'v128.load64_zero';
    this.code.memory(name, address, this.noteOf(address));
    if (stored !== computed) this.code.add('f64x2.promote_low_f32x4');
  }

  /** Four, or two, whole numbers of 32 bits. */
  loadWords(address: number): void {
    const { code } = this;
    code.add('local.get', this.offset);
    if (this.types.stored === 'f64') code.add('i32.const', 1).add('i32.shr_u');
    const name = this.lanes === 4 ? 'v128.load' : 'v128.load64_zero';
    code.memory(name, address, this.noteOf(address));
  }

  /** Whole numbers of a column, as reals. */
  pushWord(address: number): void {
    this.loadWords(address);
    this.code.add(this.lanes === 4 ? 'f32x4.convert_i32x4_u' : 'f64x2.convert_low_i32x4_u');
  }

  /** Whether all bits of a number are set in the membership of the bodies. */
  pushHas(address: number, bits: number): void {
    const { code } = this;
    this.loadWords(address);
    const wanted = this.lanes === 4 ? Uint32Array.of(bits, bits, bits, bits) : Uint32Array.of(bits, 0, bits, 0);
    const bytes = new Uint8Array(wanted.buffer);
    if (this.lanes === 2) code.add('i64x2.extend_low_i32x4_u');
    code
      .add('v128.const', ...bytes)
      .add('v128.and')
      .add('v128.const', ...bytes);
    code.add(this.lanes === 4 ? 'i32x4.eq' : 'i64x2.eq');
  }

  /** The row of the body in a lane. */
  pushRow(lane: number): void {
    const { code } = this;
    code
      .add('local.get', this.offset)
      .add('i32.const', this.types.stored === 'f32' ? 2 : 3)
      .add('i32.shr_u');
    if (lane > 0) code.add('i32.const', lane).add('i32.add');
  }

  /** The ids of the entities, as reals. */
  pushEntity(): void {
    this.pushRow(0);
    this.code
      .add('i32x4.splat')
      .add('v128.const', ...new Uint8Array(Uint32Array.of(0, 1, 2, 3).buffer))
      .add('i32x4.add');
    this.code.add(this.lanes === 4 ? 'f32x4.convert_i32x4_u' : 'f64x2.convert_low_i32x4_u');
  }
}
