import { describe, expect, it } from 'vitest';
import { bufferLength } from './buffer-capacity.ts';
import { writeColor } from './color.ts';
import { applyLineStyle, checkLength, lineCount } from './line-style.ts';

describe('line style', () => {
  it('writes thickness and colour, with defaults', () => {
    const target = { uniforms: {} as Record<string, number | Float32Array> };
    applyLineStyle(target, { color: 0xff8000, opacity: 0.5 });
    expect(target.uniforms.uThickness).toBe(2);
    expect([...(target.uniforms.uLineColor as Float32Array)]).toEqual([1, Math.fround(128 / 255), 0, 0.5]);
  });

  it('says what is wrong', () => {
    const target = { uniforms: {} };
    expect(() => applyLineStyle(target, { thickness: 0 })).toThrow(/thickness.*got 0/);
    expect(() => writeColor(new Float32Array(4), 0x1000000)).toThrow(/0xffffff/);
    expect(() => writeColor(new Float32Array(4), 0, 2)).toThrow(/opacity.*got 2/);
    expect(() => checkLength('pairs', [1, 2], 4)).toThrow(/pairs must hold at least 4.*got 2/);
  });

  it('counts lines, and refuses arrays that end within one', () => {
    expect(lineCount('pairs', [1, 2, 3, 4], 2)).toBe(2);
    expect(lineCount('pairs', [1, 2, 3, 4], 2, 1)).toBe(1);
    expect(() => lineCount('pairs', [1, 2, 3], 2)).toThrow('pairs must hold 2 numbers for each line, got 3 in all');
    expect(() => lineCount('pairs', [1, 2], 2, 5)).toThrow('pairs must hold at least 10 numbers');
    for (const count of [-1, 0.5, Number.NaN]) {
      expect(() => lineCount('pairs', [1, 2], 2, count)).toThrow(`a whole number, 0 or more, got ${count}`);
    }
  });
});

describe('roomFor', () => {
  it('fills whole texture rows, at least one, and doubles', () => {
    expect(bufferLength(0, 0, 4)).toBe(4096);
    expect(bufferLength(1024, 4096, 4)).toBe(4096);
    expect(bufferLength(1025, 4096, 4)).toBe(8192);
    expect(bufferLength(3, 4096, 4)).toBe(4096);
  });

  it('refuses a count that is none', () => {
    expect(() => bufferLength(-1, 0, 4)).toThrow(/got -1/);
    expect(() => bufferLength(Number.NaN, 0, 4)).toThrow(/got NaN/);
  });
});
