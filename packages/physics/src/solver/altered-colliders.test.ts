// Colliders and poses that are altered while bodies rest on them, awake or asleep: the next step knows, though points of contact
// and what is known of bodies that do not move are kept.
import { box, capsule, despawn, isAsleep, setShape, spawn, uniformGravity } from '@principia/physics';
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

    it('what lies on a floor that was taken away falls freely', () => {
      const { world, floor, crate, Position } = crateOnFloor(isAwake);
      const y = Position.y[crate];
      Position.y[floor] = -100;
      world.versions.pose++;
      run(world, 1);
      // Four sub-steps of semi-implicit Euler fall by g t h / 2 more than g t²/2, and the crate may have slept for one.
      expect(y - Position.y[crate]).toBeGreaterThan((G / 2) * (1 - 1 / 60) ** 2);
      expect(y - Position.y[crate]).toBeLessThan((G / 2) * (1 + 1 / 240) + SLOP);
    });

    it('a crate slides down a floor that was tilted', () => {
      const { world, floor, crate, Collider, Position, Rotation, Velocity } = crateOnFloor(isAwake);
      Collider.friction[floor] = 0;
      run(world, 1);
      const angle = 0.1;
      Rotation.angle[floor] = angle;
      // About the middle of the crate's bottom.
      Position.x[floor] = 0.5 * Math.sin(angle);
      Position.y[floor] = -0.5 * Math.cos(angle);
      world.versions.pose++;
      run(world, 1);
      // The crate turns with the floor at first, and slides by g sin θ.
      const speed = Math.hypot(Velocity.x[crate], Velocity.y[crate]);
      expect(Math.abs(Rotation.angle[crate] - angle)).toBeLessThan(0.01);
      expect(Math.abs(speed / (G * Math.sin(angle)) - 1)).toBeLessThan(0.1);
    });

    it('a part added to a body that does not move holds, and no longer when it is gone', () => {
      const { world, floor, crate, Position } = crateOnFloor(isAwake);
      const part = spawn(world, {
        position: {},
        rotation: 0,
        collider: { shape: box(2, 1), friction: 0.5 },
        attachment: { body: floor, x: 3, y: 1 },
      });
      const ball = spawn(world, { position: { x: 3, y: 2 }, collider: { radius: 0.25, density: 1 } });
      run(world, 2);
      expect(Math.abs(Position.y[ball] - 1.25)).toBeLessThan(SLOP);
      despawn(world, part);
      run(world, 2);
      expect(Math.abs(Position.y[ball] - 0.25)).toBeLessThan(SLOP);
      expect(Math.abs(Position.y[crate] - 0.5)).toBeLessThan(SLOP);
    });
  });

  it.each([0.5, 0.8])('a ball follows the size of the disc below it, which becomes %s', (radius) => {
    const world = rigidWorld({ precision });
    const disc = spawn(world, { position: {}, rotation: 0, collider: { radius: 0.6 } });
    const ball = spawn(world, {
      position: { y: 0.8 },
      motionLocks: { x: true },
      collider: { radius: 0.2, density: 1 },
    });
    run(world, 2);
    world.components.Collider.radius[disc] = radius;
    run(world, 3);
    expect(Math.abs(world.components.Position.y[ball] - (radius + 0.2))).toBeLessThan(SLOP);
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
