// Kernels write within their allocations only: the bytes between allocations, and behind the last, stay zero.
import { step } from '@principia/physics';
import { SCENES } from '@principia/scenes';
import { expect, it, vi } from 'vitest';
import type { Arena } from '../../packages/physics/src/memory/arena.ts';
import { EXAMPLES } from '../../packages/scenes/src/examples/examples.gen.ts';

interface Region {
  readonly start: number;
  readonly end: number;
  readonly what: string;
}

const regions = vi.hoisted(() => new Map<WebAssembly.Memory, Region[]>());

vi.mock('../../packages/physics/src/memory/arena.ts', async (importOriginal) => {
  const original = await importOriginal<typeof import('../../packages/physics/src/memory/arena.ts')>();
  return {
    ...original,
    allocate(arena: Arena, bytes: number, what: string, hint?: string) {
      const start = original.allocate(arena, bytes, what, hint);
      const list = regions.get(arena.memory) ?? [];
      regions.set(arena.memory, list);
      list.push({ start, end: start + bytes, what });
      return start;
    },
  };
});

/** The allocations behind which unallocated bytes are not zero. */
function overrun(memory: WebAssembly.Memory): string[] {
  const sorted = [...(regions.get(memory) as Region[])].sort((a, b) => a.start - b.start);
  const bytes = new Uint8Array(memory.buffer);
  return sorted.flatMap(({ end, what }, i) => {
    const next = sorted[i + 1]?.start ?? bytes.length;
    return bytes.subarray(end, next).some((byte) => byte !== 0) ? [`${what}, ${next - end} bytes behind it`] : [];
  });
}

// Rows are taken by thousands, and lists go wrong at their ends: 1 000 bodies fill most of the rows, whatever else there is.
const cases = SCENES.flatMap((scene) => [700, 1000, 1650].map((count) => ({ scene, name: scene.name, count })));

it.each(cases)('of $name with $count bodies', ({ scene, count }) => {
  const most = scene.parameters.count?.max ?? count;
  for (const precision of ['f32', 'f64'] as const) {
    const { world, dt } = scene.create({ count: Math.min(count, most), precision });
    for (let i = 0; i < 8; i++) step(world, dt);
    expect(overrun(world.memory)).toEqual([]);
    expect(world.faults.faults).toEqual([]);
  }
});

it.each(EXAMPLES)('of the example $id', async ({ load }) => {
  const { world, dt, observe } = (await load()).start();
  for (let i = 0; i < 30; i++) {
    step(world, dt);
    observe();
  }
  expect(overrun(world.memory)).toEqual([]);
});
