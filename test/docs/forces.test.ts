import { COMPONENT_NAMES, createPhysicsWorld, spawn, step } from '@principia/physics';
import { expect, test } from 'vitest';
import { dimensionsOf, LAW_RECORDS, makeLaw } from '../support/law-records.ts';
import { forcePage, lawFiles } from './force-page.ts';

test('docs/forces.md says what the source says; `npx vitest run test/docs/forces.test.ts -u` writes it', async () => {
  await expect(forcePage()).toMatchFileSnapshot('../../docs/forces.md');
});

test('every law is on the page, with a header that gives its validity or source and its cost', () => {
  const made = lawFiles().flatMap(({ makers }) => makers);
  expect([...new Set(LAW_RECORDS.map(({ maker }) => maker))].toSorted()).toEqual(made.toSorted());
  for (const { file, header } of lawFiles()) {
    expect(header, file).toMatch(/Cost/);
    expect(header.split('\n').length, file).toBeGreaterThan(4);
  }
});

test.each(LAW_RECORDS)('$title reads components there are, and lets a world without them be', (record) => {
  const force = makeLaw(record);
  for (const name of force.reads) expect(COMPONENT_NAMES).toContain(name);
  // What names entities needs them.
  if (/faces|triangles|central/.test(Object.keys(record.args[0] ?? {}).join())) return;
  for (const dimensions of dimensionsOf(record)) {
    for (const precision of ['f32', 'f64'] as const) {
      const world = createPhysicsWorld({ dimensions, precision, capacity: 5, forces: [force] });
      const still = spawn(world, { position: { x: 3, y: 2 }, velocity: {} });
      step(world, 0.01);
      expect(world.components.Position.x[still]).toBe(3);
      expect(world.faults.faults.length).toBe(0);
    }
  }
});
