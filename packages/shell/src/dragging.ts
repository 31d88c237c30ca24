// Bodies that follow pointers. A dragged body is kinematic: its mass is set to zero, so that it pushes other bodies and
// is not pushed, and every step starts with the velocity that brings it to its pointer by the end of the step.
// Releasing it restores the mass and throws the body; a body of infinite mass, such as a pin, stops instead.
import { type EntityRef, entityRef, isAlive, keepState, type PhysicsWorld } from '@principia/physics';

/** The bodies that pointers drag. A pointer may drag several bodies. Points in m, velocities in m/s. */
export interface Dragging {
  /** Ids of the dragged bodies, in the order in which they were grabbed. */
  readonly dragged: readonly number[];
  /** Whether a pointer drags a body. */
  holds(pointer: number): boolean;
  /** Grabs body `id` unless it is dragged already. The offset between body and pointer is kept. */
  grab(pointer: number, id: number, x: number, y: number, z?: number): void;
  /** The pointer moved: its bodies follow with the next step. Nothing happens if it drags none. */
  move(pointer: number, x: number, y: number, z?: number): void;
  /** Releases the pointer's bodies with the given velocity. */
  release(pointer: number, vx: number, vy: number, vz?: number): void;
  /** Moves dragged bodies to their pointers without a step, for example while the game is paused. */
  place(): void;
  /** Releases all bodies at rest. */
  releaseAll(): void;
  /** Releases all bodies without a throw: masses are restored, velocities stay. */
  dropAll(): void;
}

/** Options of `dragBodies`. */
export interface DragOptions {
  /** Largest speed of a dragged or thrown body, m/s; default 50. It limits the effect of glitches in the input. */
  readonly maxSpeed?: number;
  /** Changes the target point of a dragged body in place, for example to keep it inside a box. Default none. */
  readonly limit?: (point: Point, id: number) => void;
}

interface Point {
  x: number;
  y: number;
  z: number;
}

interface DragState {
  readonly pointer: number;
  readonly id: number;
  /** Detects that the id was reused by another body. */
  readonly ref: EntityRef;
  /** Mass to restore on release, kg. */
  readonly mass: number;
  /** Vector from the pointer to the body's centre at the time of the grab. */
  readonly offset: Point;
  readonly target: Point;
}

/** Lets pointers drag bodies of `world`: adds one system to its `input` phase. */
export function dragBodies(world: PhysicsWorld, options: DragOptions = {}): Dragging {
  const { maxSpeed = 50, limit } = options;
  /** Keyed by body id. */
  const drags = new Map<number, DragState>();
  const { Position, Velocity, Mass } = world.components;
  const aim = (drag: DragState, x: number, y: number, z: number) => {
    const { offset, target } = drag;
    target.x = x + offset.x;
    target.y = y + offset.y;
    target.z = world.dimensions === 3 ? z + offset.z : 0;
    limit?.(target, drag.id);
  };
  const setVelocity = (id: number, vx: number, vy: number, vz: number) => {
    const speed = Math.hypot(vx, vy, vz);
    const factor = speed > maxSpeed ? maxSpeed / speed : 1;
    Velocity.x[id] = vx * factor;
    Velocity.y[id] = vy * factor;
    if (world.dimensions === 3) Velocity.z[id] = vz * factor;
  };
  keepState(world, drags);
  world.phases.input.push((_, dt) => followPointers(world, drags, setVelocity, dt));
  const releaseBody = ({ id, ref, mass }: DragState, vx: number, vy: number, vz: number) => {
    drags.delete(id);
    if (!isAlive(world, ref)) return;
    Mass.value[id] = mass;
    if (mass === Infinity) setVelocity(id, 0, 0, 0);
    else setVelocity(id, vx, vy, vz);
  };
  const release = (pointer: number, vx: number, vy: number, vz = 0) => {
    for (const drag of drags.values()) if (drag.pointer === pointer) releaseBody(drag, vx, vy, vz);
  };
  return {
    get dragged() {
      return [...drags.keys()];
    },
    holds(pointer) {
      for (const drag of drags.values()) if (drag.pointer === pointer) return true;
      return false;
    },
    grab(pointer, id, x, y, z = 0) {
      if (drags.has(id)) return;
      const offset = { x: Position.x[id] - x, y: Position.y[id] - y, z: Position.z[id] - z };
      const ref = entityRef(world, id);
      const drag = { pointer, id, ref, mass: Mass.value[id], offset, target: { x: 0, y: 0, z: 0 } };
      Mass.value[id] = 0;
      aim(drag, x, y, z);
      drags.set(id, drag);
    },
    move(pointer, x, y, z = 0) {
      for (const drag of drags.values()) if (drag.pointer === pointer) aim(drag, x, y, z);
    },
    release,
    place() {
      if (drags.size > 0) placeBodies(world, drags.values());
    },
    dropAll() {
      for (const { id, ref, mass } of drags.values()) if (isAlive(world, ref)) Mass.value[id] = mass;
      drags.clear();
    },
    releaseAll() {
      for (const drag of drags.values()) releaseBody(drag, 0, 0, 0);
    },
  };
}

type SetVelocity = (id: number, vx: number, vy: number, vz: number) => void;

/** Gives dragged bodies the velocities that bring them to their pointers within `dt`. */
function followPointers(world: PhysicsWorld, drags: Map<number, DragState>, setVelocity: SetVelocity, dt: number) {
  if (drags.size === 0) return;
  const { Position, AngularVelocity } = world.components;
  for (const { id, ref, target } of drags.values()) {
    if (!isAlive(world, ref)) {
      drags.delete(id);
      continue;
    }
    const { x, y, z } = Position;
    setVelocity(id, (target.x - x[id]) / dt, (target.y - y[id]) / dt, (target.z - z[id]) / dt);
    for (const axis of ['x', 'y', 'z'] as const) AngularVelocity[axis][id] = 0;
  }
}

function placeBodies(world: PhysicsWorld, drags: Iterable<DragState>): void {
  const { components, previous, versions } = world;
  for (const { id, ref, target } of drags) {
    if (!isAlive(world, ref)) continue;
    for (const axis of ['x', 'y', 'z'] as const) {
      components.Position[axis][id] = target[axis];
      previous.Position[axis][id] = target[axis];
    }
    versions.pose++;
  }
}
