/** Forces whose memory changes what follows: the tree of mutual forces adapts to the error measured last, and goes on so elsewhere. */
import {
  clothWind,
  createPhysicsWorld,
  createRandom,
  decodeSnapshot,
  despawn,
  enclosedGas,
  encodeSnapshot,
  type Force,
  mutualCoulomb,
  mutualGravity,
  type PhysicsWorld,
  replaceForce,
  restore,
  restrictForce,
  snapshot,
  spawn,
  stateHash,
  step,
} from '@principia/physics';
import { expect, it } from 'vitest';
import { KINDS } from '../support/worlds.ts';

const gravity = (options: object = {}) => mutualGravity({ G: 1, softening: 0.05, method: 'tree', ...options });
type Kind = { readonly dimensions: 2 | 3; readonly precision: 'f32' | 'f64' };
const DISC = { centre: {}, radius: 1.5 };

function makeCloud(kind: Kind, forces: readonly Force[]): PhysicsWorld {
  return createPhysicsWorld({ ...kind, capacity: 1000, forces });
}

function fill(world: PhysicsWorld, count: number): void {
  const random = createRandom(3);
  for (let i = 0; i < count; i++) {
    const radius = random.uniform(1, 2);
    const { x, y, z } = world.dimensions === 3 ? random.onSphere(radius) : random.onCircle(radius);
    const position = world.dimensions === 3 ? { x, y, z } : { x, y };
    spawn(world, { position, velocity: {}, mass: 0.001, charge: i % 3 === 0 ? 1e-8 : -1e-8 });
  }
}

function hashes(world: PhysicsWorld, steps: number): string[] {
  return Array.from({ length: steps }, () => {
    step(world, 0.01);
    return stateHash(world);
  });
}

/** The hashes of 40 steps of a world and of another that took its state after 5 steps. */
function goOn(kind: Kind, make: () => Force[], change = (_: PhysicsWorld) => {}): [string[], string[]] {
  const [played, loaded] = [makeCloud(kind, make()), makeCloud(kind, make())];
  fill(played, 300);
  hashes(played, 3);
  change(played);
  hashes(played, 2);
  restore(loaded, decodeSnapshot(loaded, encodeSnapshot(snapshot(played))));
  return [hashes(loaded, 40), hashes(played, 40)];
}

it.each(KINDS)('gravity by the tree goes on in another world, $dimensions D $precision', (kind) => {
  const [loaded, played] = goOn(kind, () => [gravity()]);
  expect(loaded).toEqual(played);
});

it.each([
  ['charges', () => [mutualCoulomb({ softening: 0.05, method: 'tree' })]],
  ['gravity in a region', () => [restrictForce(gravity(), { region: DISC })]],
  ['two forces', () => [gravity(), gravity({ G: 2, relativeError: 0.02 })]],
] as const)('%s too', (_, make) => {
  const [loaded, played] = goOn({ dimensions: 3, precision: 'f64' }, () => [...make()]);
  expect(loaded).toEqual(played);
});

it('the place of a force among the forces counts, not when it came', () => {
  const make = () => [gravity({ relativeError: 0.02 }), gravity({ relativeError: 0.02 })];
  const [loaded, played] = goOn({ dimensions: 2, precision: 'f64' }, make, (world) => {
    replaceForce(world, gravity({ relativeError: 0.02 }), world.forces[0]);
  });
  expect(loaded).toEqual(played);
});

it('begins anew where the force has other options, in the memory that is free then', () => {
  const [played, loaded] = [{ method: 'tree' }, { method: 'direct' }].map((options) =>
    makeCloud({ dimensions: 3, precision: 'f64' }, [gravity(options)]),
  );
  fill(played, 100);
  hashes(played, 3);
  restore(loaded, decodeSnapshot(loaded, encodeSnapshot(snapshot(played))));
  const fresh = makeCloud({ dimensions: 3, precision: 'f64' }, [gravity({ method: 'direct' })]);
  fill(fresh, 100);
  for (const name of ['Position', 'Velocity'] as const) {
    for (const axis of ['x', 'y', 'z'] as const) fresh.components[name][axis].set(played.components[name][axis]);
  }
  expect(hashes(loaded, 3)).toEqual(hashes(fresh, 3));
});

it.each([
  ['wind on a cloth', (faces: Uint32Array) => clothWind({ triangles: faces, velocity: { z: 3 } })],
  ['gas in a skin', (faces: Uint32Array) => enclosedGas({ faces, corners: 3, amount: 1, ambient: 0.5 })],
] as const)('%s knows its nodes from bodies that got their ids later', (_, make) => {
  const [played, loaded] = [0, 1].map(() => {
    const world = createPhysicsWorld({ dimensions: 3, capacity: 100 });
    const corners = [{}, { x: 1 }, { y: 1 }, { z: 1 }].map((position) =>
      spawn(world, { position, velocity: {}, mass: 1 }),
    );
    const faces = Uint32Array.from([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3], (corner) => corners[corner]);
    world.forces.push(make(faces));
    return { world, node: corners[3] };
  });
  hashes(played.world, 3);
  despawn(played.world, played.node);
  expect(spawn(played.world, { position: { x: 4, y: 4, z: 4 }, velocity: {}, mass: 1 })).toBe(played.node);
  hashes(played.world, 2);
  restore(loaded.world, decodeSnapshot(loaded.world, encodeSnapshot(snapshot(played.world))));
  expect(hashes(loaded.world, 10)).toEqual(hashes(played.world, 10));
  expect(loaded.world.components.Velocity.z[played.node]).toBe(0);
  expect(loaded.world.components.Velocity.z[played.node - 1]).not.toBe(0);
});
