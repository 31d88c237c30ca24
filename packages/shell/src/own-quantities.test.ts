import { createPhysicsWorld, spawn } from '@principia/physics';
import { expect, it } from 'vitest';
import { ownQuantities } from './own-quantities.ts';
import { readPlotChoice, writePlotChoice } from './plot-choice.ts';
import { quantitySource, sourceOf } from './plot-sources.ts';

function pendulum() {
  const world = createPhysicsWorld({ capacity: 9 });
  spawn(world, { position: { x: 2 }, mass: 2 });
  return { world, dt: 1 / 60, swings: 0 };
}

const quantities = {
  swings: { label: 'Swings', unit: '', value: (sim: ReturnType<typeof pendulum>) => sim.swings },
  distance: {
    label: 'Distance',
    unit: 'm',
    value: ({ world }: { world: ReturnType<typeof createPhysicsWorld> }) => world.components.Position.x[1],
  },
};

it('reads the quantities of the game that is on display', () => {
  let sim: ReturnType<typeof pendulum> | undefined;
  const own = ownQuantities(quantities, () => sim);
  expect(own.distance.value()).toBeNaN();
  sim = pendulum();
  const out = new Float64Array(1);
  const source = sourceOf('distance', 0, 2, own);
  expect(source).toMatchObject({ unit: 'm', series: [''] });
  source.read(sim.world, out);
  expect(out[0]).toBe(2);
  // After a restart there is another simulation.
  sim = { ...pendulum(), swings: 7 };
  quantitySource('swings', 0, 2, own).read(sim.world, out);
  expect(out[0]).toBe(7);
  expect(quantitySource('swings', 0, 2, own).series).toEqual(['Swings']);
});

it.each([
  ['distance', { what: 'distance', against: '', body: 0 }],
  ['distance,swings', { what: 'distance', against: 'swings', body: 0 }],
  ['Position.y,distance,2', { what: 'Position.y', against: 'distance', body: 2 }],
])('reads %s from the address, and writes what it read', (text, choice) => {
  const own = ownQuantities(quantities, pendulum);
  expect(readPlotChoice(text, 2, own)).toEqual(choice);
  expect(writePlotChoice(choice)).toBe(text);
  expect(readPlotChoice(text, 2)).toBeUndefined();
});

it.each(['Energy', 'off', 'a.b', 'a,b', '', '2nd'])('refuses the name “%s”', (name) => {
  expect(() => ownQuantities({ [name]: quantities.swings }, pendulum)).toThrow(`but is '${name}'`);
});
