import { expect, test } from 'vitest';
import { createTestBodySource } from '../../../test/support/body-source.ts';
import { createBodyMesh } from './body-mesh.ts';
import { createSegmentLines } from './segment-lines.ts';

/** Bytes of heap a call of `frame` takes, from enough calls that one small object each would show. */
function bytesPerCall(frame: () => void): number {
  const calls = 20_000;
  for (let i = 0; i < 5000; i++) frame();
  const readings: number[] = [];
  for (let round = 0; round < 5; round++) {
    const before = process.memoryUsage().heapUsed;
    for (let i = 0; i < calls; i++) frame();
    readings.push((process.memoryUsage().heapUsed - before) / calls);
  }
  // A collection in between makes a reading negative: the middle one is none of those.
  return readings.sort((a, b) => a - b)[2];
}

test.each(['f32', 'f64'] as const)('a frame after a step makes no garbage (%s)', (precision) => {
  const source = createTestBodySource(1024, 3, precision);
  source.radius.fill(1);
  source.shape[2] = 2;
  source.show([1, 2, 3]);
  const bodies = createBodyMesh({ source });
  const bytes = bytesPerCall(() => {
    source.versions.pose++;
    bodies.update(0.5);
  });
  expect(bytes).toBeLessThan(8);
});

test('nor does a new list of lines', () => {
  const lines = createSegmentLines();
  const bytes = bytesPerCall(() => {
    lines.clear();
    for (let i = 0; i < 10; i++) lines.add(i, 0, 0, i, 1, 0.5);
  });
  expect(bytes).toBeLessThan(8);
});
