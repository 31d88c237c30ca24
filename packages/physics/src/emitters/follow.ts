// The place and the rotation of the body that an emitter follows.
import { MAX_POSITION } from '../components/position.ts';
import { isAlive } from '../ecs/entity-ref.ts';
import { cos, sin } from '../math/elementary.ts';
import type { Previous } from '../memory/previous-pose.ts';
import type { MemoryRecord } from '../memory/record.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { N, W } from './record.ts';
import type { Emitter } from './types.ts';

/** Moves the emitter to its body, now and at the last step; without the body it stops. */
export function followBody(world: PhysicsWorld, { internal }: Emitter, { words, numbers }: MemoryRecord): void {
  if (internal.followed === undefined || !isAlive(world, internal.followed)) {
    words[W.emits] = 0;
    return;
  }
  const eid = internal.entity;
  // The state of this step is not validated yet, so a pose that is not finite is ignored.
  if (!isValidPose(world.components, eid)) return;
  if (words[W.turns] !== 0) {
    readTurn(world, world.components, eid, numbers, N.turnX);
    readTurn(world, world.previous, eid, numbers, N.lastTurnX);
  }
  place(world.components, eid, numbers, N.x, N.turnX);
  place(world.previous, eid, numbers, N.lastX, N.lastTurnX);
}

function isValidPose({ Position: p, Rotation, Orientation: q }: Previous, eid: number): boolean {
  const position = isValid(p.x[eid]) && isValid(p.y[eid]) && isValid(p.z[eid]);
  return position && isValid(Rotation.angle[eid]) && isValid(q.x[eid] + q.y[eid] + q.z[eid] + q.w[eid]);
}

function isValid(coordinate: number): boolean {
  return Math.abs(coordinate) <= MAX_POSITION;
}

/** Writes the rotation of a body as a unit quaternion; a body without one is not rotated. */
function readTurn(world: PhysicsWorld, from: Previous, eid: number, numbers: Float64Array, at: number): void {
  if (world.dimensions === 2) {
    const half = from.Rotation.angle[eid] / 2;
    numbers[at] = 0;
    numbers[at + 1] = 0;
    numbers[at + 2] = sin(half);
    numbers[at + 3] = cos(half);
    return;
  }
  const { x, y, z, w } = from.Orientation;
  const norm = Math.sqrt(x[eid] * x[eid] + y[eid] * y[eid] + z[eid] * z[eid] + w[eid] * w[eid]);
  const rotates = norm > 0 && norm < MAX_POSITION;
  numbers[at] = rotates ? x[eid] / norm : 0;
  numbers[at + 1] = rotates ? y[eid] / norm : 0;
  numbers[at + 2] = rotates ? z[eid] / norm : 0;
  numbers[at + 3] = rotates ? w[eid] / norm : 1;
}

/** Writes the place of births: the position of the body and the rotated offset, v + 2 w (u × v) + 2 u × (u × v). */
function place({ Position }: Previous, eid: number, numbers: Float64Array, at: number, turn: number): void {
  const ox = numbers[N.offsetX];
  const oy = numbers[N.offsetY];
  const oz = numbers[N.offsetZ];
  const x = numbers[turn];
  const y = numbers[turn + 1];
  const z = numbers[turn + 2];
  const w = numbers[turn + 3];
  const cx = 2 * (y * oz - z * oy);
  const cy = 2 * (z * ox - x * oz);
  const cz = 2 * (x * oy - y * ox);
  numbers[at] = Position.x[eid] + ox + w * cx + (y * cz - z * cy);
  numbers[at + 1] = Position.y[eid] + oy + w * cy + (z * cx - x * cz);
  numbers[at + 2] = Position.z[eid] + oz + w * cz + (x * cy - y * cx);
}
