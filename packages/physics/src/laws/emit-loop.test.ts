// A loop over columns made by hand: what it stores and lists, with one and with two vectors in an iteration, and that it
// does neither where it stops.
import { describe, expect, test } from 'vitest';
import { LISTED_VECTOR_BYTES, LISTED_VECTOR_SIZE, WALL_LIST_BYTES } from '../memory/layouts.gen.ts';
import { compileLoop, instantiateLoop, type Loop } from './compile.ts';
import { Graph } from './graph.ts';
import type { LoopSource } from './loop-source.ts';

const ROWS = 32;
const [X, Y, LIST] = [64, 1024, 4096];
/** Walls are at 10, and values from 1000 are out of range. */
const [WALL, FAR] = [10, 1000];

interface Lab {
  readonly run: Loop;
  readonly x: Float32Array | Float64Array;
  readonly y: Float32Array | Float64Array;
  /** The rows of the listed vectors. */
  listed(): number[];
  /** The values of a listed vector at the start. */
  starts(entry: number): number[];
}

/** y := x + 1, which must stay under the wall and within range. */
function makeLab(stored: 'f32' | 'f64', vectors: 1 | 2): Lab {
  const bytes = stored === 'f32' ? 4 : 8;
  const memory = new WebAssembly.Memory({ initial: 1 });
  const compiled = compileLoop(`test of loops ${stored} ${vectors}`, () => sourceOf(stored, vectors));
  const run = instantiateLoop(compiled, memory, () => ({}));
  const column = (at: number, count = ROWS) =>
    stored === 'f32' ? new Float32Array(memory.buffer, at, count) : new Float64Array(memory.buffer, at, count);
  const words = new Int32Array(memory.buffer);
  const first = LIST + WALL_LIST_BYTES;
  words[LIST / 4] = first;
  const listed = () => {
    const entries = (words[LIST / 4] - first) / LISTED_VECTOR_SIZE;
    return Array.from({ length: entries }, (_, i) => words[(first + i * LISTED_VECTOR_SIZE) / 4] / bytes);
  };
  const starts = (entry: number) => {
    const at = first + entry * LISTED_VECTOR_SIZE + LISTED_VECTOR_BYTES;
    return Array.from(column(at, 16 / bytes));
  };
  return { run, x: column(X), y: column(Y), listed, starts };
}

function sourceOf(stored: 'f32' | 'f64', vectors: 1 | 2): LoopSource {
  const graph = new Graph();
  const x = graph.make('real', [], X);
  const y = graph.make('add', [x, graph.constant(1)]);
  const inside = graph.make('lessOrEqual', [y, graph.constant(WALL)]);
  return {
    name: 'test',
    types: { stored, computed: stored },
    stores: [{ address: Y, node: y }],
    vectors,
    inRange: graph.make('less', [y, graph.constant(FAR)]),
    walls: { inside, list: LIST, startVelocity: [x] },
    fastCheck: inside,
    noteOf: () => undefined,
  };
}

describe.each(['f32', 'f64'] as const)('%s', (stored) => {
  const lanes = stored === 'f32' ? 4 : 2;

  describe.each([1, 2] as const)('%i vectors in an iteration', (vectors) => {
    const rows = vectors * lanes;

    test('every row is stored, and the vectors with a body beyond the wall are listed', () => {
      const { run, x, y, listed, starts } = makeLab(stored, vectors);
      x.forEach((_, i) => {
        x[i] = i / 8;
      });
      const beyond = [0, lanes, 3 * lanes + 1, 16];
      for (const row of beyond) x[row] = WALL;
      expect(run(0, ROWS, 1)).toBe(ROWS);
      expect(Array.from(y)).toEqual(Array.from(x, (value) => value + 1));
      expect(listed()).toEqual([0, lanes, 3 * lanes, 16]);
      [0, lanes, 3 * lanes, 16].forEach((row, entry) => {
        expect(starts(entry), 'what they were at the start').toEqual(Array.from(x.subarray(row, row + lanes)));
      });
    });

    test.each([0, 1, rows - 1])('a value out of range in row %i of an iteration stops the loop before it', (place) => {
      const { run, x, y, listed } = makeLab(stored, vectors);
      x.fill(1);
      // In the iteration before, and in each vector of the one that stops.
      x[0] = WALL;
      for (let row = rows; row < 2 * rows; row += lanes) x[row] = WALL;
      x[rows + place] = FAR;
      expect(run(0, ROWS, 1)).toBe(rows);
      expect(Array.from(y.slice(0, 2 * rows))).toEqual([WALL + 1, ...Array(rows - 1).fill(2), ...Array(rows).fill(0)]);
      expect(listed()).toEqual([0]);
      // Unchecked, it goes on, and each vector is listed once.
      expect(run(rows, 2 * rows, 0)).toBe(2 * rows);
      expect(y[rows + place]).toBe(FAR + 1);
      expect(listed()).toEqual([0, ...Array.from({ length: vectors }, (_, v) => rows + v * lanes)]);
    });
  });
});
