// Characters on ground that goes down under them: lifts, and bridges of planks.
import {
  angularDrag,
  box,
  createJoint,
  immersedDrag,
  type PhysicsWorld,
  polygonBuoyancy,
  revolute,
  spawn,
  uniformGravity,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { addCharacter, MARGIN, right, STANDS, walk } from '../../../../test/support/character-world.ts';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';

/** Planks of 1 m by 0.2 m, hinged to each other, that hang in a V between two banks with their tops at y = 0.1. */
function addBridge(world: PhysicsWorld, density: number): void {
  const slope = 0.24;
  const [c, s] = [Math.cos(slope), Math.sin(slope)];
  const jointAt = (i: number) => ({ x: i * c, y: -s * Math.min(i, 10 - i) });
  let a: number | undefined;
  for (let i = 0; i < 10; i++) {
    const [anchor, end] = [jointAt(i), jointAt(i + 1)];
    const b = spawn(world, {
      position: { x: (anchor.x + end.x) / 2, y: (anchor.y + end.y) / 2 },
      rotation: i < 5 ? -slope : slope,
      collider: { shape: box(1, 0.2), density, friction: 0.8 },
    });
    createJoint(world, revolute(a === undefined ? { b, anchor } : { a, b, anchor }));
    if (i === 9) createJoint(world, revolute({ b, anchor: end }));
    a = b;
  }
  for (const x of [-3, 10 * c + 3]) spawn(world, { position: { x, y: -0.4 }, collider: { shape: box(5.8, 1) } });
}

/** The most steps in a row of which none was on ground. */
function longestFlight(grounded: readonly boolean[]): number {
  let [longest, flight] = [0, 0];
  for (const stands of grounded) {
    flight = stands ? 0 : flight + 1;
    longest = Math.max(longest, flight);
  }
  return longest;
}

describe.each(['f32', 'f64'] as const)('%s', (precision) => {
  it.each([-0.5, -1, -3, -6])('stays on a lift on which it has landed, at %d m/s', (speed) => {
    const world = rigidWorld({ precision });
    const lift = spawn(world, { position: {}, velocity: { y: speed }, collider: { shape: box(3, 0.2) } });
    const id = addCharacter(world, 0, 0.1 + STANDS + 0.5);
    const { y, grounded } = walk(world, id, 240);
    const landed = grounded.indexOf(true);
    expect(landed).toBeLessThan(120);
    expect(longestFlight(grounded.slice(landed))).toBe(0);
    expect(y - world.components.Position.y[lift] - 0.1).toBeCloseTo(STANDS, 3);
  });

  it('jumps on a lift that goes down, and is on it again', () => {
    const world = rigidWorld({ precision });
    spawn(world, { position: {}, velocity: { y: -2 }, collider: { shape: box(3, 0.2) } });
    const id = addCharacter(world, 0, 0.1 + STANDS);
    walk(world, id, 10);
    const { grounded } = walk(world, id, 120, (i) => (i === 0 ? { jump: 3 } : {}));
    // 2 v/g = 0.61 s, seen from the lift.
    expect(longestFlight(grounded) * DT).toBeCloseTo((2 * 3) / 9.80665, 1);
    expect(longestFlight(grounded.slice(60))).toBe(0);
  });

  it.each([
    [1000, 3, 0],
    [1000, 1, 0],
    [100, 1, 0.1],
    [100, 3, 0.1],
    [20, 3, 0.1],
  ])('walks over a bridge of planks of %d kg/m² at %d m/s', (density, speed, flight) => {
    const world = rigidWorld({ precision });
    addBridge(world, density);
    const id = addCharacter(world, -1, 0.1 + STANDS);
    const { x, heights, grounded } = walk(world, id, Math.round(12 / speed / DT), right(speed));
    expect(x).toBeGreaterThan(10);
    // It is never thrown up, and leaves planks for a tenth of a second at most, where they are far lighter than it is.
    expect(Math.max(...heights)).toBeLessThan(0.1 + STANDS + MARGIN);
    expect(longestFlight(grounded) * DT).toBeLessThan(flight + DT / 2);
  });

  it('stands still on a boat in waves', () => {
    const sea = { density: 1000, level: 0, waves: { amplitude: 0.4, length: 16 } };
    const shape = box(12, 1);
    const floats = [polygonBuoyancy(sea, { shape: 2, vertices: shape }), immersedDrag(sea), angularDrag()];
    const world = rigidWorld({ precision, forces: [uniformGravity(), ...floats] });
    const boat = spawn(world, {
      position: {},
      collider: { shape, density: 400, friction: 0.7 },
      hull: { volume: 12, shape: 2 },
      linearDrag: 2000,
      angularDrag: 50_000,
    });
    const id = addCharacter(world, 0.5, 0.5 + STANDS);
    const { Position, Rotation } = world.components;
    const along = () => {
      const angle = Rotation.angle[boat];
      return (
        (Position.x[id] - Position.x[boat]) * Math.cos(angle) + (Position.y[id] - Position.y[boat]) * Math.sin(angle)
      );
    };
    for (let minute = 0; minute < 2; minute++) {
      const start = along();
      walk(world, id, 3600);
      // Its centre is some 0.9 m above the deck, which is tilted by up to 0.1 rad.
      expect(Math.abs(along() - start)).toBeLessThan(0.18);
    }
  });
});
