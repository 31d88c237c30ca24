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
  pathChoice,
  phaseChoice,
  quantitySource,
  totalsOf,
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
  const units = { J: 'km⁵/s⁴', 'm/s': 'km/s' };
  expect(inUnits(energySource, units).unit).toBe('km⁵/s⁴');
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

it('reads one quantity for the horizontal axis: a part of a total, a column of a body, or the mean of all', () => {
  expect(totalsOf(2)).toEqual([
    'Energy.kinetic',
    'Energy.potential',
    'Energy.total',
    'Momentum.x',
    'Momentum.y',
    'Angular momentum.z',
  ]);
  expect(totalsOf(3)).toHaveLength(9);
  const quantity = (name: string, body = 0) => quantitySource(name, body, 2);
  expect(read(quantity('Energy.total'))).toEqual([9.5]);
  expect(read(quantity('Momentum.y'))).toEqual([5]);
  expect(read(quantity('Angular momentum.z'))).toEqual([13]);
  expect([0, 1, 2].map((body) => read(quantity('Position.x', body))[0])).toEqual([0.5, 2, -1]);
  expect(quantity('Velocity.y', 1)).toMatchObject({ unit: 'm/s', series: ['Velocity.y'] });
});

it('offers the path and the phase portrait of what moves', () => {
  const made = createPhysicsWorld({ capacity: 9 });
  spawn(made, { position: { x: 2 }, mass: 1 });
  expect(pathChoice(made, 0)).toEqual({ y: 'Position.y', x: 'Position.x', body: 1 });
  spawn(made, { position: {}, rotation: 0, angularVelocity: { z: 1 }, mass: 1 });
  expect(phaseChoice(made, 0)).toEqual({ y: 'AngularVelocity.z', x: 'Rotation.angle', body: 2 });
  spawn(made, { position: {}, velocity: { x: 1, y: -2 }, mass: 1 });
  expect(pathChoice(made, 0).body).toBe(3);
  expect(phaseChoice(made, 3)).toEqual({ y: 'Velocity.y', x: 'Position.y', body: 3 });
  expect(phaseChoice(made, 1)).toEqual({ y: 'Velocity.x', x: 'Position.x', body: 1 });
  expect(phaseChoice(made, 9)).toEqual({ y: 'Velocity.x', x: 'Position.x', body: 9 });
});
