import { describe, expect, it } from 'vitest';
import { ColumnUpload, TEXTURE_WIDTH, textureRows } from './column-upload.ts';

describe('ColumnUpload', () => {
  it('hands over an f32 column itself', () => {
    const column = new Float32Array(TEXTURE_WIDTH);
    const upload = new ColumnUpload();
    expect(upload.refresh(column, 10, 5)).toBe(column);
    expect(upload.origin).toBe(0);
  });

  it('rounds an f64 column into one shadow that it keeps', () => {
    const column = Float64Array.of(0.1, 0.2, 0.3);
    const upload = new ColumnUpload();
    const first = upload.refresh(column, 3);
    expect([...first]).toEqual([...Float32Array.of(0.1, 0.2, 0.3)]);
    column[1] = 7;
    expect(upload.refresh(column, 2)).toBe(first);
    expect(first[1]).toBe(7);
  });

  it('leaves values past the given length alone', () => {
    const column = Float64Array.of(1, 2, 3);
    const upload = new ColumnUpload();
    upload.refresh(column, 3);
    column.fill(9);
    expect([...upload.refresh(column, 2)]).toEqual([9, 9, 3]);
  });

  it('keeps millimetres a light-second away from zero when taken relative to a near origin', () => {
    const far = 299_792_458;
    const upload = new ColumnUpload();
    const data = upload.refresh(Float64Array.of(far + 0.001, far + 0.002), 2, far);
    expect(data[1] - data[0]).toBeCloseTo(0.001, 6);
    expect(upload.origin).toBe(far);
  });

  it('follows a column that was replaced', () => {
    const upload = new ColumnUpload();
    upload.refresh(new Float64Array(4), 4);
    const longer = new Float64Array(8).fill(2);
    expect([...upload.refresh(longer, 8)]).toEqual(new Array(8).fill(2));
    const single = new Float32Array(3);
    expect(upload.refresh(single, 3)).toBe(single);
  });
});

describe('textureRows', () => {
  const length = 100 * TEXTURE_WIDTH;

  it('covers what is used, at least one row, at most the array', () => {
    expect(textureRows(0, 0, length)).toBe(1);
    expect(textureRows(TEXTURE_WIDTH, 0, length)).toBe(1);
    expect(textureRows(TEXTURE_WIDTH + 1, 0, length)).toBe(2);
    expect(textureRows(length, 0, length)).toBe(100);
  });

  it('grows with slack and stays put while the population breathes', () => {
    const rows = textureRows(20 * TEXTURE_WIDTH, 1, length);
    expect(rows).toBe(25);
    expect(textureRows(23 * TEXTURE_WIDTH, rows, length)).toBe(25);
    expect(textureRows(8 * TEXTURE_WIDTH, rows, length)).toBe(25);
    expect(textureRows(5 * TEXTURE_WIDTH, rows, length)).toBe(6);
    // A large one is not sent with thousands of rows that nobody has.
    expect(textureRows(80 * TEXTURE_WIDTH, 1, length)).toBe(88);
  });

  it('refuses an array that is not a whole number of rows', () => {
    expect(() => textureRows(1, 0, 1000)).toThrow(/multiple of 1024, got 1000/);
    expect(() => textureRows(1, 0, 0)).toThrow(/multiple of 1024/);
  });
});
