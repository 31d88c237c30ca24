// Bodies that follow pointers. A held body is kinematic: its mass is taken away, so that it pushes what it meets and
// nothing pushes it, and at the start of every step it gets the velocity that brings it to its pointer by the step's
// end. Letting go gives the mass back and throws; what has infinite mass, as a pin, is put down.
import { type EntityRef, entityRef, isAlive, keepState, type PhysicsWorld } from '@principia/physics';

/** Bodies held by pointers, any number at once, several by one pointer too. Points are metres, velocities metres per second. */
export interface Holding {
  /** The held bodies, in the order they were taken. */
  readonly held: readonly number[];
  /** Takes body `id` as well, unless it is held already; the body keeps its place under the pointer. */
  grab(pointer: number, id: number, x: number, y: number, z?: number): void;
  move(pointer: number, x: number, y: number, z?: number): void;
  /** Lets go and throws. */
  release(pointer: number, vx: number, vy: number, vz?: number): void;
  /** Puts held bodies where their pointers are without a step, as while the game is paused. */
  place(): void;
  releaseAll(): void;
  /** Lets go without a throw: masses are given back, velocities stay. */
  dropAll(): void;
}

/** What `holdBodies` may be told. */
export interface HoldingOptions {
  /** Fastest a body is moved or thrown, m/s; default 50. A hand does not reach more, and a glitch would. */
  readonly maxSpeed?: number;
  /** Changes a point a held body is wanted at, in place, as to keep it inside a room. */
  readonly limit?: (point: Point, id: number) => void;
}

interface Point {
  x: number;
  y: number;
  z: number;
}

interface Grip {
  readonly pointer: number;
  readonly id: number;
  /** Another body may have the id by now. */
  readonly ref: EntityRef;
  /** What the body weighs when it is let go, kg. */
  readonly mass: number;
  /** From the pointer to the body's centre when it was taken. */
  readonly offset: Point;
  readonly target: Point;
}

/** Lets pointers hold bodies of `world`: adds one system to its `input` phase. */
export function holdBodies(world: PhysicsWorld, options: HoldingOptions = {}): Holding {
  const { maxSpeed = 50, limit } = options;
  /** By body. */
  const grips = new Map<number, Grip>();
  const { Position, Velocity, AngularVelocity, Mass } = world.components;
  const aim = (grip: Grip, x: number, y: number, z: number) => {
    const { offset, target } = grip;
    target.x = x + offset.x;
    target.y = y + offset.y;
    target.z = world.dimensions === 3 ? z + offset.z : 0;
    limit?.(target, grip.id);
  };
  const push = (id: number, vx: number, vy: number, vz: number) => {
    const speed = Math.hypot(vx, vy, vz);
    const factor = speed > maxSpeed ? maxSpeed / speed : 1;
    Velocity.x[id] = vx * factor;
    Velocity.y[id] = vy * factor;
    if (world.dimensions === 3) Velocity.z[id] = vz * factor;
  };
  const follow = (_: PhysicsWorld, dt: number) => {
    if (grips.size === 0) return;
    for (const { id, ref, target } of grips.values()) {
      if (!isAlive(world, ref)) grips.delete(id);
      else {
        push(id, (target.x - Position.x[id]) / dt, (target.y - Position.y[id]) / dt, (target.z - Position.z[id]) / dt);
        for (const axis of ['x', 'y', 'z'] as const) AngularVelocity[axis][id] = 0;
      }
    }
  };
  keepState(world, grips);
  world.phases.input.push(follow);
  const letGo = ({ id, ref, mass }: Grip, vx: number, vy: number, vz: number) => {
    grips.delete(id);
    if (!isAlive(world, ref)) return;
    Mass.value[id] = mass;
    if (mass === Infinity) push(id, 0, 0, 0);
    else push(id, vx, vy, vz);
  };
  const release = (pointer: number, vx: number, vy: number, vz = 0) => {
    for (const grip of grips.values()) if (grip.pointer === pointer) letGo(grip, vx, vy, vz);
  };
  return {
    get held() {
      return [...grips.keys()];
    },
    grab(pointer, id, x, y, z = 0) {
      if (grips.has(id)) return;
      const offset = { x: Position.x[id] - x, y: Position.y[id] - y, z: Position.z[id] - z };
      const ref = entityRef(world, id);
      const grip = { pointer, id, ref, mass: Mass.value[id], offset, target: { x: 0, y: 0, z: 0 } };
      Mass.value[id] = 0;
      aim(grip, x, y, z);
      grips.set(id, grip);
    },
    move(pointer, x, y, z = 0) {
      for (const grip of grips.values()) if (grip.pointer === pointer) aim(grip, x, y, z);
    },
    release,
    place() {
      if (grips.size > 0) placeBodies(world, grips.values());
    },
    dropAll() {
      for (const { id, ref, mass } of grips.values()) if (isAlive(world, ref)) Mass.value[id] = mass;
      grips.clear();
    },
    releaseAll() {
      for (const grip of grips.values()) letGo(grip, 0, 0, 0);
    },
  };
}

function placeBodies(world: PhysicsWorld, grips: Iterable<Grip>): void {
  const { components, previous, versions } = world;
  for (const { id, ref, target } of grips) {
    if (!isAlive(world, ref)) continue;
    for (const axis of ['x', 'y', 'z'] as const) {
      components.Position[axis][id] = target[axis];
      previous.Position[axis][id] = target[axis];
    }
    versions.pose++;
  }
}
