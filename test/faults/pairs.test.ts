/** Forces between bodies: singular configurations stay finite, and faults do not spread. */
import {
  attractors,
  createPhysicsWorld,
  despawn,
  energy,
  type PhysicsWorld,
  removedSprings,
  spawn,
  springs,
  stateHash,
  step,
} from '@principia/physics';
import { addComponent, entityExists, set } from 'bitecs';
import { describe, expect, it } from 'vitest';
import {
  assertRefused,
  assertWorldAlive,
  ball,
  bodyState,
  DT,
  groundWorld,
  KINDS,
  steps,
  withWitness,
} from '../support/worlds.ts';

/** Laws that are summed together, so both worlds must have the same ones. */
function withAttraction(world: PhysicsWorld): void {
  world.forces.push(attractors());
}

function finiteBodies(world: PhysicsWorld): boolean {
  const { Position, Velocity } = world.components;
  const rows = world.lastId + 1;
  return [Position.x, Position.y, Position.z, Velocity.x, Velocity.y, Velocity.z].every((column) =>
    column.subarray(0, rows).every(Number.isFinite),
  );
}

describe.each(KINDS)('forces between bodies, $dimensions D $precision', (kind) => {
  it.each([0, 0.01])('18 a body in the centre of an attractor, softening %d, gets no force', (softening) => {
    const world = createPhysicsWorld({ ...kind, capacity: 10, forces: [attractors()] });
    spawn(world, { position: { x: 1, y: 2 }, attractor: { mu: 1e9, softening } });
    const eid = spawn(world, { position: { x: 1, y: 2 }, velocity: {}, mass: 1 });
    steps(world, 10);
    expect(bodyState(world, eid)).toBe('Position.x=1 Position.y=2 Mass.value=1');
    expect(Number.isFinite(energy(world).total)).toBe(true);
  });

  it('18 a fall through an attractor without softening stays finite', () => {
    const world = createPhysicsWorld({ ...kind, capacity: 10, forces: [attractors()] });
    spawn(world, { position: {}, attractor: { mu: 1e6 } });
    spawn(world, { position: { x: 1, y: 1e-9 }, velocity: {}, mass: 1 });
    for (let i = 0; i < 200; i++) {
      step(world, 1e-3);
      expect(finiteBodies(world)).toBe(true);
    }
  });

  it('19 coincident bodies joined by a spring separate along x, reproducibly', () => {
    const run = () => {
      const world = createPhysicsWorld({ ...kind, capacity: 10, forces: [springs()] });
      const [a, b] = [0, 1].map(() => spawn(world, { position: { x: 5 }, velocity: {}, mass: 1 }));
      spawn(world, { spring: { a, b, stiffness: 10, length: 1 } });
      steps(world, 10);
      const { x, y } = world.components.Position;
      expect(x[b]).toBeGreaterThan(x[a]);
      expect([y[a], y[b]]).toEqual([0, 0]);
      return stateHash(world);
    };
    expect(run()).toBe(run());
  });

  it('22 a spring of 1e15 N/m is refused with E_STIFF before anything moves', () => {
    const world = groundWorld(kind);
    const [a, b] = [ball(world, 0, 1), ball(world, 1, 1)];
    const spring = spawn(world, { spring: { a, b, stiffness: 1e15, length: 0.5 } });
    world.forces.push(springs());
    assertRefused(world, () => step(world, DT), { code: 'E_STIFF', entity: spring });
    despawn(world, spring);
    assertWorldAlive(world);
  });

  it.each([NaN, Infinity, 1e30])('6 an attractor whose x is %d does not affect other bodies', (bad) => {
    const { world, victim } = withWitness(
      ({ world, victim }) => {
        world.forces.push(attractors());
        addComponent(world, victim, set(world.components.Attractor, { mu: 1e-30 }));
        world.components.Position.x[victim] = bad;
        step(world, DT);
      },
      kind,
      20,
      withAttraction,
    );
    expect(world.faults.faults).toMatchObject([{ entity: victim, field: 'Position.x', step: 0 }]);
    expect(finiteBodies(world)).toBe(true);
  });

  it.each(['mu', 'softening'] as const)(
    '16 NaN in Attractor.%s is reset, reported once, and does not affect other bodies',
    (field) => {
      const { world, victim } = withWitness(
        ({ world, victim }) => {
          world.forces.push(attractors());
          addComponent(world, victim, set(world.components.Attractor, { mu: 0 }));
          world.components.Attractor[field][victim] = NaN;
        },
        kind,
        20,
        withAttraction,
      );
      expect(world.faults.faults).toMatchObject([{ code: 'E_NONFINITE', entity: victim, field: `Attractor.${field}` }]);
      expect(world.components.Attractor[field][victim]).toBe(0);
    },
  );

  it('16 a NaN force on a body of a chain does not spread through springs', () => {
    const chain = (poisoned: boolean) => {
      const world = createPhysicsWorld({ ...kind, capacity: 20, forces: [springs()] });
      const ids = Array.from({ length: 8 }, (_, i) =>
        spawn(world, { position: { x: i * 1.1 }, velocity: {}, mass: 1 }),
      );
      for (let i = 1; i < 8; i++) spawn(world, { spring: { a: ids[i - 1], b: ids[i], stiffness: 20, length: 1 } });
      world.forces.push({
        name: 'bad',
        equation: '',
        reads: [],
        local: true,
        accumulate({ scratch }, first, last) {
          if (poisoned && ids[0] >= first && ids[0] < last) scratch.force.x[ids[0]] = NaN;
        },
      });
      steps(world, 3);
      return { world, ids };
    };
    const { world, ids } = chain(true);
    expect(world.faults.faults).toMatchObject([{ code: 'E_NONFINITE', entity: ids[0], field: 'force.x', step: 0 }]);
    expect(world.internal.counts.Quarantined).toBe(1);
    expect(finiteBodies(world)).toBe(true);
    const control = chain(false);
    expect(bodyState(world, ids[7])).toBe(bodyState(control.world, control.ids[7]));
  });
});

describe('partial bodies', () => {
  const stage = (dimensions: 2 | 3) => {
    const world = groundWorld({ dimensions });
    ball(world, 0, 5); // a body that has everything, in the same block of rows
    return world;
  };

  it.each([2, 3] as const)('mass without velocity does not move, %d D', (dimensions) => {
    const world = stage(dimensions);
    const eid = spawn(world, { position: { x: 1, y: 5 } });
    addComponent(world, eid, set(world.components.Mass, 2));
    steps(world, 10);
    expect(bodyState(world, eid)).toBe('Position.x=1 Position.y=5 Mass.value=2');
    addComponent(world, eid, world.components.Velocity);
    step(world, DT);
    expect(world.components.Position.y[eid]).toBeLessThan(5);
  });

  it.each([2, 3] as const)('an entity without position does not move, %d D', (dimensions) => {
    const world = stage(dimensions);
    const eid = spawn(world, { velocity: { x: 3 }, mass: 2, angularVelocity: { z: 1 } });
    steps(world, 10);
    expect(bodyState(world, eid)).toBe('Velocity.x=3 Mass.value=2 AngularVelocity.z=1');
  });
});

describe('springs and the bodies they join', () => {
  const stage = () => {
    const world = createPhysicsWorld({ capacity: 20, forces: [springs()] });
    return { world, a: spawn(world, { position: {} }), b: spawn(world, { position: { x: 1 } }) };
  };

  it('53 a spring to a removed body, to itself, to id 0 or to another kind of entity is refused', () => {
    const { world, a, b } = stage();
    const gone = spawn(world, { position: {} });
    despawn(world, gone);
    const drag = spawn(world, { linearDrag: 1 });
    for (const end of [gone, drag, 19, 1e6]) {
      assertRefused(world, () => spawn(world, { spring: { a, b: end } }), { code: 'E_STALE', field: 'spring.b' });
    }
    assertRefused(world, () => spawn(world, { spring: { a, b: a } }), { code: 'E_RANGE' });
    assertRefused(world, () => spawn(world, { spring: { a } }), { code: 'E_RANGE' });
    assertRefused(world, () => spawn(world, { spring: { a: 1.5, b } }), { code: 'E_RANGE' });
    assertRefused(world, () => spawn(world, { spring: { a: -1, b } }), { code: 'E_RANGE' });
  });

  it('54 the springs of a removed body are removed and listed', () => {
    const { world, a, b } = stage();
    const c = spawn(world, { position: { x: 2 } });
    const [ab, bc] = [spawn(world, { spring: { a, b } }), spawn(world, { spring: { a: b, b: c } })];
    step(world, DT);
    despawn(world, a);
    const heir = spawn(world, { position: { x: 9 }, velocity: {}, mass: 1 });
    expect(heir).toBe(a);
    step(world, DT);
    expect(removedSprings(world)).toEqual([ab]);
    expect([world.internal.counts.Spring, entityExists(world, ab), entityExists(world, bc)]).toEqual([1, false, true]);
    expect(world.components.Position.x[heir]).toBe(9); // the spring did not pass to the heir of the id
    step(world, DT);
    expect(removedSprings(world)).toEqual([]);
  });

  it('53 invalid ends written to the columns have no effect', () => {
    const { world, a, b } = stage();
    const spring = spawn(world, { spring: { a, b, stiffness: 5 } });
    for (const nonsense of [0, 19, 1e6, 0xffffffff]) {
      world.components.Spring.b[spring] = nonsense;
      if (!entityExists(world, spring)) continue;
      step(world, DT);
    }
    expect(finiteBodies(world)).toBe(true);
    expect(world.faults.faults).toEqual([]);
  });
});
