/** Bodies, joints and queries of a rigid world that come, go and throw during a step; snapshots that are none. */
import {
  bodies,
  box,
  boxWalls,
  castShape,
  contactEvents,
  createJoint,
  createPhysicsWorld,
  defineForce,
  despawn,
  destroyWorld,
  distance,
  endedJoints,
  entityRef,
  isAlive,
  isBody,
  nearestPoint,
  type PhysicsWorld,
  rayCast,
  resolve,
  restore,
  revolute,
  rigidBodies,
  snapshot,
  softStep,
  spawn,
  stateHash,
  step,
  uniformGravity,
} from '@principia/physics';
import { addComponent, removeEntity, set } from 'bitecs';
import { describe, expect, it } from 'vitest';
import { assertRefused, DT, refusal, steps } from '../support/worlds.ts';

const SHAPE = box(1, 1);

/** A stack of four crates on the ground, the upper two joined. */
function stackWorld(options: Parameters<typeof createPhysicsWorld>[0] = {}) {
  const world = createPhysicsWorld({
    preset: rigidBodies,
    capacity: 100,
    forces: [uniformGravity()],
    walls: [boxWalls({ min: { y: 0 } })],
    ...options,
  });
  const crates = [0, 1, 2, 3].map((i) => crateAt(world, 0, 0.5 + i));
  const joint = createJoint(world, revolute({ a: crates[2], b: crates[3], anchor: { y: 3 } }));
  return { world, crates, joint };
}

const crateAt = (world: PhysicsWorld, x: number, y: number) =>
  spawn(world, { position: { x, y }, collider: { shape: SHAPE, density: 1, friction: 0.5 } });

/** Expects a new crate to fall and lie on the ground, beside everything else. */
function assertAlive(world: PhysicsWorld): void {
  const crate = crateAt(world, -40, 1);
  steps(world, 60);
  expect(world.components.Position.y[crate]).toBeCloseTo(0.5, 2);
}

/** The places in a step where user code runs. */
const PLACES: readonly (readonly [string, (act: () => void) => PhysicsWorld])[] = [
  ['a system', (act) => inPhase('input', act)],
  ['a system after the step', (act) => inPhase('events', act)],
  [
    'a force',
    (act) => {
      const { world } = stackWorld();
      world.forces.push(defineForce({ name: 'edits', accumulate: act }));
      return world;
    },
  ],
  [
    'shouldCollide',
    (act) =>
      stackWorld({
        integrator: softStep({
          shouldCollide() {
            act();
            return true;
          },
        }),
      }).world,
  ],
];

function inPhase(phase: 'input' | 'events', act: () => void): PhysicsWorld {
  const { world } = stackWorld();
  world.phases[phase].push(act);
  return world;
}

/** Runs an edit once, in the first step in which its place is reached. */
function editOnce(place: (act: () => void) => PhysicsWorld, edit: (world: PhysicsWorld) => void): PhysicsWorld {
  let edited = false;
  const world: PhysicsWorld = place(() => {
    if (edited) return;
    edited = true;
    edit(world);
  });
  for (let i = 0; i < 5 && !edited; i++) step(world, DT);
  expect(edited).toBe(true);
  return world;
}

const CRATE = 4;

describe('rigid bodies that go', () => {
  it('51, 52 a rigid body removed twice gives E_STALE, and its reference reads no other body', () => {
    const { world, crates } = stackWorld();
    const ref = entityRef(world, crates[1]);
    despawn(world, crates[1]);
    const hash = stateHash(world);
    expect(refusal(() => despawn(world, crates[1])).code).toBe('E_STALE');
    expect(stateHash(world)).toBe(hash);
    crateAt(world, 9, 3);
    expect(isAlive(world, ref)).toBe(false);
    expect(refusal(() => resolve(world, ref)).code).toBe('E_STALE');
    assertAlive(world);
  });

  it('54 the joints of a removed rigid body go with it, and are listed', () => {
    const { world, crates, joint } = stackWorld();
    step(world, DT);
    despawn(world, crates[3]);
    step(world, DT);
    expect([...endedJoints(world).removed]).toEqual([joint]);
    expect(refusal(() => despawn(world, joint)).code).toBe('E_STALE');
    assertAlive(world);
  });

  it('55, 57 a joint is removed and made in the events of its contact, and a velocity is set', () => {
    const { world, crates, joint } = stackWorld();
    let joined = 0;
    world.phases.events.push(() => {
      const { begin } = contactEvents(world);
      if (begin.count === 0 || joined !== 0) return;
      despawn(world, joint);
      joined = createJoint(world, distance({ a: crates[0], b: crates[1] }));
      addComponent(world, crates[3], set(world.components.Velocity, { y: 3 }));
    });
    steps(world, 2);
    expect(joined).toBeGreaterThan(0);
    expect(world.components.Velocity.y[crates[3]]).toBeGreaterThan(2);
    steps(world, 60);
    assertAlive(world);
  });

  it('63 a rigid body removed through bitECS leaves no contact and no joint', () => {
    const { world, crates } = stackWorld();
    steps(world, 5);
    removeEntity(world, crates[2]);
    steps(world, 120);
    expect(isBody(world, crates[2])).toBe(false);
    // What stood on it has come down.
    expect(world.components.Position.y[crates[3]]).toBeLessThan(2.6);
    assertAlive(world);
  });
});

describe.each(PLACES)('edits of rigid bodies in %s', (_, place) => {
  it('55 a rigid body removed during a step is gone when the step ends', () => {
    const world = editOnce(place, (at) => despawn(at, CRATE));
    expect(isBody(world, CRATE)).toBe(false);
    assertAlive(world);
  });

  it('55 all rigid bodies removed at once are gone when the step ends', () => {
    const world = editOnce(place, (at) => {
      for (const eid of [...bodies(at).ids.subarray(0, bodies(at).count)]) despawn(at, eid);
    });
    expect(bodies(world).count).toBe(0);
    assertAlive(world);
  });

  it('56 a rigid body created during a step appears in the next step, inside another', () => {
    let made = 0;
    const world = editOnce(place, (at) => {
      made = crateAt(at, 0.3, 1.4);
    });
    steps(world, 120);
    expect(isBody(world, made)).toBe(true);
    expect(Number.isFinite(world.components.Position.y[made])).toBe(true);
    assertAlive(world);
  });

  it('57 a rigid body teleported during a step into another leaves it', () => {
    const world = editOnce(place, (at) => {
      addComponent(at, CRATE, set(at.components.Position, { x: 0.1, y: 0.6 }));
    });
    // Its hinge, two metres away on the other side of a crate, may throw all of them up before they lie.
    steps(world, 480);
    expect(Math.hypot(world.components.Velocity.x[CRATE], world.components.Velocity.y[CRATE])).toBeLessThan(1);
    assertAlive(world);
  });

  it('58 a step of a rigid world inside a step is refused', () => {
    let code = '';
    const world = editOnce(place, (at) => {
      code = refusal(() => step(at, DT)).code;
    });
    expect(code).toBe('E_REENTRANT');
    assertAlive(world);
  });

  it('59 what user code throws among rigid bodies comes out of the step, and the world goes on', () => {
    let world: PhysicsWorld | undefined;
    const run = () =>
      editOnce(place, (at) => {
        world = at;
        throw new Error('oops');
      });
    expect(run).toThrow(AggregateError);
    assertAlive(world as PhysicsWorld);
  });

  it('60 a rigid world destroyed during a step is destroyed when the step ends', () => {
    const world = editOnce(place, (at) => destroyWorld(at));
    expect(refusal(() => step(world, DT)).code).toBe('E_DESTROYED');
  });
});

describe('queries of rigid worlds', () => {
  it('71, 72, 73 rays without length, to NaN and from inside a rigid body', () => {
    const { world } = stackWorld();
    expect(refusal(() => rayCast(world, { x: 5 }, { x: Number.NaN })).code).toBe('E_NONFINITE');
    expect(refusal(() => rayCast(world, { x: Infinity }, { x: 5 })).code).toBe('E_NONFINITE');
    const from = { x: 3, y: 0.5 };
    let hit: unknown;
    try {
      hit = rayCast(world, from, from);
    } catch (error) {
      expect(error).toMatchObject({ name: 'PhysicsError' });
    }
    expect(hit).toBeUndefined();
    expect(rayCast(world, { y: 0.5 }, { x: 5, y: 0.5 })).toBeUndefined();
    expect(rayCast(world, from, { x: -5, y: 0.5 })?.body).toBe(1);
  });

  it('74, 75 queries see rigid bodies before the first step, and during one', () => {
    const { world, crates } = stackWorld();
    const seen = () => [
      nearestPoint(world, { x: 3, y: 0.5 }, { walls: false })?.body,
      castShape(world, box(0.1, 0.1), { x: 3, y: 0.5 }, { x: -5 })?.body,
    ];
    expect(seen()).toEqual([crates[0], crates[0]]);
    let during: unknown;
    world.phases.input.push(() => {
      during = seen();
    });
    step(world, DT);
    expect(during).toEqual([crates[0], crates[0]]);
  });
});

describe('snapshots that are none', () => {
  it('76, 77, 81 a truncated, copied, forged or foreign snapshot is refused, and the world stays as it is', () => {
    const { world } = stackWorld();
    const saved = snapshot(world);
    steps(world, 3);
    const foreign = snapshot(stackWorld({ precision: 'f32' }).world);
    const forged = [
      { ...saved },
      structuredClone({ time: 0, tick: 0, bytes: 2 ** 32 - 1 }),
      Object.create(saved) as object,
      JSON.parse('{"__proto__": {"isWhole": true}, "tick": 1, "bytes": 4294967295}') as object,
      new Uint8Array(saved.bytes).subarray(0, saved.bytes >> 1),
      null,
      undefined,
      foreign,
    ];
    for (const bad of forged) assertRefused(world, () => restore(world, bad as never), { code: 'E_TYPE' });
    restore(world, saved);
    expect(world.tick).toBe(0);
    assertAlive(world);
  });
});
