import { FIREWORKS_REACH, SHELL_NAMES, STAR_COLORS } from '@principia/scenes';
import * as fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { DEMO_SHOW } from './demo-show.ts';
import { LAST_TICK, MAX_CUES, quantize, readShow, writeShow } from './show.ts';
import { BEAT, ShowEditor } from './show-editor.ts';
import type { Cue } from './sim.ts';

const { halfWidth, halfDepth, lowest, highest } = FIREWORKS_REACH;

const cue = fc.record({
  tick: fc.integer({ min: 0, max: LAST_TICK }),
  x: fc.double({ min: -halfWidth, max: halfWidth, noNaN: true }),
  y: fc.double({ min: lowest, max: highest, noNaN: true }),
  z: fc.double({ min: -halfDepth, max: halfDepth, noNaN: true }),
  kind: fc.integer({ min: 0, max: SHELL_NAMES.length - 1 }),
  color: fc.integer({ min: 0, max: 7 }),
  power: fc.double({ min: 0, max: 1, noNaN: true }),
});
const show = fc.array(cue, { maxLength: MAX_CUES }).map((cues) => cues.map(quantize).sort((a, b) => a.tick - b.tick));

const problem = (text: string) => {
  try {
    readShow(text);
  } catch (error) {
    return (error as Error).message;
  }
  return '';
};

describe('a show as text', () => {
  it('survives encoding, in few characters that need no escaping in a URL', () => {
    fc.assert(
      fc.property(show, (cues) => {
        const text = writeShow(cues);
        expect(readShow(text)).toEqual(cues);
        expect(text).toMatch(/^3\.[\w-]+$/);
        // 4/3 characters per byte, six bytes per shell, and a check byte.
        expect(text.length).toBe(2 + Math.ceil((4 * (1 + 6 * cues.length)) / 3));
      }),
    );
  });

  it('rounds each number of a shell by at most half its resolution', () => {
    fc.assert(
      fc.property(cue, (wanted) => {
        const kept = quantize(wanted);
        expect(Math.abs(kept.tick - wanted.tick)).toBeLessThanOrEqual(3);
        expect(Math.abs(kept.x - wanted.x)).toBeLessThan(0.2001);
        expect(Math.abs(kept.y - wanted.y)).toBeLessThan(0.2001);
        expect(Math.abs(kept.z - wanted.z)).toBeLessThan(0.2001);
        expect(Math.abs(kept.power - wanted.power)).toBeLessThan(0.5 / 15 + 1e-9);
        expect(quantize(kept)).toEqual(kept);
      }),
    );
  });

  it('with one changed character is almost always rejected, always with the same kind of error', () => {
    const text = writeShow(DEMO_SHOW.map(quantize));
    let taken = 0;
    for (let i = 2; i < text.length; i++) {
      const other = `${text.slice(0, i)}${text[i] === 'A' ? 'B' : 'A'}${text.slice(i + 1)}`;
      if (problem(other) === '') taken++;
    }
    // With one check byte, one in 256 passes by chance; as 31 is odd, a change of one byte never passes.
    expect(taken / text.length).toBeLessThan(0.03);
    fc.assert(fc.property(fc.string(), (any) => typeof problem(any) === 'string'));
  });

  it.each([
    ['', 'does not begin with a version'],
    ['AAAA', 'does not begin with a version'],
    ['4.AAAA', 'version “4”, but this game reads versions 1 to 3'],
    ['toString.AAAA', 'version “toString”'],
    ['2.', 'invalid characters'],
    ['1.A!A', 'invalid characters'],
    ['1.A', 'cut off'],
    ['1.AAAA', 'its length is wrong'],
    [`${writeShow(DEMO_SHOW).slice(0, -7)}`, ''],
  ])('“%s” is rejected with a reason', (text, why) => {
    expect(problem(text)).toContain(why);
    expect(problem(text)).toMatch(/^The show in the address .*\.$/);
  });

  it('encodes every kind of shell and every colour', () => {
    expect(SHELL_NAMES).toHaveLength(9);
    expect(STAR_COLORS).toHaveLength(8);
  });

  it('of version 1, which has eight kinds, is still decoded', () => {
    // A willow after 3 s, and a chain after 102.3 s, which exceeds the range of version 2.
    const old = readShow('1.xAelnkS2_8CBB0M');
    expect(old).toEqual([
      { tick: 180, x: 12, y: 30, z: 2, kind: 1, color: 3, power: 0.4 },
      { tick: LAST_TICK, x: -47.2, y: 12.6, z: -14, kind: 6, color: 4, power: 0.2 },
    ]);
    expect(readShow(writeShow(old))).toEqual(old);
  });

  it('with an invalid number is rejected', () => {
    // Five bytes of 255 are 2^40 - 1, which exceeds the largest encoded shell; their checksum is right.
    expect(problem('2.bP______')).toContain('an invalid time');
  });

  it('with too many shells or in the wrong order is rejected', () => {
    const one = quantize({ ...DEMO_SHOW[0], tick: 600 });
    expect(problem(writeShow(Array.from({ length: 201 }, () => one)))).toContain(
      'has 201 shells, but at most 200 are allowed',
    );
    expect(problem(writeShow([one, { ...one, tick: 0 }]))).toContain('not sorted by time');
  });
});

describe('the editor', () => {
  const shell: Omit<Cue, 'tick'> = { x: 0, y: 30, z: 0, kind: 1, color: 2, power: 0.4 };

  it('adds every click a beat after the last, or at the cursor', () => {
    const editor = new ShowEditor();
    editor.add(shell);
    editor.add(shell);
    editor.seek(10 * BEAT);
    editor.add(shell);
    editor.seek(0.5 * BEAT);
    editor.add({ ...shell, kind: 5 });
    expect(editor.cues.map(({ tick }) => tick / BEAT)).toEqual([0, 0.5, 1, 10]);
    expect(editor.cues[1].kind).toBe(5);
    expect(editor.chosen).toBe(1);
  });

  it('moves, removes, clears, and undoes each of them', () => {
    const editor = new ShowEditor();
    for (let i = 0; i < 3; i++) editor.add({ ...shell, kind: i });
    editor.move(0, 10 * BEAT);
    expect(editor.cues.map(({ kind }) => kind)).toEqual([1, 2, 0]);
    expect(editor.chosen).toBe(2);
    editor.remove(0);
    editor.clear();
    expect(editor.cues).toEqual([]);
    const seen = [0, 1, 2, 3].map(() => {
      editor.undo();
      return editor.cues.map(({ kind }) => kind);
    });
    expect(seen).toEqual([
      [2, 0],
      [1, 2, 0],
      [0, 1, 2],
      [0, 1],
    ]);
  });

  it('keeps only values that the encoding can represent', () => {
    const editor = new ShowEditor();
    for (let i = 0; i < MAX_CUES; i++) expect(editor.add(shell)).toBe(true);
    expect(editor.add(shell)).toBe(false);
    expect(Math.max(...editor.cues.map(({ tick }) => tick))).toBe(LAST_TICK);
    expect(readShow(writeShow(editor.cues))).toEqual(editor.cues);
  });
});
