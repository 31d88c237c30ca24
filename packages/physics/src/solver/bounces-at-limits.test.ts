// What bounces off a body that joint limits or taut ropes hold meets what does not move: these push, as far as they need to.
import {
  box,
  capsule,
  createJoint,
  distance,
  energy,
  jointPosition,
  type PhysicsWorld,
  prismatic,
  revolute,
  softStep,
  spawn,
  step,
  weld,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, disc, G, rigidWorld, SLOP } from '../../../../test/support/rigid-world.ts';

const MASS = 15;
const FALL = 1;

const slider = (world: PhysicsWorld, b: number, upper = 0.5) =>
  createJoint(world, prismatic({ b, anchor: {}, axis: { y: 1 }, limits: { lower: 0, upper } }));

const holders: Record<string, (world: PhysicsWorld, b: number) => void> = {
  'the limit of a slider': slider,
  'limits without room': (world, b) => slider(world, b, 0),
  'the limit of a hinge': (world, b) =>
    createJoint(world, revolute({ b, anchor: { x: -0.6 }, limits: { lower: 0, upper: 1 } })),
  'two taut ropes': (world, b) => {
    for (const x of [-0.6, 0.6]) {
      createJoint(world, distance({ b, anchorA: { x, y: 2 }, anchorB: { x }, limits: { upper: 2 } }));
    }
  },
};

function addPlate(world: PhysicsWorld, restitution: number): number {
  const collider = { shape: box(1.2, 0.3), friction: 0.5, restitution };
  return spawn(world, { position: {}, velocity: {}, mass: MASS, collider });
}

/** A crate that falls 1 m onto a plate at its limit: how fast it leaves, how far the plate sinks, m, and energy gained in a step, J/kg. */
function dropCrate(world: PhysicsWorld, plate: number, ratio: number, restitution: number, dt: number) {
  const position = { x: 0.1, y: 0.15 + 0.3 + FALL };
  const collider = { shape: box(0.6, 0.6), friction: 0.5, restitution };
  const crate = spawn(world, { position, velocity: {}, mass: ratio * MASS, collider });
  const { Velocity, Position } = world.components;
  let [rise, sunk, gain] = [0, 0, 0];
  let before = energy(world).total;
  for (let i = 0; i < 1 / dt; i++) {
    step(world, dt);
    rise = Math.max(rise, Velocity.y[crate] as number);
    sunk = Math.max(sunk, -(Position.y[plate] as number));
    const { total } = energy(world);
    gain = Math.max(gain, (total - before) / (ratio * MASS));
    before = total;
  }
  return { rise, sunk, gain };
}

/** A plate of 1 kg with e = 1 that rests at the lower limit of a slider. */
function addElasticPlate(world: PhysicsWorld): number {
  const collider = { shape: box(1, 0.2), restitution: 1 };
  const plate = spawn(world, { position: {}, velocity: {}, mass: 1, collider });
  slider(world, plate, 5);
  for (let i = 0; i < 30; i++) step(world, DT);
  return plate;
}

const speed = Math.sqrt(2 * G * FALL);

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  const cases = Object.keys(holders).flatMap((holder) => [1, 4, 16].map((ratio) => ({ holder, ratio })));

  it.each(cases)('a crate of $ratio times its mass leaves a plate on $holder with e v', ({ holder, ratio }) => {
    for (const dt of [1 / 60, 1 / 240]) {
      for (const restitution of [0.3, 0.9]) {
        const world = rigidWorld({ precision });
        const plate = addPlate(world, restitution);
        holders[holder]?.(world, plate);
        const { rise, sunk, gain } = dropCrate(world, plate, ratio, restitution, dt);
        // A step of 1/60 s ends within g Δt of the impact.
        expect(Math.abs(rise - restitution * speed)).toBeLessThan(0.25 * G * dt + 0.01 * speed);
        // The overlap of contact and limit in the sub-steps of the impact is pushed out, which lifts the crate by centimetres.
        expect(gain).toBeLessThan(0.02 * G * FALL);
        expect(sunk).toBeLessThan(ratio === 1 ? SLOP : 0.03);
      }
    }
  });

  it('a plate on its limit is as firm as one that is welded', () => {
    const sunk = [false, true].map((welded) => {
      const world = rigidWorld({ precision });
      const plate = addPlate(world, 0.9);
      if (welded) createJoint(world, weld({ b: plate, anchor: {} }));
      else slider(world, plate);
      return dropCrate(world, plate, 64, 0.9, 1 / 60).sunk;
    });
    expect(sunk[0]).toBeLessThan((sunk[1] as number) + SLOP);
  });

  it.each([0.08, 0.3, 1])('a ball of %f kg leaves a flipper that rests on its limit with e v', (mass) => {
    for (const motor of [undefined, { speed: -15, max: 200 }]) {
      const world = rigidWorld({ precision });
      const collider = { shape: capsule(0.8, 0.06), friction: 0.3 };
      const flipper = spawn(world, { position: { x: 0.4 }, velocity: {}, mass: 0.8, collider });
      createJoint(
        world,
        revolute({ b: flipper, anchor: {}, limits: { lower: 0, upper: 0.8 }, ...(motor && { motor }) }),
      );
      const ball = disc(world, { x: 0.5, y: 0.18 + FALL, radius: 0.12, mass, restitution: 0.9 });
      let rise = 0;
      for (let i = 0; i < 40; i++) {
        step(world, DT);
        rise = Math.max(rise, world.components.Velocity.y[ball] as number);
      }
      expect(Math.abs(rise - 0.9 * speed)).toBeLessThan(0.02 * speed);
    }
  });

  it.each([0.05, 1, 20])('a limit does not pull: a ball of %f kg from below throws the plate off it', (mass) => {
    const world = rigidWorld({ precision });
    const plate = addElasticPlate(world);
    const ball = disc(world, { y: -0.5, vy: 6, radius: 0.2, mass });
    const { y } = world.components.Velocity;
    let [met, left, thrown] = [0, 0, 0];
    for (let i = 0; i < 30 && thrown < 0.1; i++) {
      met = y[ball] as number;
      step(world, DT);
      [left, thrown] = [y[ball] as number, y[plate] as number];
    }
    // Elastic, with 1 kg at rest. Gravity takes g Δt = 0.16 m/s from both in the step, and what a joint bears lags a sub-step.
    expect(Math.abs(thrown - (2 * mass * met) / (mass + 1))).toBeLessThan(3 * G * DT);
    expect(Math.abs(left - ((mass - 1) * met) / (mass + 1))).toBeLessThan(3 * G * DT);
  });

  it('struck from both sides at once it lets go, and momentum and energy are those of three free bodies', () => {
    const world = rigidWorld({ precision });
    const plate = addElasticPlate(world);
    const below = disc(world, { y: -0.35, vy: 6, radius: 0.2, mass: 3 });
    const above = disc(world, { y: 0.35, vy: -6, radius: 0.2, mass: 1 });
    const { y } = world.components.Velocity;
    const kinetic = energy(world).kinetic;
    step(world, DT);
    const momentum = 3 * (y[below] as number) + (y[above] as number) + (y[plate] as number);
    // Gravity takes 5 g Δt in the step, less what the limit bears of the weight before the impact.
    expect(Math.abs(momentum - 12)).toBeLessThan(5 * G * DT);
    expect(y[above] as number).toBeGreaterThan(6);
    expect(energy(world).kinetic).toBeLessThan(kinetic);
    expect(energy(world).kinetic).toBeGreaterThan(0.95 * kinetic);
  });

  it.each([4, 16])(
    'a crate of %i times its mass that meets a plate on its way to the limit gains no energy',
    (ratio) => {
      for (let k = 0; k < 40; k++) {
        const world = rigidWorld({ precision, integrator: softStep({ sleepTime: 0 }) });
        const plate = addPlate(world, 0.5);
        const joint = createJoint(
          world,
          prismatic({ b: plate, anchor: {}, axis: { y: 1 }, limits: { lower: -0.5, upper: 0 } }),
        );
        const x = -0.3 + (0.6 * ((k * 7) % 11)) / 11;
        const collider = { shape: box(0.6, 0.6), friction: 0.5, restitution: 0.5 };
        const position = { x, y: 1 + 0.1 * k };
        spawn(world, { position, rotation: 0.3 * (k % 4), velocity: {}, mass: ratio * MASS, collider });
        let before = energy(world).total;
        for (let i = 0; i < 200; i++) {
          step(world, DT);
          const { total } = energy(world);
          // Overlap that is pushed out lifts the crate by less than 7 cm.
          expect((total - before) / (ratio * MASS)).toBeLessThan(0.07 * G);
          expect(jointPosition(world, joint)).toBeGreaterThan(-0.58);
          before = total;
        }
      }
    },
  );
});
