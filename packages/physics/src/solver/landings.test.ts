// Whatever falls over, is thrown, or slides into a wall stays in front of the surface.
import { box, contactPoints, createJoint, type PhysicsWorld, revolute, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld, SLOP } from '../../../../test/support/rigid-world.ts';

/** Evenly spread numbers from 0 to 1: multiples of the golden ratio, and of its square root. */
const spread = (count: number) =>
  Array.from({ length: count }, (_, i) => [(i * 0.618034) % 1, (i * 0.786151) % 1] as const);

/** A floor of 200 m, whose top is at height 0. */
function floorWorld(precision: 'f32' | 'f64'): PhysicsWorld {
  const world = rigidWorld({ precision, capacity: 20 });
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(200, 1), friction: 0.6 } });
  return world;
}

/** How far the lowest corner of a box is below the floor at most in four seconds, m. */
function deepest(world: PhysicsWorld, body: number, width: number, height: number): number {
  const { Position, Rotation } = world.components;
  let depth = 0;
  for (let i = 0; i < 240; i++) {
    step(world, DT);
    const [c, s] = [Math.cos(Rotation.angle[body]), Math.sin(Rotation.angle[body])];
    depth = Math.max(depth, 0.5 * (Math.abs(width * s) + Math.abs(height * c)) - Position.y[body]);
  }
  return depth;
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it('a plank that falls over sinks in by less than the slop', () => {
    for (const [u, v] of spread(20)) {
      const world = floorWorld(precision);
      const height = 1 + 2 * u;
      const collider = { shape: box(0.1, height), density: 1, friction: 0.6 };
      const body = spawn(world, { position: { y: height / 2 + 0.01 }, rotation: 0.05 + 0.1 * v, collider });
      // Its end comes down at up to 9 m/s, 15 cm a step.
      expect(deepest(world, body, 0.1, height), `${height} m`).toBeLessThan(SLOP);
    }
  });

  it('a box that tips over onto its side sinks in by less than the slop', () => {
    for (let angle = 0.02; angle < 0.75; angle += 0.03) {
      const world = floorWorld(precision);
      const position = { y: 0.5 * (Math.cos(angle) + Math.sin(angle)) };
      const collider = { shape: box(1, 1), density: 1, friction: 0.6 };
      const body = spawn(world, { position, rotation: angle, collider });
      expect(deepest(world, body, 1, 1), `from ${angle} rad`).toBeLessThan(SLOP);
    }
  });

  it.each([
    ['box', 1, 1],
    ['plank', 2, 0.2],
  ])('a %s that is thrown and turns stops within the slop', (_, width, height) => {
    for (const [u, v] of spread(40)) {
      const world = floorWorld(precision);
      const body = spawn(world, {
        position: { y: 2 + 9 * u },
        rotation: 1.5 * v,
        velocity: { x: 10 * v, y: -5 },
        angularVelocity: 20 * (u - 0.5),
        collider: { shape: box(width, height), density: 1, friction: 0.6 },
      });
      // A step later the soft contact gives way as much.
      expect(deepest(world, body, width, height), `${u} ${v}`).toBeLessThan(2 * SLOP);
    }
  });

  it('a box that slides into a wall stops within the slop', () => {
    for (const [u, v] of spread(40)) {
      const world = floorWorld(precision);
      spawn(world, { position: { x: 6.5, y: 1 }, collider: { shape: box(1, 2), friction: 0 } });
      const collider = { shape: box(1, 1), density: 1, friction: 0 };
      const body = spawn(world, { position: { x: u, y: 0.5 }, velocity: { x: 1 + 19 * v }, collider });
      const { Position } = world.components;
      for (let i = 0; i < 360 && Position.x[body] < 5; i++) step(world, DT);
      for (let i = 0; i < 10; i++) {
        step(world, DT);
        expect(Position.x[body], `${1 + 19 * v} m/s`).toBeLessThan(5.5 + 2 * SLOP);
      }
    }
  });
});

it('a chain of planks that falls is torn apart by less than two ends move in a sub-step, and does not sink in', () => {
  const [count, width, length] = [6, 0.2, 1];
  for (const tilt of [0, 0.1, 0.5, 0.8, Math.PI / 2]) {
    const world = floorWorld('f32');
    const [c, s] = [Math.cos(tilt), Math.sin(tilt)];
    const at = (along: number) => ({ x: -s * along, y: 5 + c * along });
    const collider = { shape: box(width, length), density: 1, friction: 0.6 };
    const links = Array.from({ length: count }, (_, i) =>
      spawn(world, { position: at(i + 0.5), rotation: tilt, collider }),
    );
    for (let i = 1; i < count; i++) createJoint(world, revolute({ a: links[i - 1], b: links[i], anchor: at(i) }));
    const { AngularVelocity, Position, Rotation, Velocity } = world.components;
    /** The middle of an end of a link. */
    const endOf = (link: number, side: number) => ({
      x: Position.x[link] - 0.5 * side * length * Math.sin(Rotation.angle[link]),
      y: Position.y[link] + 0.5 * side * length * Math.cos(Rotation.angle[link]),
    });
    let [gap, depth, fastest] = [0, 0, 0];
    for (let i = 0; i < 300; i++) {
      for (const link of links) {
        const spin = Math.abs(AngularVelocity.z[link]) * 0.5 * length;
        fastest = Math.max(fastest, Math.hypot(Velocity.x[link], Velocity.y[link]) + spin);
      }
      step(world, DT);
      for (let k = 1; k < count; k++) {
        const [a, b] = [endOf(links[k - 1], 1), endOf(links[k], -1)];
        gap = Math.max(gap, Math.hypot(a.x - b.x, a.y - b.y));
      }
      for (const link of links) {
        const [cosine, sine] = [Math.cos(Rotation.angle[link]), Math.sin(Rotation.angle[link])];
        depth = Math.max(depth, 0.5 * (Math.abs(width * sine) + Math.abs(length * cosine)) - Position.y[link]);
      }
    }
    // Two ends that a contact has torn away from each other part for one of the four sub-steps.
    expect(gap, `${tilt} rad`).toBeLessThan((2 * fastest * DT) / 4);
    expect(depth, `${tilt} rad`).toBeLessThan(3 * SLOP);
  }
});

describe.each(['f32', 'f64'] as const)('in %s, what falls onto bodies that rest', (precision) => {
  it.each([
    ['a ball', { radius: 0.5 }, 1],
    ['a box', { shape: box(1, 1) }, 1],
    ['a ball', { radius: 0.3 }, 5],
  ])('%s stops at the surface of the top one', (_, shape, count) => {
    for (const [u, v] of spread(20)) {
      const world = floorWorld(precision);
      const crate = { shape: box(1, 1), density: 1, friction: 0.6 };
      for (let i = 0; i < count; i++) spawn(world, { position: { y: 0.5 + i }, collider: crate });
      const position = { x: 0.4 * (u - 0.5), y: count + 2 + 8 * v };
      const body = spawn(world, { position, collider: { ...shape, density: 1, friction: 0.6 } });
      const { Position } = world.components;
      let depth = 0;
      const points = contactPoints(world);
      for (let i = 0; i < 180 && Position.y[body] > 0.3; i++) {
        step(world, DT);
        contactPoints(world, points);
        for (let k = 0; k < points.count; k++) depth = Math.max(depth, -points.separation[k]);
      }
      // It comes at up to 13 m/s, 22 cm a step. The stack gives way as soft contacts do.
      expect(depth, `${v}`).toBeLessThan(2 * SLOP);
    }
  });

  it('a ball that flies past the corner of a crate is not held up by it', () => {
    for (const [u] of spread(20)) {
      const world = rigidWorld({ precision, capacity: 20, forces: [] });
      const crate = spawn(world, { position: { y: -0.5 }, collider: { shape: box(1, 1), density: 1 } });
      // Its path leads past the corner at (0.5, 0), a centimetre and a half outside of its radius.
      const [vx, vy] = [20, -20];
      const position = { x: 0.5 - 1 - u + (0.2 + 0.015) * Math.SQRT2, y: 1 + u };
      const ball = spawn(world, { position, velocity: { x: vx, y: vy }, collider: { radius: 0.2, density: 1 } });
      for (let i = 0; i < 20; i++) step(world, DT);
      expect(world.components.Velocity.x[ball]).toBeCloseTo(vx, 4);
      expect(world.components.Velocity.y[ball]).toBeCloseTo(vy, 4);
      expect(world.components.Velocity.x[crate]).toBeCloseTo(0, 4);
    }
  });
});
