import { describe, expect, it } from 'vitest';
import { bufferLength } from './buffer-capacity.ts';
import { writeColor } from './color.ts';
import { applyLineStyle, checkLength } from './line-style.ts';

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
