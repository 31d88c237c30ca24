// Rigid bodies that follow pointers: a mouse joint pulls the point at which a body was grabbed, so that it hangs, turns and
// pushes others as if held by a finger, and is thrown by the speed that it has when it is released.
import {
  createJoint,
  despawn,
  type EntityRef,
  entityRef,
  isAlive,
  keepState,
  mouseJoint,
  PhysicsError,
  type PhysicsWorld,
} from '@principia/physics';
import type { Dragging, DragOptions } from './dragging.ts';

/** How stiffly a body follows. */
const SPRING = { hertz: 8, dampingRatio: 1 };
/** Largest acceleration by the pointer, m/s²: enough to lift what lies on a body, and not enough to tear joints apart. */
const MAX_ACCELERATION = 1000;

interface Drag {
  readonly pointer: number;
  readonly id: number;
  readonly ref: EntityRef;
  /** The joint, by id. It goes with the body. */
  readonly joint: number;
}

/**
 * `dragBodies` for a world of rigid bodies: the `drag` of a game. Bodies keep the speed that they have when they are released,
 * whatever that of the pointer is; those without mass or of infinite mass, and all while the world is full, are not grabbed.
 */
export function dragByJoints(world: PhysicsWorld, { maxSpeed = 50, limit }: DragOptions = {}): Dragging {
  /** Keyed by body id. */
  const drags = new Map<number, Drag>();
  keepState(world, drags);
  const aim = ({ id, joint }: Drag, x: number, y: number) => {
    const point = { x, y, z: 0 };
    limit?.(point, id);
    world.components.Joint.ax[joint] = point.x;
    world.components.Joint.ay[joint] = point.y;
  };
  const release = ({ id, ref, joint }: Drag) => {
    drags.delete(id);
    if (!isAlive(world, ref)) return;
    despawn(world, joint);
    limitSpeed(world, id, maxSpeed);
  };
  return {
    get dragged() {
      return [...drags.keys()];
    },
    grab(pointer, id, x, y) {
      if (drags.has(id)) return;
      const joint = tryJoint(world, id, x, y);
      if (joint !== undefined) drags.set(id, { pointer, id, ref: entityRef(world, id), joint });
    },
    move(pointer, x, y) {
      for (const drag of drags.values()) if (drag.pointer === pointer && isAlive(world, drag.ref)) aim(drag, x, y);
    },
    release(pointer) {
      for (const drag of drags.values()) if (drag.pointer === pointer) release(drag);
    },
    holds: (pointer) => [...drags.values()].some((drag) => drag.pointer === pointer),
    place() {
      for (const drag of drags.values()) if (isAlive(world, drag.ref)) placeBody(world, drag);
    },
    releaseAll() {
      for (const drag of drags.values()) release(drag);
    },
    dropAll() {
      for (const drag of drags.values()) release(drag);
    },
  };
}

/** A body without mass cannot be pulled, and a full world has no room for a joint. */
function tryJoint(world: PhysicsWorld, id: number, x: number, y: number): number | undefined {
  const mass = world.components.Mass.value[id];
  if (!(mass > 0 && mass < Infinity)) return undefined;
  const point = { x, y };
  try {
    const joint = { b: id, anchor: point, target: point, spring: SPRING, maxForce: MAX_ACCELERATION * mass };
    return createJoint(world, mouseJoint(joint));
  } catch (error) {
    if (error instanceof PhysicsError && error.code === 'E_CAPACITY') return undefined;
    throw error;
  }
}

function limitSpeed({ components: { Velocity } }: PhysicsWorld, id: number, maxSpeed: number): void {
  const speed = Math.hypot(Velocity.x[id], Velocity.y[id]);
  if (speed <= maxSpeed) return;
  Velocity.x[id] *= maxSpeed / speed;
  Velocity.y[id] *= maxSpeed / speed;
}

/** Brings the point that was grabbed to the pointer, without a step. */
function placeBody({ components, previous, versions }: PhysicsWorld, { id, joint }: Drag): void {
  const { Joint, Position, Rotation } = components;
  const [c, s] = [Math.cos(Rotation.angle[id]), Math.sin(Rotation.angle[id])];
  const [bx, by] = [Joint.bx[joint], Joint.by[joint]];
  Position.x[id] = Joint.ax[joint] - (c * bx - s * by);
  Position.y[id] = Joint.ay[joint] - (s * bx + c * by);
  previous.Position.x[id] = Position.x[id];
  previous.Position.y[id] = Position.y[id];
  versions.pose++;
}
