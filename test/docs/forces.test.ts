import { COMPONENT_NAMES, createPhysicsWorld, spawn, step } from '@principia/physics';
import { expect, test } from 'vitest';
import { dimensionsOf, LAW_RECORDS, makeLaw } from '../support/law-records.ts';
import { callOf, forcePage, lawFiles } from './force-page.ts';

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

/** The call of a function, wherever it is. */
function callTo(maker: string) {
  const file = lawFiles().find(({ makers }) => makers.includes(maker))?.file;
  return callOf(maker, file ?? maker);
}

test('the page lists the options of a call, with those of the types that an option type extends', () => {
  expect(callTo('immersedDrag').call).toBe('immersedDrag({ density, gravity?, level?, flow?, waves? })');
  expect(callTo('wing').call).toMatch(/^wing\(\{ area, lift, drag, position\?, /);
  expect(callTo('vortex').call).toBe('vortex({ strength, radius, centre?, centreVelocity? })');
  expect(callTo('addedMass').call).toBe('addedMass({ density, gravity?, level?, flow?, waves? }, coefficient?)');
  expect(callTo('springs').call).toBe('springs()');
  expect(callTo('uniformGravity')).toEqual({
    call: 'uniformGravity(acceleration?)',
    options: [
      {
        name: 'acceleration',
        isOptional: true,
        type: 'VectorInput',
        meaning: 'g, m/s²; by default standard gravity downwards',
      },
    ],
  });
});

test.each(LAW_RECORDS)('every option that $title is given is on the page', ({ maker, args }) => {
  const names = callTo(maker).options.map(({ name }) => name);
  const given = args
    .filter((argument) => typeof argument === 'object')
    .flatMap((argument) => Object.keys(argument ?? {}));
  expect([...names, 'x', 'y', 'z']).toEqual(expect.arrayContaining(given));
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
