// Bodies that a force removes as it is prepared, and steps that are refused after springs and joints went.
import {
  createJoint,
  createPhysicsWorld,
  defineForce,
  despawn,
  endedJoints,
  type Integrator,
  type PhysicsWorld,
  removedSprings,
  revolute,
  spawn,
  springs,
  step,
  velocityVerlet,
  xpbd,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';

const BOTH: [string, () => Integrator][] = [
  ['springs()', () => velocityVerlet],
  ['xpbd', () => xpbd()],
];

/** A force that does nothing but this as it is prepared. */
const whenPrepared = (prepare: (world: PhysicsWorld) => void) =>
  defineForce({ name: 'acts when prepared', equation: '0', reads: [], local: true, prepare, accumulate() {} });

/** A spring of 1 m at rest between two bodies. */
function springWorld(integrator: Integrator) {
  const world = createPhysicsWorld({ capacity: 100, integrator, forces: [springs()] });
  const a = spawn(world, { position: { x: 10 }, mass: 1 });
  const b = spawn(world, { position: { x: 11 }, mass: 1 });
  const spring = spawn(world, { spring: { a, b, length: 1, stiffness: 100 } });
  return { world, a, b, spring };
}

describe.each(BOTH)('under %s', (_, makeIntegrator) => {
  it.each(['before', 'after'])(
    'a body that a force removes when it is prepared %s the springs pulls no more',
    (order) => {
      const { world, a, b, spring } = springWorld(makeIntegrator());
      const remove = whenPrepared(({ tick }) => {
        if (tick === 5) despawn(world, b);
      });
      if (order === 'before') world.forces.unshift(remove);
      else world.forces.push(remove);
      for (let i = 0; i < 7; i++) step(world, DT);
      // Nothing acted: the spring was at rest, and its other end is gone.
      expect([world.components.Position.x[a], world.components.Velocity.x[a]]).toEqual([10, 0]);
      expect(world.internal.counts.Spring).toBe(0);
      if (order === 'after') expect(removedSprings(world)).toEqual([spring]);
      step(world, DT);
      expect(removedSprings(world)).toEqual([]);
    },
  );

  it('springs that went before a step that was refused are named after the next', () => {
    const { world, a, b, spring } = springWorld(makeIntegrator());
    const c = spawn(world, { position: { x: 12 }, mass: 1 });
    const other = spawn(world, { spring: { a, b: c, length: 2, stiffness: 100 } });
    let refuses = true;
    world.forces.push(
      whenPrepared(() => {
        if (refuses) throw new Error('not now');
      }),
    );
    despawn(world, c);
    expect(() => step(world, DT)).toThrow('not now');
    despawn(world, b);
    expect(() => step(world, DT)).toThrow('not now');
    refuses = false;
    step(world, DT);
    expect(removedSprings(world)).toEqual([spring, other]);
    step(world, DT);
    expect(removedSprings(world)).toEqual([]);
  });
});

it('joints that went before a step that was refused are named after the next', () => {
  const world = rigidWorld();
  const [one, two] = [1, 2].map((x) => spawn(world, { position: { x }, mass: 1, collider: { radius: 0.1 } }));
  const [first, second] = [one, two].map((b) => createJoint(world, revolute({ b, anchor: { y: 1 } })));
  let refuses = true;
  world.forces.push(
    whenPrepared(() => {
      if (refuses) throw new Error('not now');
    }),
  );
  despawn(world, two);
  expect(() => step(world, DT)).toThrow('not now');
  despawn(world, one);
  expect(() => step(world, DT)).toThrow('not now');
  refuses = false;
  step(world, DT);
  expect(endedJoints(world).removed).toEqual([first, second]);
  step(world, DT);
  expect(endedJoints(world).removed).toEqual([]);
});
