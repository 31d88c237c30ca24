import { createPhysicsWorld, despawn, spawn } from '@principia/physics';
import { expect, it } from 'vitest';
import {
  angularMomentumSource,
  columnSource,
  columnsInUse,
  energySource,
  inUnits,
  momentumSource,
  type PlotSource,
} from './plot-sources.ts';

function world(dimensions: 2 | 3 = 2) {
  const made = createPhysicsWorld({ dimensions, capacity: 9 });
  spawn(made, { position: { x: 2 }, velocity: { y: 3 }, mass: 2 });
  spawn(made, { position: { x: -1 }, velocity: { y: -1 }, mass: 1 });
  return made;
}

const read = (source: PlotSource, from = world()) => {
  const out = new Float64Array(source.series.length);
  source.read(from, out);
  return [...out];
};

it('reads what is conserved', () => {
  expect(read(energySource)).toEqual([9.5, 0, 9.5]);
  expect(read(momentumSource(2))).toEqual([0, 5]);
  expect(read(momentumSource(3), world(3))).toEqual([0, 5, 0]);
  // m (x v_y - y v_x) = 2 · 2 · 3 + 1 · (-1) · (-1)
  expect(read(angularMomentumSource(2))).toEqual([13]);
  expect(read(angularMomentumSource(3), world(3))).toEqual([0, 0, 13]);
});

it('reads any column: of one body, or the range of all', () => {
  const name = { component: 'Position', field: 'x' } as const;
  expect(columnSource(name, 0)).toMatchObject({ unit: 'm', series: ['minimum', 'mean', 'maximum'] });
  expect(read(columnSource(name, 0))).toEqual([-1, 0.5, 2]);
  expect([1, 2, 3].map((body) => read(columnSource(name, body))[0])).toEqual([2, -1, Number.NaN]);
  const empty = world();
  for (const id of [1, 2]) despawn(empty, id);
  expect(read(columnSource(name, 0), empty)).toEqual([Number.NaN, Number.NaN, Number.NaN]);
});

it('shows the units of a world that is not in SI', () => {
  const units = { J: 'GM km²/s²', 'm/s': 'km/s' };
  expect(inUnits(energySource, units).unit).toBe('GM km²/s²');
  expect(read(inUnits(energySource, units))).toEqual(read(energySource));
  expect(inUnits(columnSource({ component: 'Velocity', field: 'x' }, 1), units).unit).toBe('km/s');
  expect(inUnits(momentumSource(2), units).unit).toBe('kg m/s');
});

it('offers the columns that hold anything', () => {
  expect(columnsInUse(world()).map(({ component, field }) => `${component}.${field}`)).toEqual([
    'Position.x',
    'Velocity.y',
    'Mass.value',
  ]);
});
