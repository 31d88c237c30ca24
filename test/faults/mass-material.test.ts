import { type BodyInput, ballMass, boxWalls, discMass, energy, spawn, step } from '@principia/physics';
import { addComponent, set } from 'bitecs';
import { describe, expect, it } from 'vitest';
import {
  assertRefused,
  assertWorldAlive,
  ball,
  DT,
  groundWorld,
  KINDS,
  steps,
  withWitness,
} from '../support/worlds.ts';

describe.each(KINDS)('mass and material, $dimensions D $precision', (kind) => {
  const refuse = (body: BodyInput, expected: { code: string; field: string; hint?: RegExp }) => {
    const world = groundWorld(kind);
    ball(world, 0, 1);
    assertRefused(world, () => spawn(world, { position: { y: 1 }, ...body }), expected);
    assertWorldAlive(world);
  };

  it('24 mass 0 is refused, with a hint for static bodies', () => {
    refuse({ mass: 0 }, { code: 'E_RANGE', field: 'mass', hint: /omit Mass/ });
    const world = groundWorld(kind);
    const eid = ball(world, 0, 1);
    assertRefused(world, () => addComponent(world, eid, set(world.components.Mass, 0)), {
      code: 'E_RANGE',
      entity: eid,
    });
  });

  it('24 a mass that the column cannot represent is refused too', () => {
    refuse({ mass: 1e-46 }, { code: 'E_RANGE', field: 'mass' });
  });

  it('25 negative mass is refused', () => {
    refuse({ mass: -1 }, { code: 'E_RANGE', field: 'mass' });
  });

  it.each([0, -5, NaN])('25 mass %d written into the column: forces do not move the body', (bad) => {
    const { world, victim } = withWitness(({ world, victim }) => {
      world.components.Mass.value[victim] = bad;
    }, kind);
    expect(world.components.Position.y[victim]).toBe(2);
  });

  it('26 infinite mass makes a static body', () => {
    const world = groundWorld(kind);
    const eid = spawn(world, { position: { x: 1, y: 7 }, mass: Infinity });
    expect(world.components.Mass.value[eid]).toBe(0);
    steps(world, 10);
    expect(world.components.Position.y[eid]).toBe(7);
    expect(Number.isFinite(energy(world).total)).toBe(true);
    assertWorldAlive(world);
  });

  it.each([
    [NaN, 'E_NONFINITE'],
    [Infinity, 'E_NONFINITE'],
    [0, 'E_RANGE'],
    [-1000, 'E_RANGE'],
  ])('27 a body of density %d is refused before it exists', (density, code) => {
    const massOf = kind.dimensions === 2 ? discMass : ballMass;
    const world = groundWorld(kind);
    ball(world, 0, 1);
    assertRefused(world, () => spawn(world, { position: { y: 1 }, mass: massOf(density, 0.1) }), {
      code,
      field: 'density',
    });
    assertWorldAlive(world);
  });

  it('28 zero inertia locks the rotation: friction slows the body without rotating it', () => {
    const slide = (inertia: number) => {
      const world = groundWorld({ ...kind, walls: [boxWalls({ min: { y: 0 } })] });
      const eid = spawn(world, {
        position: { y: 0.1 },
        velocity: { x: 3 },
        angularVelocity: {},
        mass: 1,
        inertia,
        collider: { radius: 0.1, friction: 0.5 },
      });
      // Friction acts while the body presses on the floor; a few steps suffice.
      steps(world, 10);
      return [world.components.Velocity.x[eid], world.components.AngularVelocity.z[eid]];
    };
    const [lockedSpeed, lockedSpin] = slide(0);
    expect(lockedSpin).toBe(0);
    expect(lockedSpeed).toBeLessThan(3);
    const [, freeSpin] = slide(0.005);
    expect(freeSpin).toBeLessThan(0);
  });

  it('28 negative and NaN inertia are refused; infinite means zero', () => {
    refuse({ inertia: -1 }, { code: 'E_RANGE', field: 'inertia' });
    refuse({ inertia: NaN }, { code: 'E_NONFINITE', field: 'inertia' });
    const world = groundWorld(kind);
    const eid = spawn(world, { position: {}, inertia: Infinity });
    expect(world.components.Inertia.value[eid]).toBe(0);
  });

  it('29 friction NaN or below 0 is refused', () => {
    refuse({ collider: { friction: NaN } }, { code: 'E_NONFINITE', field: 'collider.friction' });
    refuse({ collider: { friction: -0.1 } }, { code: 'E_RANGE', field: 'collider.friction' });
  });

  it('30 restitution NaN or below 0 is refused; above 1 is allowed and stays bounded', () => {
    refuse({ collider: { restitution: NaN } }, { code: 'E_NONFINITE', field: 'collider.restitution' });
    refuse({ collider: { restitution: -1 } }, { code: 'E_RANGE', field: 'collider.restitution' });
    refuse({ collider: { restitution: 11 } }, { code: 'E_RANGE', field: 'collider.restitution' });
    const { world, victim } = withWitness(
      ({ world, victim }) => addComponent(world, victim, set(world.components.Collider, { restitution: 3 })),
      kind,
      400,
    );
    expect(Number.isFinite(world.components.Velocity.y[victim])).toBe(true);
  });

  it.each(['radius', 'restitution', 'friction'] as const)(
    '29 NaN in the column Collider.%s does not spread',
    (field) => {
      const { world, victim } = withWitness(
        ({ world, victim }) => {
          world.components.Collider[field][victim] = NaN;
        },
        kind,
        60,
      );
      const { Position, Velocity } = world.components;
      expect([Position.y[victim], Velocity.y[victim]].every(Number.isFinite)).toBe(true);
    },
  );

  it.each([0, -1, NaN, Infinity, 1e-12])('32 a collider of radius %d is refused', (radius) => {
    refuse({ collider: radius }, { code: Number.isFinite(radius) ? 'E_RANGE' : 'E_NONFINITE', field: 'collider' });
  });

  it('a body without a collider falls through the floor, and one with it does not', () => {
    const world = groundWorld(kind);
    const point = spawn(world, { position: { y: 0.2 }, velocity: {}, mass: 1 });
    const solid = ball(world, 3, 0.2);
    for (let i = 0; i < 60; i++) step(world, DT);
    expect(world.components.Position.y[point]).toBeLessThan(-1);
    expect(world.components.Position.y[solid]).toBeGreaterThan(0);
  });
});
