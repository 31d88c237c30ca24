// Edits of components during a step: they add up as they do between steps, and belong to the body that was meant.
import {
  bodies,
  createJoint,
  createPhysicsWorld,
  despawn,
  destroyWorld,
  entityRef,
  isAlive,
  isBody,
  type PhysicsWorld,
  removedSprings,
  resolve,
  revolute,
  rigidBodies,
  spawn,
  springs,
  step,
} from '@principia/physics';
import { addComponent, entityExists, observe, onAdd, removeComponent, removeEntity, set } from 'bitecs';
import { describe, expect, it } from 'vitest';

const DT = 1 / 60;

/** Runs a function in the phase of events of the next step. */
function inStep(world: PhysicsWorld, edit: () => void): void {
  let isDone = false;
  world.phases.events.push(() => {
    if (!isDone) edit();
    isDone = true;
  });
  step(world, DT);
}

function hingedBody() {
  const world = createPhysicsWorld({ preset: rigidBodies, capacity: 50 });
  const b = spawn(world, { position: {}, mass: 1, collider: { radius: 0.5 } });
  const joint = createJoint(
    world,
    revolute({ b, anchor: {}, limits: { lower: -3, upper: 3 }, motor: { speed: 1, max: 1 } }),
  );
  step(world, DT);
  return { world, joint, b, Joint: world.components.Joint };
}

describe('two edits of a component in one step', () => {
  it('are both made, as between steps', () => {
    const { world, joint, Joint } = hingedBody();
    const wall = spawn(world, { planeWall: { offset: -50 } });
    inStep(world, () => {
      addComponent(world, joint, set(Joint, { lower: -1 }));
      addComponent(world, joint, set(Joint, { upper: 2 }));
      addComponent(world, wall, set(world.components.PlaneWall, { restitution: 0.5 }));
      addComponent(world, wall, set(world.components.PlaneWall, { offset: -60 }));
    });
    expect([Joint.lower[joint], Joint.upper[joint]]).toEqual([-1, 2]);
    expect([world.components.PlaneWall.restitution[wall], world.components.PlaneWall.offset[wall]]).toEqual([0.5, -60]);
  });

  it('are checked together: the second may need the first, and is refused where it contradicts it', () => {
    const { world, joint, Joint } = hingedBody();
    inStep(world, () => {
      addComponent(world, joint, set(Joint, { upper: 9 }));
      addComponent(world, joint, set(Joint, { lower: 7 }));
      expect(() => addComponent(world, joint, set(Joint, { upper: 6 }))).toThrow('lower');
    });
    expect([Joint.lower[joint], Joint.upper[joint]]).toEqual([7, 9]);
  });

  it('keep a quaternion of length 1', () => {
    const world = createPhysicsWorld({ dimensions: 3, capacity: 4 });
    const { Orientation } = world.components;
    const [inside, between] = [0, 1].map(() => spawn(world, { position: {}, orientation: { x: 1, w: 1 } }));
    const edit = (id: number) => {
      addComponent(world, id, set(Orientation, { y: 1 }));
      addComponent(world, id, set(Orientation, { z: 1 }));
    };
    edit(between);
    inStep(world, () => edit(inside));
    const of = (id: number) => [Orientation.x[id], Orientation.y[id], Orientation.z[id], Orientation.w[id]];
    expect(of(inside)).toEqual(of(between));
    expect(Math.hypot(...of(inside))).toBeCloseTo(1, 14);
  });

  it('leave what is written to other columns in between', () => {
    const { world, joint, Joint } = hingedBody();
    inStep(world, () => {
      addComponent(world, joint, set(Joint, { maxMotor: 9 }));
      Joint.motorSpeed[joint] = 5;
    });
    expect([Joint.motorSpeed[joint], Joint.maxMotor[joint]]).toEqual([5, 9]);
  });

  it('start from the initial values where the component is removed and added again', () => {
    const world = createPhysicsWorld({ preset: rigidBodies, capacity: 4 });
    const { PlaneWall } = world.components;
    const wall = spawn(world, { planeWall: { offset: -5, restitution: 0.25 } });
    inStep(world, () => {
      addComponent(world, wall, set(PlaneWall, { friction: 0.5 }));
      removeComponent(world, wall, PlaneWall);
      addComponent(world, wall, set(PlaneWall, { offset: -7 }));
    });
    expect([PlaneWall.offset[wall], PlaneWall.restitution[wall]]).toEqual([-7, 0]);
  });
});

describe('an id that is given to another body in the step', () => {
  it('is that of the new body for springs', () => {
    const world = createPhysicsWorld({ capacity: 50, forces: [springs()] });
    const [a, b] = [0, 1].map((x) => spawn(world, { position: { x }, mass: 1 }));
    let next = 0;
    let spring = 0;
    inStep(world, () => {
      removeEntity(world, b);
      next = spawn(world, { position: { x: 2 }, mass: 1 });
      spring = spawn(world, { spring: { a, b: next, length: 1, stiffness: 10 } });
    });
    expect(next).toBe(b);
    step(world, DT);
    expect(entityExists(world, spring)).toBe(true);
    expect(removedSprings(world)).toEqual([]);
    expect(world.components.Velocity.x[next]).toBeLessThan(0);
  });

  it('is no longer that of the old one for references', () => {
    const world = createPhysicsWorld({ capacity: 50 });
    const body = spawn(world, { position: {} });
    const ref = entityRef(world, body);
    inStep(world, () => {
      removeEntity(world, body);
      const next = spawn(world, { position: { x: 1 } });
      expect(next).toBe(body);
      expect([isAlive(world, ref), isBody(world, body)]).toEqual([false, false]);
      expect(() => resolve(world, ref)).toThrow('refers to no body');
      expect(() => entityRef(world, next)).toThrow('can be used only after it');
    });
    expect(isAlive(world, ref)).toBe(false);
    expect(isAlive(world, entityRef(world, body))).toBe(true);
  });
});

describe('an observer of additions that spawns', () => {
  it('leaves alone what was being added', () => {
    const world = createPhysicsWorld({ preset: rigidBodies, capacity: 50 });
    let left = 2;
    for (const component of [world.components.Mass, world.components.Joint]) {
      observe(world, onAdd(component), () => {
        if (left-- > 0) spawn(world, { position: {} });
      });
    }
    const b = spawn(world, { position: {}, mass: Infinity, collider: { radius: 0.5 } });
    expect(createJoint(world, revolute({ b, anchor: {} }))).toBeGreaterThan(b);
  });

  it.each(['the entity', 'the world'])('is told that it may not remove %s that is being spawned', (what) => {
    const world = createPhysicsWorld({ capacity: 50 });
    const before = spawn(world, { position: { x: 3 } });
    observe(world, onAdd(world.components.Position), (id) =>
      what === 'the world' ? destroyWorld(world) : despawn(world, id),
    );
    expect(() => spawn(world, { position: {}, mass: 1 })).toThrow('removed by an observer');
    if (what !== 'the world') expect([bodies(world).count, world.components.Position.x[before]]).toEqual([1, 3]);
  });
});
