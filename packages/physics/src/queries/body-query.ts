// The parts that all queries about bodies with colliders and walls share: the record that their kernels read
// (kernels/collision/queries/2d/body-query.ts), the filter of bodies, and the hit.
import { rigidKernels } from '../collision/kernels.ts';
import type { Shape } from '../collision/shapes/2d/shape.ts';
import { writeShape } from '../collision/shapes/store-shape.ts';
import type { RealColumn } from '../components/define.ts';
import { bitOf } from '../components/membership.ts';
import { assertUsable } from '../ecs/guards.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkFlag, checkKeys, checkNumber, checkVector } from '../errors/validate.ts';
import { cos, sin } from '../math/elementary.ts';
import { allocate } from '../memory/arena.ts';
import { BODY_QUERY_BYTES, SHAPE_BYTES } from '../memory/layouts.gen.ts';
import { namedResource } from '../memory/resource.ts';
import { contentVersion, poolVersion } from '../solver/content-version.ts';
import { placeParts } from '../solver/refresh-parts.ts';
import { rigidTable } from '../solver/rigid-table.ts';
import { isSoftStep } from '../world/is-soft-step.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { type BodyFilter, checkBodyFilter } from './body-filter.ts';
import { visitWalls, type WallQuery } from './walls.ts';

/** What a query is about. */
export interface QueryFilter extends BodyFilter {
  /** Whether walls are seen: segments, planes and those of `boxWalls`, which are on all layers; default true. */
  readonly walls?: boolean;
}

/** Where a ray or a moving shape met a body or a wall. What wants a place takes it as it is: `distance({ b, anchorA: hit })`. */
export interface Hit {
  /** Entity id of the body or the wall; 0 for a wall of `boxWalls` that is no entity, as in `wallContacts`. */
  readonly body: number;
  /** Whether it is a wall. */
  readonly isWall: boolean;
  /** Fraction of the movement until then, 0 to 1. */
  readonly fraction: number;
  /** Point on the surface, m. */
  readonly x: number;
  readonly y: number;
  /** Unit normal of the surface there, outward; zero where outlines, or the cores of rounded ones, overlapped from the start. */
  readonly nx: number;
  readonly ny: number;
}

/** The position and angle of a shape. */
export interface PoseInput {
  /** Metres; default 0. */
  readonly x?: number;
  /** Metres; default 0. */
  readonly y?: number;
  /** Radians, anticlockwise; default 0. */
  readonly angle?: number;
}

/** Bytes of the ten integers at the start of the record, and of the reals behind them in this order. */
const INTEGER_BYTES = 40;
const REALS = ['x', 'y', 'c', 's', 'dx', 'dy', 'limit', 'reach', 'fraction', 'nx', 'ny', 'pointX', 'pointY'] as const;

/** Indices into the reals of the record. */
const R = Object.fromEntries(REALS.map((name, i) => [name, i])) as Record<(typeof REALS)[number], number>;

interface QueryMemory {
  /** Address of the record, and of a record for the shape of the query. */
  readonly at: number;
  readonly shapeAt: number;
  readonly words: Uint32Array;
  readonly reals: RealColumn;
}

/** The memory of queries, of which one at a time runs. Nothing in it outlasts a call. */
const queryMemory = namedResource('query memory', (world): QueryMemory => {
  const { internal, memory, precision } = world;
  const at = allocate(internal.arena, BODY_QUERY_BYTES[precision], 'queries');
  const shapeAt = allocate(internal.arena, SHAPE_BYTES[precision], 'queries');
  const Reals = precision === 'f32' ? Float32Array : Float64Array;
  const words = new Uint32Array(memory.buffer, at, INTEGER_BYTES / 4);
  return { at, shapeAt, words, reals: new Reals(memory.buffer, at + INTEGER_BYTES, REALS.length) };
});

const BODY = (bitOf('Position') | bitOf('Collider')) >>> 0;

/** A query that runs. */
export interface RunningQuery extends WallQuery {
  readonly shapeAt: number;
  readonly reals: RealColumn;
  /** Address of the table whose trees, with the rows that changed, hold for the bodies as they are now, 0 if none do. */
  readonly trees: number;
}

/** The path of a query: where it starts, the angle of its shape, and where it moves to from there. */
export interface Path {
  readonly x: number;
  readonly y: number;
  readonly angle: number;
  readonly dx: number;
  readonly dy: number;
}

/**
 * Fills the record for a query along a path, about bodies whose surface comes within `reach` of it. `knownTrees` is what `treesOf` said
 * of the bodies as they are now, with all parts placed.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE for the filter; E_CAPACITY, E_DESTROYED
 */
export function openQuery(
  world: PhysicsWorld,
  path: Path,
  reach: number,
  filter: QueryFilter,
  shape?: Shape,
  knownTrees?: number,
): RunningQuery {
  const { mask, ignored, seesSensors } = checkBodyFilter(filter);
  if (knownTrees === undefined) placeParts(world);
  const { at, shapeAt, words, reals } = queryMemory(world);
  const { Rotation, Collider } = world.addresses;
  const checked = [mask, ignored[0] ?? 0, world.lastId];
  const columns = [Rotation.angle, Collider.layers, Collider.sensor];
  words.set([BODY, ...checked, ...columns, Number(seesSensors), 0, 0]);
  reals.set([path.x, path.y, cos(path.angle), sin(path.angle), path.dx, path.dy, 1, reach]);
  if (shape !== undefined) writeShape(world, shapeAt, shape);
  const seesWalls = checkFlag(filter.walls ?? true, 'walls');
  const kernels = rigidKernels(world);
  const trees = knownTrees ?? treesOf(world);
  const query = { world, kernels, at, ignored, seesWalls, shapeAt, reals, trees };
  // Without bounds all bodies are in reach.
  if (query.trees !== 0 && reach !== Infinity) kernels.collectCandidates(at, query.trees);
  return query;
}

/** The hit that the kernel wrote. */
export function readHit({ reals }: RunningQuery, body: number, isWall: boolean): Hit {
  return {
    body,
    isWall,
    fraction: reals[R.fraction],
    x: reals[R.pointX],
    y: reals[R.pointY],
    nx: reals[R.nx],
    ny: reals[R.ny],
  };
}

/** How a query finds what it meets, which it then writes into its record. */
export interface Probe {
  /** The next body from a row on, 0 if there is none. */
  readonly next: (row: number) => number;
  /** Whether it meets the wall that was placed last: 1 or 0. */
  meetsWall(): number;
}

/**
 * Calls `visit` with each body that a query finds, except those that it ignores and their parts, and entities of emitters
 * that wait to be particles, which alone have a collider without a radius.
 */
export function visitBodies(
  { world, ignored }: RunningQuery,
  next: (row: number) => number,
  visit: (row: number) => void,
): void {
  const { Attachment, Collider } = world.components;
  const { body } = Attachment;
  for (let row = next(1); row > 0; row = next(row + 1)) {
    if (Collider.radius[row] === 0) continue;
    if (ignored.length === 0 || !(ignored.includes(row) || ignored.includes(body[row]))) visit(row);
  }
}

/** The first of all hits, and of equally early ones that of the smallest id. */
export function firstHit(query: RunningQuery, probe: Probe): Hit | undefined {
  let first: Hit | undefined;
  const consider = (id: number, isWall: boolean) => {
    const fraction = query.reals[R.fraction];
    if (first !== undefined && (fraction > first.fraction || (fraction === first.fraction && id >= first.body))) return;
    first = readHit(query, id, isWall);
    // What lies behind it need not be computed.
    query.reals[R.limit] = fraction;
  };
  visitBodies(query, probe.next, (row) => consider(row, false));
  visitWalls(query, (id) => {
    if (probe.meetsWall() === 1) consider(id, true);
  });
  return first;
}

/** All hits, the earliest first, and of equally early ones that of the smaller id. */
export function allHits(query: RunningQuery, probe: Probe): Hit[] {
  const hits: Hit[] = [];
  visitBodies(query, probe.next, (row) => hits.push(readHit(query, row, false)));
  visitWalls(query, (id) => {
    if (probe.meetsWall() === 1) hits.push(readHit(query, id, true));
  });
  return hits.sort((a, b) => a.fraction - b.fraction || a.body - b.body);
}

/** Bodies below which a look at all of them takes no longer than one at the trees. */
const FEW_BODIES = 200;

/** Address of the table whose trees hold for so many queries about the bodies as they are now, 0 if none do. */
export function treesOf(world: PhysicsWorld, queries = 1): number {
  if (!isSoftStep(world.integrator) || world.lastId < FEW_BODIES) return 0;
  const { at } = rigidTable(world);
  const versions = [contentVersion(world), poolVersion(world)] as const;
  const isHeld = rigidKernels(world).treesHold(at, world.lastId + 1, ...versions, BODY, queries);
  return isHeld === 1 ? at : 0;
}

/** Confines a query about a point to the bodies within a distance. */
export function confine(query: RunningQuery, reach: number): void {
  setReach(query, reach);
  query.kernels.collectCandidates(query.at, query.trees);
}

/** Changes the distance from the path within which bodies are of interest. */
export function setReach(query: RunningQuery, reach: number): void {
  query.reals[R.reach] = reach;
}

/**
 * Checks that a world has two dimensions, as queries about shapes need.
 * @throws PhysicsError E_RANGE, E_DESTROYED, E_TYPE
 */
export function assertPlanar(world: PhysicsWorld, caller: string): void {
  assertUsable(world);
  if (world.dimensions === 2) return;
  throw new PhysicsError('E_RANGE', `${caller} is for worlds of two dimensions, and this one has three.`, {
    hint: 'Make the world with `dimensions: 2`, or use bodyAt.',
  });
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN */
export function checkFilter(filter: unknown, caller: string, others: readonly string[] = []): void {
  checkKeys(filter, caller, ['mask', 'ignore', 'sensors', 'walls', ...others]);
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN */
export function checkPose(pose: unknown, field: string): { x: number; y: number; angle: number } {
  checkKeys(pose, field, ['x', 'y', 'angle'], 'field');
  const { angle = 0, ...point } = pose as PoseInput;
  const { x, y } = checkVector(point, field);
  return { x, y, angle: checkNumber(angle, `${field}.angle`) };
}
