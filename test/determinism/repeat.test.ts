import {
  attractors,
  bodies,
  boxWalls,
  createPhysicsWorld,
  despawn,
  linearDrag,
  type PhysicsWorld,
  type Precision,
  quadraticDrag,
  spawn,
  stateHash,
  step,
  uniformGravity,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { chaoticWorld, hashAfter } from '../support/chaos.ts';
import { bodyState, DT, KINDS, steps } from '../support/worlds.ts';

describe.each(KINDS)('the same input, $dimensions D $precision', ({ dimensions, precision }) => {
  const make = (seed?: number) => chaoticWorld(dimensions, precision, seed);

  it('gives the same hash at every step', () => {
    const [a, b] = [make(), make()];
    for (let i = 0; i < 200; i++) expect(hashAfter(a, 1)).toBe(hashAfter(b, 1));
  });

  it('shows a difference in the last bit of one coordinate at once', () => {
    const [a, b] = [make(), make()];
    b.components.Position.x[10] *= 1 + (precision === 'f32' ? 2 ** -23 : 2 ** -52);
    expect(stateHash(a)).not.toBe(stateHash(b));
    expect(hashAfter(a, 50)).not.toBe(hashAfter(b, 50));
  });

  it('two worlds stepped in turns equal each run alone', () => {
    const alone = [1, 2].map((seed) => hashAfter(make(seed), 300));
    const worlds = [make(1), make(2)];
    for (let i = 0; i < 300; i++) for (const world of worlds) step(world, DT);
    expect(worlds.map(stateHash)).toEqual(alone);
    expect(alone[0]).not.toBe(alone[1]);
  });

  it('is not changed by being looked at between steps', () => {
    const [read, left] = [make(), make()];
    for (let i = 0; i < 100; i++) {
      step(read, DT);
      step(left, DT);
      stateHash(read);
      bodies(read);
    }
    expect(stateHash(read)).toBe(stateHash(left));
  });
});

describe('the order in which unrelated bodies are made', () => {
  const COUNT = 300;
  /** Bodies pass through each other here: those that touch are not unrelated. */
  const emptyBox = (dimensions: 2 | 3, precision: Precision) =>
    createPhysicsWorld({
      dimensions,
      precision,
      capacity: 1000,
      forces: [uniformGravity({ y: -3 }), linearDrag({ x: 0.3 }), quadraticDrag(), attractors()],
      walls: [boxWalls({ min: { x: 0, y: 0, z: 0 }, max: { x: 20, y: 20, z: 20 } })],
    });

  const inOrder = Array.from({ length: COUNT }, (_, i) => i);

  /** Bodies that do not meet, made in the given order; returns their ids by number. */
  function scattered(world: PhysicsWorld, order: readonly number[]): number[] {
    spawn(world, { position: { x: 10, y: 10 }, attractor: { mu: 40, softening: 0.3 } });
    const ids: number[] = [];
    for (const i of order) {
      const p = 0.1 + (19.8 * ((i * 7919) % COUNT)) / COUNT;
      ids[i] = spawn(world, {
        position: { x: p, y: 19.5 - p / 3 },
        velocity: { x: Math.sqrt(i), y: -i / 50 },
        mass: 1 + (i % 3),
        collider: { radius: 0.05, restitution: 0.7 },
        quadraticDrag: 0.001 * i,
      });
    }
    return ids;
  }

  it.each(KINDS)('changes the trajectory of none of them, $dimensions D $precision', ({ dimensions, precision }) => {
    const shuffled = inOrder.map((i) => (i * 187) % COUNT).filter((i, at, all) => all.indexOf(i) === at);
    const order = [...shuffled, ...inOrder.filter((i) => !shuffled.includes(i))].reverse();
    const states = [inOrder, order].map((each) => {
      const world = emptyBox(dimensions, precision);
      const ids = scattered(world, each);
      steps(world, 200);
      return inOrder.map((i) => bodyState(world, ids[i]));
    });
    expect(states[1]).toEqual(states[0]);
  });

  it('nor do bodies that come and go elsewhere', () => {
    const states = [false, true].map((churn) => {
      const world = emptyBox(2, 'f64');
      const ids = scattered(world, inOrder);
      for (let i = 0; i < 200; i++) {
        if (churn && i % 3 === 0) for (let k = 0; k < 5; k++) spawn(world, { position: { x: i, y: k }, velocity: {} });
        if (churn && i % 7 === 3) despawn(world, bodies(world).ids[bodies(world).count - 1]);
        step(world, DT);
      }
      return inOrder.map((i) => bodyState(world, ids[i]));
    });
    expect(states[1]).toEqual(states[0]);
  });
});
