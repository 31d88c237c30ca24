// Joints know the axes on which a body does not move: along them it bears as much as one that is static.
import { box, createJoint, type PhysicsWorld, prismatic, revolute, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

/** A cart of 0.1 kg at the origin, and a bob of 10 kg that hangs from its centre, level with it at first. */
function hung(locks: { x?: boolean; y?: boolean } | 'static', precision: 'f32' | 'f64', frame = false) {
  const world = rigidWorld({ precision });
  const shape = { shape: box(1, 0.5), layers: 0 };
  const cart =
    locks === 'static'
      ? spawn(world, { position: {}, collider: shape })
      : spawn(world, { position: {}, collider: { ...shape, density: 0.2 }, motionLocks: locks });
  const bob = spawn(world, { position: { x: 1 }, collider: { shape: box(0.5, 0.5), density: 40, layers: 0 } });
  createJoint(world, revolute({ a: cart, b: bob, anchor: { x: 0, y: 0 } }));
  // With two more bodies the hinges form a loop, which is solved in another way.
  if (frame) {
    const [c, d] = [0, 1].map((x) =>
      spawn(world, { position: { x, y: -1 }, collider: { shape: box(0.2, 0.2), density: 25, layers: 0 } }),
    );
    createJoint(world, revolute({ a: bob, b: d as number, anchor: { x: 1, y: -1 } }));
    createJoint(world, revolute({ a: d as number, b: c as number, anchor: { x: 0, y: -1 } }));
    createJoint(world, revolute({ a: c as number, b: cart, anchor: { x: 0, y: 0 } }));
  }
  return { world, cart, bob };
}

/** How far the bob's end of the hinge is from the centre of the cart, m. */
function gapOf(world: PhysicsWorld, cart: number, bob: number): number {
  const { Position, Rotation } = world.components;
  const angle = Rotation.angle[bob] as number;
  const x = (Position.x[bob] as number) - Math.cos(angle) - (Position.x[cart] as number);
  return Math.hypot(x, (Position.y[bob] as number) - Math.sin(angle) - (Position.y[cart] as number));
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each([false, true])(
    'a light body that is locked on both axes bears a bob of a hundred times its mass as a static one does (in a loop: %s)',
    (frame) => {
      const locked = hung({ x: true, y: true }, precision, frame);
      const fixed = hung('static', precision, frame);
      const gaps = [0, 0];
      let apart = 0;
      for (let i = 0; i < 120; i++) {
        [locked, fixed].forEach(({ world, cart, bob }, k) => {
          step(world, DT);
          gaps[k] = Math.max(gaps[k] as number, gapOf(world, cart, bob));
        });
        const [a, b] = [locked, fixed].map(({ world, bob }) => world.components.Rotation.angle[bob] as number);
        apart = Math.max(apart, Math.abs((a as number) - (b as number)));
      }
      // The hinge gives way as much as one to a static body, and the bob swings by more than three radians in the meantime.
      expect(gaps[0]).toBeLessThan(1.1 * (gaps[1] as number));
      expect(apart).toBeLessThan(0.005);
    },
  );

  it('a cart on a rail swings against its bob about the centre of mass', () => {
    const { world, cart, bob } = hung({ y: true }, precision);
    const { Position, Mass } = world.components;
    const [m, M] = [Mass.value[cart] as number, Mass.value[bob] as number];
    for (let i = 0; i < 300; i++) {
      step(world, DT);
      const centre = (m * (Position.x[cart] as number) + M * (Position.x[bob] as number)) / (m + M);
      // No force acts along the rail.
      expect(centre).toBeCloseTo(M / (m + M), precision === 'f32' ? 4 : 9);
      expect(Position.y[cart]).toBe(0);
      expect(gapOf(world, cart, bob)).toBeLessThan(0.01);
    }
  });

  it('a motor drives a slider on a locked body as on a static one', () => {
    const speeds = [{ x: true, y: true }, 'static' as const].map((locks) => {
      const world = rigidWorld({ precision });
      const collider = { shape: box(1, 0.5), layers: 0 };
      const base = spawn(
        world,
        locks === 'static'
          ? { position: {}, collider }
          : { position: {}, collider: { ...collider, density: 0.2 }, motionLocks: { ...locks, angle: true } },
      );
      const slider = spawn(world, { position: { y: 1 }, collider: { shape: box(0.5, 0.5), density: 40, layers: 0 } });
      createJoint(
        world,
        prismatic({ a: base, b: slider, anchor: { y: 1 }, axis: { x: 0, y: 1 }, motor: { speed: 0.5, max: 1e4 } }),
      );
      run(world, 1);
      return world.components.Velocity.y[slider] as number;
    });
    expect(speeds[0]).toBeCloseTo(0.5, 3);
    expect(speeds[1]).toBeCloseTo(0.5, 3);
  });
});
