/** Bodies in contact: faults do not spread, crowds have bounded cost, and overlaps separate gently. */
import {
  clearFaults,
  contactCapacity,
  contacts,
  createPhysicsWorld,
  despawn,
  isBody,
  momentum,
  on,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  particleContacts,
  spawn,
  spawnMany,
  step,
} from '@principia/physics';
import { addComponent, set } from 'bitecs';
import { describe, expect, it } from 'vitest';
import { assertWorldAlive, ball, bodyState, DT, groundWorld, KINDS, steps } from '../support/worlds.ts';

const touching = (options: PhysicsWorldOptions = {}) => groundWorld({ preset: particleContacts, ...options });
const space = (options: PhysicsWorldOptions = {}) =>
  createPhysicsWorld({ preset: particleContacts, capacity: 100, ...options });

function allFinite({ components: { Position, Velocity, AngularVelocity }, lastId }: PhysicsWorld): boolean {
  return [Position, Velocity, AngularVelocity].every((columns) =>
    [columns.x, columns.y, columns.z].every((column) => column.subarray(0, lastId + 1).every(Number.isFinite)),
  );
}

/** Returns the largest speed of the bodies with these ids. */
function topSpeed({ components: { Velocity } }: PhysicsWorld, ids: ArrayLike<number>): number {
  return Math.max(...Array.from(ids, (eid) => Math.hypot(Velocity.x[eid], Velocity.y[eid], Velocity.z[eid])));
}

describe.each(KINDS)('contacts, $dimensions D $precision', (kind) => {
  it.each(['Position.x', 'Velocity.y', 'AngularVelocity.z', 'Mass.value', 'Inertia.value'] as const)(
    '6 NaN in %s of a body does not spread to bodies in contact',
    (path) => {
      const world = touching(kind);
      const row = Array.from({ length: 5 }, (_, i) =>
        spawn(world, {
          position: { x: i * 0.19, y: 0.1 },
          velocity: { x: i === 0 ? 1 : 0 },
          mass: 1,
          inertia: 0.005,
          angularVelocity: {},
          collider: { radius: 0.1, restitution: 0.5, friction: 0.5 },
        }),
      );
      const witness = ball(world, 50, 3);
      steps(world, 3);
      const [name, field] = path.split('.');
      (world.components as unknown as Record<string, Record<string, Float64Array>>)[name][field][row[2]] = NaN;
      steps(world, 30);
      expect(allFinite(world)).toBe(true);
      // The restored body may push this one, but must not quarantine it.
      expect(row.filter((eid) => world.components.Quarantined.step[eid] > 0 && eid !== row[2])).toEqual([]);
      const alone = touching(kind);
      const same = ball(alone, 50, 3);
      steps(alone, 33);
      expect(bodyState(world, witness)).toBe(bodyState(alone, same));
      assertWorldAlive(world);
    },
  );

  it.each(['radius', 'restitution', 'friction'] as const)(
    '29 NaN in Collider.%s of a body does not spread to bodies in contact',
    (field) => {
      const world = touching(kind);
      const row = Array.from({ length: 5 }, (_, i) =>
        spawn(world, {
          position: { x: i * 0.19, y: 0.1 },
          velocity: { x: i === 0 ? 3 : 0 },
          mass: 1,
          inertia: 0.005,
          angularVelocity: {},
          collider: { radius: 0.1, restitution: 0.5, friction: 0.5 },
        }),
      );
      world.components.Collider[field][row[2]] = NaN;
      steps(world, 30);
      expect(allFinite(world)).toBe(true);
      expect(world.faults.faults).toMatchObject([
        { code: 'E_NONFINITE', entity: row[2], field: `Collider.${field}`, value: NaN },
      ]);
      expect(world.components.Collider[field][row[2]]).toBe(0);
      clearFaults(world.faults);
      assertWorldAlive(world);
    },
  );

  it('13 a body teleported into another separates from it at bounded speed', () => {
    const world = space(kind);
    const still = spawn(world, { position: {}, velocity: {}, mass: 1, collider: { radius: 0.5 } });
    const moved = spawn(world, { position: { x: 20 }, velocity: {}, mass: 1, collider: { radius: 0.5 } });
    steps(world, 5);
    addComponent(world, moved, set(world.components.Position, { x: 0.01 }));
    let fastest = 0;
    for (let i = 0; i < 120; i++) {
      const before = world.components.Position.x[moved];
      step(world, DT);
      fastest = Math.max(fastest, Math.abs(world.components.Position.x[moved] - before) / DT);
    }
    const { x, y } = world.components.Position;
    expect(Math.hypot(x[moved] - x[still], y[moved] - y[still])).toBeGreaterThan(0.95);
    expect(fastest).toBeLessThan(3);
    expect(topSpeed(world, [still, moved])).toBeLessThan(3);
  });

  it('67 thirty thousand coincident particles: pair tests and contacts per step are bounded, and dropped ones are counted', () => {
    const world = space({ ...kind, capacity: 30_000 });
    spawnMany(world, 30_000, { position: { x: 1, y: 1 }, velocity: {}, mass: 1, collider: 0.1 });
    step(world, DT);
    const found = contacts(world);
    expect(found.count).toBeGreaterThan(0);
    expect(found.count).toBeLessThanOrEqual(contactCapacity(world));
    expect(found.droppedCount).toBeGreaterThan(0);
    step(world, DT);
    expect(allFinite(world)).toBe(true);
    expect(world.faults.faults).toEqual([]);
  });

  it('69 contacts beyond capacity are counted, not dropped silently; a larger arena holds all', () => {
    // All of 129 coincident bodies touch each other: the maximum number of neighbours is 128.
    const pairs = (129 * 128) / 2;
    const crowd = (arenaBytes: number) => {
      const world = space({ ...kind, capacity: 129, arenaBytes });
      const ids = spawnMany(world, 129, { position: {}, velocity: {}, mass: 1, collider: 0.1 });
      step(world, DT);
      return { world, ids, found: contacts(world) };
    };
    const { world, ids, found } = crowd(2 ** 19);
    expect(contactCapacity(world)).toBeLessThan(pairs);
    expect(found.count).toBe(contactCapacity(world));
    expect(found.count + found.droppedCount).toBe(pairs);
    const roomy = crowd(2 ** 23).found;
    expect([roomy.count, roomy.droppedCount]).toEqual([pairs, 0]);
    // Dropped contacts only delay the separation of the others, until all fit.
    steps(world, 600);
    expect(found.droppedCount).toBe(0);
    expect(allFinite(world)).toBe(true);
    expect(world.faults.faults).toEqual([]);
    expect(topSpeed(world, ids)).toBeLessThan(3);
  });

  it('88 a hundred coincident bodies separate below 3 m/s', () => {
    const world = space({ ...kind, capacity: 100 });
    const ids = spawnMany(world, 100, { position: {}, velocity: {}, mass: 1, collider: 0.1 });
    const { x, y, z } = world.components.Position;
    let fastest = 0;
    for (let i = 0; i < 300; i++) {
      const before = Array.from(ids, (eid) => [x[eid], y[eid], z[eid]]);
      step(world, DT);
      ids.forEach((eid, k) => {
        const [px, py, pz] = before[k];
        fastest = Math.max(fastest, Math.hypot(x[eid] - px, y[eid] - py, z[eid] - pz) / DT);
      });
    }
    expect(allFinite(world)).toBe(true);
    expect(topSpeed(world, ids)).toBeLessThan(3);
    expect(fastest).toBeLessThan(3);
  });

  it.each([
    [1e15, 1e-9],
    [-1e15, 1e-9],
    [1e15, 1e12],
    [1, 1e12],
  ])('11 contacts at x = %d with radius %d do not stop the world', (x, radius) => {
    const world = space(kind);
    for (let i = 0; i < 3; i++)
      spawn(world, { position: { x, y: i * radius }, velocity: {}, mass: 1, collider: radius });
    spawn(world, { position: { x: -x }, velocity: { x: 1 }, mass: 1, collider: 1 });
    steps(world, 5);
    expect(allFinite(world)).toBe(true);
  });

  it('30 restitution above 1 between bodies stays bounded', () => {
    const world = space({ ...kind, capacity: 40 });
    for (let i = 0; i < 40; i++) {
      spawn(world, {
        position: { x: (i % 7) * 0.3, y: Math.floor(i / 7) * 0.3 },
        velocity: { x: (i % 3) - 1, y: (i % 5) - 2 },
        mass: 1,
        collider: { radius: 0.14, restitution: 10 },
      });
    }
    steps(world, 600);
    expect(allFinite(world)).toBe(true);
  });

  it('31 a body a million times heavier on a light one: finite, with a final overlap of at most 10 %', () => {
    const world = touching(kind);
    const light = spawn(world, { position: { y: 0.1 }, velocity: {}, mass: 1e-3, collider: 0.1 });
    const heavy = spawn(world, { position: { y: 0.3 }, velocity: {}, mass: 1e3, collider: 0.1 });
    steps(world, 300);
    const { y } = world.components.Position;
    expect(allFinite(world)).toBe(true);
    expect(y[heavy] - y[light]).toBeGreaterThan(0.9 * 0.2);
  });

  it('87 a collision conserves the momentum of the pair to 1e-12', () => {
    const world = space({ ...kind, precision: 'f64' });
    const body = (x: number, v: number, mass: number) =>
      spawn(world, {
        position: { x, y: x / 10 },
        velocity: { x: v, y: 0.3 },
        mass,
        inertia: mass * 0.1,
        angularVelocity: { z: v },
        collider: { radius: 0.5, restitution: 0.8, friction: 0.4 },
      });
    body(-2, 4, 3);
    body(2, -3, 7);
    const start = momentum(world);
    let met = 0;
    for (let i = 0; i < 120; i++) {
      step(world, DT);
      met += contacts(world).count;
    }
    expect(met).toBeGreaterThan(0);
    const end = momentum(world);
    // Relative to the 33 kg m/s of exchanged momentum.
    for (const axis of ['x', 'y', 'z'] as const) expect(Math.abs(end[axis] - start[axis])).toBeLessThan(33e-12);
  });
});

describe('handlers of contacts', () => {
  const meeting = () => {
    const world = space();
    const ids = [spawn(world, ofSpeed(-1, 6)), spawn(world, ofSpeed(1, -6)), ball(world, 50, 50)];
    return { world, ids };
  };
  const ofSpeed = (x: number, v: number) => ({
    position: { x },
    velocity: { x: v },
    mass: 1,
    collider: { radius: 0.5, restitution: 1 },
  });

  it('55 a handler can remove the bodies in contact, once each', () => {
    const { world, ids } = meeting();
    on(world, 'contact', (index) => {
      const { a, b } = contacts(world);
      for (const eid of [a[index], b[index]]) if (isBody(world, eid)) despawn(world, eid);
    });
    steps(world, 30);
    expect(ids.map((eid) => isBody(world, eid))).toEqual([false, false, true]);
    expect(contacts(world).count).toBe(0);
  });

  it('56 a handler can create bodies at the contact', () => {
    const { world } = meeting();
    const made: number[] = [];
    on(world, 'contact', (index) => {
      const { x, y } = contacts(world);
      if (made.length < 20) made.push(ball(world, x[index], y[index]));
    });
    steps(world, 40);
    expect(made.length).toBeGreaterThan(0);
    expect(made.every((eid) => isBody(world, eid))).toBe(true);
    expect(allFinite(world)).toBe(true);
  });

  it('59 a handler that throws at every contact does not stop the collision', () => {
    const { world, ids } = meeting();
    on(world, 'contact', () => {
      throw new Error('oops');
    });
    let thrown = 0;
    for (let i = 0; i < 30; i++) {
      try {
        step(world, DT);
      } catch (error) {
        expect(error).toBeInstanceOf(AggregateError);
        thrown++;
      }
    }
    expect(thrown).toBeGreaterThan(0);
    expect(world.components.Velocity.x[ids[0]]).toBeLessThan(0);
    expect(world.tick).toBe(30);
  });
});
