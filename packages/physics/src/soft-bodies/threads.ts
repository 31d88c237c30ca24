// Which triangles of a sheet its springs hold. One that lost them is a hole, whatever its corners do, and no wind acts on it.
//
// The triangles of a cloth are held while the springs along their row and their column last: those along diagonals are
// there against shear, and many cloths have none. In other lists a triangle is held while two of its sides have springs,
// so that it cannot spread.
import { NO_GENERATION } from '../ecs/entity-ref.ts';
import { activeSprings, scanSprings } from '../forces/support/spring-table.ts';
import type { PhysicsWorld } from '../world/types.ts';
import type { Faces } from './faces.ts';

/** The number of sides with springs that hold a triangle. */
const MIN_SIDES = 2;

/**
 * Takes out the triangles that were held by their springs and no longer are. Does nothing until bodies or springs come
 * or go. A triangle that was not held at first stays, unless it is woven: something else holds such sheets.
 */
export function dropTornFaces(world: PhysicsWorld, faces: Faces): void {
  if (faces.membership === world.versions.membership) return;
  const isFirst = faces.membership < 0;
  faces.membership = world.versions.membership;
  const { count, quads } = faces;
  const threads = new Uint32Array(world.memory.buffer, faces.threads, 3 * count);
  const corners = new Uint32Array(world.memory.buffer, faces.at, 6 * count);
  let springs: SpringsByEnd | undefined;
  for (let face = 0; face < count; face++) {
    if (!isFirst && (!isWatched(threads, face) || countHeld(world, threads, corners, face) >= MIN_SIDES)) continue;
    // Another spring may lie along the same side.
    springs ??= springsByEnd(world);
    if (findThreads(springs, faces, threads, corners, face) >= MIN_SIDES) continue;
    threads.fill(0, 3 * face, 3 * face + 3);
    if (!isFirst || quads > 0) takeOut(world, faces, corners, face);
  }
}

function isWatched(threads: Uint32Array, face: number): boolean {
  return threads[3 * face] + threads[3 * face + 1] + threads[3 * face + 2] > 0;
}

/** Returns how many sides still have their spring. */
function countHeld(world: PhysicsWorld, threads: Uint32Array, corners: Uint32Array, face: number): number {
  const { a, b } = world.components.Spring;
  const count = corners.length / 6;
  let held = 0;
  for (let side = 0; side < 3; side++) {
    const spring = threads[3 * face + side];
    if (spring === 0) continue;
    const from = corners[count * side + face];
    const to = corners[count * ((side + 1) % 3) + face];
    if ((a[spring] === from && b[spring] === to) || (a[spring] === to && b[spring] === from)) held++;
  }
  return held;
}

/** Notes the springs along the sides of a triangle, but for the diagonal of a cloth. Returns how many there are. */
function findThreads(
  springs: SpringsByEnd,
  { count, quads }: Faces,
  threads: Uint32Array,
  corners: Uint32Array,
  face: number,
): number {
  const diagonal = quads === 0 ? -1 : face % (2 * quads) < quads ? 1 : 0;
  let held = 0;
  for (let side = 0; side < 3; side++) {
    if (side === diagonal) continue;
    const spring = springBetween(springs, corners[count * side + face], corners[count * ((side + 1) % 3) + face]);
    threads[3 * face + side] = spring;
    if (spring > 0) held++;
  }
  return held;
}

/** A triangle without its first corner, which kernels take as removed, in a part of the list that is no longer a quad strip: both are left out by kernels. */
function takeOut(world: PhysicsWorld, { count, sections }: Faces, corners: Uint32Array, face: number): void {
  corners[3 * count + face] = NO_GENERATION;
  const words = new Uint32Array(world.memory.buffer, sections);
  let section = 0;
  while (words[2 * section + 2] <= face) section++;
  words[2 * section + 1] = 0;
}

/** The active springs as a list for each body: of the springs of which it is the end with the higher id. */
interface SpringsByEnd {
  /** Id of the spring and its ends, three numbers per spring. */
  readonly links: Uint32Array;
  /** One more than the place of the last spring of a body; 0 if it has none. */
  readonly last: Uint32Array;
  /** One more than the place of the spring before, of the same body. */
  readonly before: Uint32Array;
}

function springsByEnd(world: PhysicsWorld): SpringsByEnd {
  const links = world.internal.counts.Spring > 0 ? activeSprings(world, scanSprings(world)) : new Uint32Array(0);
  const last = new Uint32Array(world.rows);
  const before = new Uint32Array(links.length / 3);
  for (let i = 0; i < before.length; i++) {
    const end = Math.max(links[3 * i + 1], links[3 * i + 2]);
    before[i] = last[end];
    last[end] = i + 1;
  }
  return { links, last, before };
}

/** Returns the spring between two bodies, 0 if there is none. */
function springBetween({ links, last, before }: SpringsByEnd, a: number, b: number): number {
  const [low, high] = [Math.min(a, b), Math.max(a, b)];
  for (let place = last[high]; place > 0; place = before[place - 1]) {
    const link = 3 * (place - 1);
    if (Math.min(links[link + 1], links[link + 2]) === low) return links[link];
  }
  return 0;
}
