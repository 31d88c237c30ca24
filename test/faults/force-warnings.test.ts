/** Forces that are legal and surely not meant get a warning, once, that says what to do. */
import {
  boris,
  buoyancy,
  constantTorque,
  magneticField,
  mutualGravity,
  spawn,
  step,
  uniformGravity,
  wisdomHolman,
} from '@principia/physics';
import { expect, it } from 'vitest';
import { warnedWorld } from '../support/warned-world.ts';

it('names two constants of gravity that differ, and no others', () => {
  const warned = (own: { G?: number }, ...Gs: number[]) => {
    const forces = Gs.map((G) => mutualGravity({ G }));
    const { world, messages } = warnedWorld({ forces, integrator: wisdomHolman(own) });
    spawn(world, { position: {}, mass: 1 });
    spawn(world, { position: { x: 1 }, velocity: { y: 1 }, mass: 1e-3 });
    for (let i = 0; i < 2; i++) step(world, 0.01);
    return messages();
  };
  expect(warned({}, 1)).toBe('wisdomHolman has G = 6.6743e-11, but mutualGravity has G = 1: the orbits are wrong.');
  expect(warned({ G: 1 }, 1)).toBe('');
  expect(warned({ G: 1 }, 1 + 1e-12)).toBe('');
  expect(warned({ G: 1 })).toBe('');
  // Two forces may share one constant.
  expect(warned({ G: 1 }, 0.75, 0.25)).toBe('');
});

it('names a magnetic field that acts by boris and by a force', () => {
  const warned = (field: number, ofForce: number) => {
    const forces = [magneticField({ z: ofForce })];
    const { world, messages } = warnedWorld({ forces, integrator: boris({ field: { z: field } }) });
    spawn(world, { position: {}, velocity: { x: 1 }, mass: 1, charge: 1 });
    for (let i = 0; i < 2; i++) step(world, 0.01);
    return messages();
  };
  expect(warned(0.5, 0.5)).toBe('the magnetic field of boris is in `world.forces` as well, and acts twice.');
  // Another field adds to that of the integrator.
  expect(warned(0.5, 0.2)).toBe('');
  expect(warned(0, 0)).toBe('');
});

it.each([2, 3] as const)('names a body that a torque does not turn, %d D', (dimensions) => {
  const turning = dimensions === 2 ? { rotation: 0, angularVelocity: 0 } : { orientation: {}, angularVelocity: {} };
  const warned = (init: object, forces = [constantTorque({ z: 1 })]) => {
    const { world, messages } = warnedWorld({ dimensions, forces });
    spawn(world, { position: {}, mass: 1, ...init });
    for (let i = 0; i < 2; i++) step(world, 0.01);
    return messages();
  };
  const message = 'constantTorque does not turn body 1, because it has Inertia and no AngularVelocity.';
  expect(warned({ inertia: 1 })).toBe(message);
  expect(warned({ inertia: 1, ...turning })).toBe('');
  expect(warned({ inertia: Number.POSITIVE_INFINITY })).toBe('');
  expect(warned({})).toBe('');
  expect(warned({ inertia: 1 }, [])).toBe('');
});

it('names gravity along z in a 2D world', () => {
  const warned = (dimensions: 2 | 3, acceleration: object) => {
    const { world, messages } = warnedWorld({ dimensions, forces: [uniformGravity(acceleration)] });
    spawn(world, { position: {}, velocity: {}, mass: 1 });
    for (let i = 0; i < 2; i++) step(world, 0.01);
    return messages();
  };
  expect(warned(2, { z: -9.8 })).toBe('uniformGravity has z = -9.8, which has no effect in a 2D world.');
  expect(warned(2, { y: -9.8, z: 0 })).toBe('');
  expect(warned(3, { z: -9.8 })).toBe('');
});

it('says that buoyancy carries nothing without a hull', () => {
  const { world, messages } = warnedWorld({ forces: [buoyancy({ density: 1000, level: 0 })] });
  step(world, 0.01);
  expect(messages()).toBe('');
  spawn(world, { position: {}, mass: 1, collider: 0.5 });
  step(world, 0.01);
  expect(messages()).toBe('buoyancy has no effect, because no body of this world has a Hull.');
  const floating = warnedWorld({ forces: [buoyancy({ density: 1000, level: 0 })] });
  spawn(floating.world, { position: {}, mass: 1, collider: 0.5 });
  spawn(floating.world, { position: {}, mass: 1, hull: 0.01 });
  step(floating.world, 0.01);
  expect(floating.messages()).toBe('');
});
