import { describe, expect, test } from 'vitest';
import { run, single } from '../../../../test/support/laws.ts';
import {
  addedMass,
  box,
  buoyancy,
  contactPoints,
  createPhysicsWorld,
  energy,
  heun,
  type Integrator,
  type PhysicsWorld,
  rigidBodies,
  rungeKutta4,
  spawn,
  step,
  uniformGravity,
  velocityVerlet,
} from '../index.ts';

const SEA = { density: 1000, level: 0 };
const R = 0.5;
/** A body of half the density of water, so that the added mass of the sphere is as large as its mass. */
const [volume, mass, coefficient] = [0.5, 250, 0.5];

/** Immersed fraction of a sphere or box of half height R, from the height of its centre. */
function fractionAt(y: number, shape: number): number {
  const d = Math.max(-1, Math.min(1, -y / R));
  return shape === 0 ? 0.5 + 0.25 * d * (3 - d * d) : 0.5 + 0.5 * d;
}

/** Energy of a body and of the fluid that it moves, ½ C ρ V f v², J. */
function energyWithFluid(world: PhysicsWorld, eid: number, shape: number): number {
  const { Position, Velocity } = world.components;
  const [x, y, z] = [Velocity.x[eid], Velocity.y[eid], Velocity.z[eid]];
  const added = coefficient * SEA.density * volume * fractionAt(Position.y[eid], shape);
  return energy(world).total + 0.5 * added * (x * x + y * y + z * z);
}

const forces = [uniformGravity(), buoyancy(SEA), addedMass(SEA, coefficient)];

describe('added mass at a surface', () => {
  const cases = [2, 3].flatMap((dimensions) =>
    ['f32', 'f64'].flatMap((precision) => ['sphere', 'box'].map((hull) => ({ dimensions, precision, hull }))),
  );

  test.each(cases)('a $hull that falls from 5 m dives to -5 m, $dimensions D, $precision', (given) => {
    const { dimensions, precision } = given as { dimensions: 2 | 3; precision: 'f32' | 'f64' };
    const shape = given.hull === 'sphere' ? 0 : 1;
    const body = { position: { y: 5 }, mass, hull: { volume, halfHeight: R, shape } };
    const { world, eid, at } = single(forces, body, { dimensions, precision, integrator: rungeKutta4 });
    const dt = 1 / 2000;
    const before = energyWithFluid(world, eid, shape);
    let deepest = 0;
    let change = 0;
    run(world, 4, dt, () => {
      deepest = Math.min(deepest, at().y);
      change = Math.max(change, Math.abs(energyWithFluid(world, eid, shape) - before));
    });
    // The force of the surface is ½ A' v², and begins in a step for which it is not known: A' = C ρ V/2R for a box, v² = 2 g 5 m.
    const jump = (0.5 * coefficient * SEA.density * volume * 98.1) / (2 * R);
    const error = jump * Math.sqrt(98.1) * dt;
    // The energy in single precision is rounded in each of 8000 steps, to one side at worst by 2⁻²⁵.
    const rounding = precision === 'f32' ? 8000 * 2 ** -25 * before : 0;
    expect(change).toBeLessThan(2 * error + rounding);
    // At the deepest point the net lift is m g: the buoyancy is twice the weight.
    expect(Math.abs(deepest + 5)).toBeLessThan((2 * error + rounding) / (mass * 9.8));
  });

  const integrators: readonly (readonly [string, Integrator])[] = [
    ['velocity Verlet', velocityVerlet],
    ['Heun', heun],
    ['Runge-Kutta 4', rungeKutta4],
  ];
  test.each(integrators)(
    'the energy of a bobbing sphere and its fluid is kept with the order of %s',
    (_, integrator) => {
      const changeWith = (dt: number) => {
        const body = { position: { y: 0.4 }, velocity: { x: 1 }, mass, hull: { volume, halfHeight: R } };
        const { world, eid } = single(forces, body, { integrator });
        const before = energyWithFluid(world, eid, 0);
        // The end of no oscillation, where the error of a scheme may vanish.
        run(world, 0.7, dt);
        return Math.abs(energyWithFluid(world, eid, 0) - before);
      };
      expect(Math.log2(changeWith(0.004) / changeWith(0.002))).toBeGreaterThan(integrator.order - 0.3);
    },
  );

  test('a ball that enters at a slant keeps its momentum and that of its fluid along the surface', () => {
    const body = { position: { y: 1 }, velocity: { x: 3, z: -2 }, mass, hull: { volume, halfHeight: R } };
    const { world, going } = single(forces, body, { dimensions: 3, integrator: rungeKutta4 });
    run(world, 1, 1e-3);
    // Wholly immersed it has m + C ρ V = 2 m. The force is smooth at the rim of a sphere but for its slope: third order there.
    expect(going().x).toBeCloseTo(1.5, 6);
    expect(going().z).toBeCloseTo(-1, 6);
  });

  test('motion relative to a flow along the surface does not depend on who looks', () => {
    const path = (stream: number) => {
      const laws = [uniformGravity(), buoyancy(SEA), addedMass({ ...SEA, flow: { x: stream } })];
      const body = { position: { y: 0.4 }, velocity: { x: 1 + stream }, mass, hull: { volume, halfHeight: R } };
      const { world, at } = single(laws, body, { integrator: rungeKutta4 });
      run(world, 2, 1e-2);
      return { x: at().x - stream * world.time, y: at().y };
    };
    expect(path(7).x).toBeCloseTo(path(0).x, 11);
    expect(path(7).y).toBeCloseTo(path(0).y, 11);
  });
});

test('a mass that includes the added mass, with gravity scaled, falls as with the law and presses with its whole weight', () => {
  const [dry, gravity] = [1000, 10];
  const added = coefficient * SEA.density;
  const water = [uniformGravity({ y: -gravity }), buoyancy({ density: SEA.density / 2, gravity: { y: -gravity } })];
  const stone = { mass: dry + added, gravityScale: dry / (dry + added), hull: 1, collider: { shape: box(1, 1) } };
  const world = createPhysicsWorld({ preset: rigidBodies, forces: water });
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(20, 1) } });
  const falling = spawn(world, { position: { y: 40 }, ...stone });
  spawn(world, { position: { y: 0.5 }, neverSleep: {}, ...stone });
  for (let i = 0; i < 60; i++) step(world, 1 / 60);
  const weight = (dry - SEA.density / 2) * gravity;
  expect(world.components.Velocity.y[falling]).toBeCloseTo(-weight / (dry + added), 9);
  const points = contactPoints(world);
  const pressed = points.impulse.slice(0, points.count).reduce((sum, impulse) => sum + impulse, 0);
  expect(pressed * 60).toBeCloseTo(weight, 3);
});
