// Colliders that are altered while bodies rest on them, awake or asleep: the next step knows, though the points of contact are
// kept.
import { box, capsule, isAsleep, setShape, spawn, uniformGravity } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { G, rigidWorld, run, SLOP } from '../../../../test/support/rigid-world.ts';

/** Gravity along x, m/s², which friction of 0.5 holds and less than 0.3 does not. */
const PULL = 3;

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  /** A crate that has come to rest on a floor. */
  function crateOnFloor(isAwake: boolean, pull = 0) {
    const world = rigidWorld({ precision, forces: [uniformGravity({ x: pull, y: -G })] });
    const floor = spawn(world, { position: { y: -0.5 }, collider: { shape: box(100, 1), friction: 0.5 } });
    const crate = spawn(world, {
      position: { y: 0.5 },
      collider: { shape: box(1, 1), density: 1, friction: 0.5 },
      ...(isAwake ? { neverSleep: {} } : {}),
    });
    run(world, 2);
    expect(isAsleep(world, crate)).toBe(!isAwake);
    return { world, floor, crate, ...world.components };
  }

  describe.each([true, false])('on a body that is awake: %s', (isAwake) => {
    it('a conveyor that is switched on carries what lies on it', () => {
      const { world, floor, crate, Collider, Velocity } = crateOnFloor(isAwake);
      Collider.tangentSpeed[floor] = 2;
      // μ g brings it to that speed in 0.4 s.
      run(world, 1);
      expect(Velocity.x[crate]).toBeCloseTo(2, 3);
    });

    it.each(['floor', 'crate'] as const)('without the friction of the %s a crate slides', (which) => {
      const scene = crateOnFloor(isAwake, PULL);
      const { world, crate, Collider, Velocity } = scene;
      Collider.friction[scene[which]] = 0;
      run(world, 1);
      expect(Velocity.x[crate]).toBeCloseTo(PULL, 3);
    });

    it('another shape stands on the floor', () => {
      const { world, crate, Position } = crateOnFloor(isAwake);
      setShape(world, crate, box(1, 0.4));
      run(world, 1);
      expect(Math.abs(Position.y[crate] - 0.2)).toBeLessThan(SLOP);
      setShape(world, crate, box(1, 0.6));
      run(world, 1);
      expect(Math.abs(Position.y[crate] - 0.3)).toBeLessThan(SLOP);
    });

    it('what lies on a floor that became thinner falls', () => {
      const { world, floor, crate, Position } = crateOnFloor(isAwake);
      setShape(world, floor, box(100, 0.4));
      run(world, 1);
      expect(Math.abs(Position.y[crate] - 0.2)).toBeLessThan(SLOP);
    });
  });

  it('a hero that stands still crouches', () => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(100, 1), friction: 0.5 } });
    const collider = { shape: capsule(0.8, 0.4), density: 1 };
    const hero = spawn(world, { position: { y: 0.8 }, rotation: Math.PI / 2, motionLocks: { angle: 1 }, collider });
    run(world, 2);
    expect(isAsleep(world, hero)).toBe(true);
    setShape(world, hero, capsule(0.2, 0.4));
    run(world, 1);
    expect(Math.abs(world.components.Position.y[hero] - 0.5)).toBeLessThan(SLOP);
  });
});
