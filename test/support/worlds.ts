/**
 * Short constructors of test worlds, and the invariants after every fault: an unchanged witness and a working world.
 */
import {
  boxWalls,
  COMPONENT_NAMES,
  createPhysicsWorld,
  PhysicsError,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  spawn,
  stateHash,
  step,
  uniformGravity,
} from '@principia/physics';
import { getAllEntities, hasComponent } from 'bitecs';
import { expect } from 'vitest';

export const DT = 1 / 60;

/** The kinds of world for faults: both precisions, 2D and 3D. */
export const KINDS = [
  { dimensions: 2, precision: 'f64' },
  { dimensions: 3, precision: 'f32' },
] as const;

/** Gravity and a floor at y = 0. */
export function groundWorld(options: PhysicsWorldOptions = {}): PhysicsWorld {
  return createPhysicsWorld({
    capacity: 1000,
    forces: [uniformGravity()],
    walls: [boxWalls({ min: { y: 0 } })],
    ...options,
  });
}

/** A world without forces. */
export function emptySpace(options: PhysicsWorldOptions = {}): PhysicsWorld {
  return createPhysicsWorld({ capacity: 1000, ...options });
}

/** A ball of 1 kg and 0.1 m at (x, y), at rest. */
export function ball(world: PhysicsWorld, x: number, y: number, velocity: { x?: number; y?: number } = {}): number {
  return spawn(world, { position: { x, y }, velocity, mass: 1, collider: { radius: 0.1, restitution: 0.5 } });
}

export function steps(world: PhysicsWorld, count: number, dt = DT): void {
  for (let i = 0; i < count; i++) step(world, dt);
}

/** Returns the values of all columns of a body as text. Bodies with equal states have equal texts. */
export function bodyState(world: PhysicsWorld, eid: number): string {
  const parts: string[] = [];
  for (const name of COMPONENT_NAMES) {
    for (const [field, column] of Object.entries(world.components[name])) {
      // `+ 0` converts -0 to 0; otherwise equal texts mean equal bits.
      if (column[eid] !== 0) parts.push(`${name}.${field}=${column[eid] + 0}`);
    }
  }
  return parts.join(' ');
}

/** Returns all state that a refused call must not change. */
export function worldState(world: PhysicsWorld): unknown {
  const entities = getAllEntities(world).map((eid) => [
    eid,
    COMPONENT_NAMES.filter((name) => hasComponent(world, eid, world.components[name])),
  ]);
  return {
    hash: stateHash(world),
    entities: entities.sort(([a], [b]) => (a as number) - (b as number)),
    counts: { ...world.internal.counts },
    lastId: world.lastId,
    time: world.time,
    tick: world.tick,
    state: world.state,
    faults: world.faults.faults.length + world.faults.droppedCount,
    waiting: world.internal.edits.deferred.length,
  };
}

/** Returns the PhysicsError that `act` throws. */
export function refusal(act: () => unknown): PhysicsError {
  let thrown: unknown;
  try {
    act();
  } catch (error) {
    thrown = error;
  }
  expect(thrown, 'nothing was thrown, or no PhysicsError').toBeInstanceOf(PhysicsError);
  return thrown as PhysicsError;
}

/** Expects a PhysicsError with these details, and an unchanged world. */
export function assertRefused(
  world: PhysicsWorld,
  act: () => unknown,
  expected: { code: string; field?: string; entity?: number; value?: unknown; hint?: RegExp },
): void {
  const before = worldState(world);
  const { hint: wanted, ...details } = expected;
  const { code, field, entity, value, hint } = refusal(act);
  expect({ code, field, entity, value }).toMatchObject(details);
  if (wanted !== undefined) expect(hint).toMatch(wanted);
  expect(worldState(world)).toEqual(before);
}

/** Expects a new body to fall and land, in a world with gravity and a floor at y = 0. */
export function assertWorldAlive(world: PhysicsWorld): void {
  const eid = spawn(world, { position: { x: -300, y: 0.5 }, velocity: {}, mass: 1, collider: { radius: 0.1 } });
  const { Position, Velocity } = world.components;
  step(world, DT);
  expect(Position.y[eid]).toBeLessThan(0.5);
  // From 0.4 m above the floor it falls for sqrt(0.8 / 9.8) = 0.29 s, and lies still after the bounce that is none.
  steps(world, 30);
  // It rests on the floor exactly, up to the rounding of 0.1 to f32 (relative 6e-8).
  expect(Math.abs(Position.y[eid] - 0.1)).toBeLessThan(1e-8);
  expect(Math.abs(Velocity.y[eid])).toBeLessThan(1e-6);
}

/** A world with a body that something happens to, one beside it and one far away. */
export interface Stage {
  readonly world: PhysicsWorld;
  readonly victim: number;
}

/**
 * Lets `act` happen to a body, runs on, and expects the neighbour and the far witness to be bit for bit as in a run
 * without that body, and the world to be alive.
 * @param otherwise what happens to the world without it: a force that is no law makes steps of other pieces, which
 *   round differently, so both worlds need one
 */
export function withWitness(
  act: (stage: Stage) => void,
  options: PhysicsWorldOptions = {},
  after = 20,
  otherwise: (world: PhysicsWorld) => void = () => {},
): Stage {
  const run = (withVictim: boolean) => {
    const world = groundWorld(options);
    const neighbour = ball(world, 1, 2, { x: 0.5 });
    const witness = ball(world, 500, 3, { x: -1, y: 2 });
    const victim = withVictim ? ball(world, 0, 2) : 0;
    if (withVictim) act({ world, victim });
    else otherwise(world);
    steps(world, after - world.tick);
    return { world, victim, neighbour: bodyState(world, neighbour), witness: bodyState(world, witness) };
  };
  const control = run(false);
  const subject = run(true);
  expect(subject.witness).toBe(control.witness);
  expect(subject.neighbour).toBe(control.neighbour);
  assertWorldAlive(subject.world);
  return subject;
}
