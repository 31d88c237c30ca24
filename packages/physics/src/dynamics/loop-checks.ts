// The checks of a loop on its results. They use as few operations as possible, because they run for every body.
import { MAX_POSITION } from '../components/position.ts';
import { MAX_SPEED } from '../components/velocity.ts';
import type { LoopSource, Store, WallTest } from '../laws/loop-source.ts';
import type { Node } from '../laws/node.ts';
import type { Box, Result, StepFeatures } from './step-features.ts';
import type { WorldColumns } from './world-columns.ts';

/** No valid coordinate reaches this value. */
export const FAR = 1e30;

/** Bodies nearer to a wall than this fraction of the box are checked individually. */
const MARGIN = 1e-6;

/**
 * A body at rest on a wall rebounds only with a larger restitution; kernels/particle-contacts/walls/box.ts has the same
 * constant.
 */
const REST_RESTITUTION = 0.99;

/**
 * Contacts need the bodies within this multiple of their radius of a wall; kernels/particle-contacts/table.ts has the
 * same constant.
 */
const WALL_MARGIN = 1.1;

/** Weight of v² beside distances at which the fastest valid speed counts as the farthest valid coordinate. */
const LEAST_WEIGHT = MAX_POSITION / (MAX_SPEED * MAX_SPEED);

/**
 * Returns the tests that position and velocity are within their limits. The cheap test suffices for nearly all bodies:
 * after a drift it is that of the distance from the origin, and otherwise the test without its weight of the speed, which
 * takes one operation less and holds up to a tenth of the speed limit.
 */
export function rangeTests(columns: WorldColumns, state: Moved): Required<Pick<LoopSource, 'inRange' | 'fastCheck'>> {
  const fastCheck = nearOrigin(columns, state) ?? rangeTest(columns, state, 1);
  return { inRange: rangeTest(columns, state, LEAST_WEIGHT), fastCheck };
}

/** Half of the speed limit, m/s, with a margin against rounding. */
const MAX_DRIFT = 0.499 * MAX_SPEED;

/** Position and velocity of the bodies. */
interface Moved {
  readonly position: readonly Node[];
  readonly velocity: readonly Node[];
}

/** Builds the checks of a step loop. */
export function checksOf(
  columns: WorldColumns,
  start: Moved,
  result: Result,
  { box, list, recordsContacts, savesVelocity }: StepFeatures,
): Pick<LoopSource, 'inRange' | 'walls' | 'fastCheck'> {
  const reach = recordsContacts ? WALL_MARGIN : 1;
  const inside = box === undefined ? undefined : insideBox(columns, result, box, reach);
  if (box === undefined || inside === undefined) return rangeTests(columns, result);
  const inRange = rangeTest(columns, result, LEAST_WEIGHT);
  const { graph } = columns;
  const walls: WallTest = {
    // Walls do not hold what has no radius or no mass, such as unused rows, whose position is zero.
    inside: graph.make('or', [inside, graph.make('not', [isSolid(columns)])]),
    list,
    startVelocity: savesVelocity ? [] : columns.axisNames.map((_, i) => start.velocity[i]),
    resting: recordsContacts ? undefined : restingBodies(columns, start, result, box),
  };
  const fastCheck = isClosed(columns, box)
    ? wellInside(columns, result, box, reach)
    : columns.graph.make('and', [inside, inRange]);
  return { inRange, walls, fastCheck };
}

/**
 * A cheap sufficient condition for all values to be within limits; where it fails, rows are checked one by one. It is a
 * sum, so that a single NaN or infinity makes it fail.
 * @param weight of the square of the speed beside distances: the least that suffices, or more
 */
function rangeTest(columns: WorldColumns, { position, velocity }: Moved, weight: number): Node {
  const { graph, axisNames } = columns;
  const distances = axisNames.map((_, i) => graph.make('abs', [position[i]]));
  const sum = (nodes: readonly Node[]) => nodes.reduce((a, b) => graph.make('add', [a, b]));
  const square = squareOf(columns, velocity);
  const speed = weight === 1 ? square : graph.make('mul', [square, graph.constant(weight)]);
  return graph.make('lessOrEqual', [graph.make('add', [sum(distances), speed]), graph.constant(MAX_POSITION)]);
}

/**
 * Returns whether a body is nearer to the origin than half the distance that the speed limit allows in the step; undefined if
 * the step does not end with a drift by the new velocity. A body that starts and ends that near cannot have been too fast;
 * one that comes from further away is tested again where it goes.
 */
function nearOrigin(columns: WorldColumns, moved: Moved): Node | undefined {
  if (!endsWithDrift(columns, moved)) return undefined;
  const { graph } = columns;
  const duration = driftOf(moved.position[0], moved.velocity[0]) as Node;
  const reach = graph.make('mul', [duration, graph.constant(MAX_DRIFT)]);
  const limit = graph.make('min', [graph.make('mul', [reach, reach]), graph.constant(MAX_POSITION * MAX_POSITION)]);
  return graph.make('lessOrEqual', [squareOf(columns, moved.position), limit]);
}

function squareOf({ graph, axisNames }: WorldColumns, v: readonly Node[]): Node {
  return axisNames.map((_, i) => graph.make('mul', [v[i], v[i]])).reduce((a, b) => graph.make('add', [a, b]));
}

/** Returns whether a body including its radius is inside the box; undefined if no side of the box is a wall. */
function insideBox(columns: WorldColumns, { position }: Moved, box: Box, reach: number): Node | undefined {
  const { graph, axisNames } = columns;
  const radius = radiusOf(columns, reach);
  const conditions = axisNames.flatMap((axis, i) => {
    const low = graph.make('add', [graph.constant(box.low[axis]), radius]);
    const high = graph.make('sub', [graph.constant(box.high[axis]), radius]);
    return [
      ...(box.low[axis] > -FAR ? [graph.make('lessOrEqual', [low, position[i]])] : []),
      ...(box.high[axis] < FAR ? [graph.make('lessOrEqual', [position[i], high])] : []),
    ];
  });
  return conditions.length === 0 ? undefined : conditions.reduce((a, b) => graph.make('and', [a, b]));
}

/**
 * Returns whether a body is well inside a closed box and not too fast, which implies valid values. It takes one
 * comparison per axis, with a margin against rounding. If the last operation of a step is a drift with the new
 * velocity, a body that ends in the box has a finite velocity, and one that is too fast leaves the box in the next
 * step.
 */
function wellInside(columns: WorldColumns, { position, velocity }: Moved, box: Box, reach: number): Node {
  const { graph, axisNames } = columns;
  const radius = radiusOf(columns, reach);
  const conditions = axisNames.map((axis, i) => {
    const half = (box.high[axis] - box.low[axis]) / 2;
    const centre = box.low[axis] + half;
    const halfWidth = graph.make('sub', [graph.constant(half - MARGIN * Math.max(half, Math.abs(centre))), radius]);
    const distance = graph.make('abs', [graph.make('sub', [position[i], graph.constant(centre)])]);
    return graph.make('lessOrEqual', [distance, halfWidth]);
  });
  if (!endsWithDrift(columns, { position, velocity })) {
    conditions.push(graph.make('lessOrEqual', [squareOf(columns, velocity), graph.constant(MAX_SPEED * MAX_SPEED)]));
  }
  return conditions.reduce((a, b) => graph.make('and', [a, b]));
}

/** Returns whether a body has a radius and a mass, so that walls hold it. */
function isSolid(columns: WorldColumns): Node {
  const { graph, isMovable } = columns;
  return graph.make('and', [isMovable, graph.make('less', [graph.zero, radiusOf(columns, 1)])]);
}

/** The radius of a body times `reach`. */
function radiusOf({ graph, world }: WorldColumns, reach: number): Node {
  const radius = graph.make('real', [], world.addresses.Collider.radius);
  return reach === 1 ? radius : graph.make('mul', [radius, graph.constant(reach)]);
}

function isClosed({ axisNames }: WorldColumns, box: Box): boolean {
  return axisNames.every((axis) => box.low[axis] > -FAR && box.high[axis] < FAR);
}

function endsWithDrift({ axisNames }: WorldColumns, { position, velocity }: Moved): boolean {
  return axisNames.every((_, i) => driftOf(position[i], velocity[i]) !== undefined);
}

/** Returns the duration if a position is another position plus the velocity times a duration. */
function driftOf(position: Node, velocity: Node): Node | undefined {
  if (position.op !== 'add') return undefined;
  const drift = position.args.find(({ op, args }) => op === 'mul' && args.includes(velocity));
  return drift?.args.find((factor) => factor !== velocity);
}

/**
 * Bodies that began the step at rest on a wall and end it beyond stay in place. This is the most frequent case at
 * walls, handled as in kernels/particle-contacts/walls/box.ts, which handles all other cases.
 */
function restingBodies(columns: WorldColumns, start: Moved, result: Result, box: Box): WallTest['resting'] {
  const { graph, axisNames, world } = columns;
  if (box.restitution > REST_RESTITUTION) return undefined;
  const { Collider, Position, Velocity } = world.addresses;
  const [radius, restitution, friction] = [Collider.radius, Collider.restitution, Collider.friction].map((at) =>
    graph.make('real', [], at),
  );
  const and = (nodes: readonly Node[]) => nodes.reduce((a, b) => graph.make('and', [a, b]));
  const sides = axisNames.map((axis, i) => {
    const x = result.position[i];
    const low = graph.make('add', [graph.constant(box.low[axis]), radius]);
    const high = graph.make('sub', [graph.constant(box.high[axis]), radius]);
    // In this order NaN stays NaN, which equals nothing.
    const clamped = graph.make('min', [graph.make('max', [x, low]), high]);
    return { low, high, clamped, isInside: graph.make('equal', [clamped, x]) };
  });
  const conditions = sides.flatMap(({ low, high, clamped, isInside }, i) => {
    const isAtRest = and([graph.make('equal', [start.velocity[i], graph.zero]), isSolid(columns)]);
    const staysAtRest = and([graph.make('equal', [clamped, start.position[i]]), isAtRest]);
    return [graph.make('lessOrEqual', [low, high]), graph.make('or', [isInside, staysAtRest])];
  });
  if (!isClosed(columns, box) || !endsWithDrift(columns, result))
    conditions.push(rangeTest(columns, result, LEAST_WEIGHT));
  const isInelastic = graph.make('lessOrEqual', [restitution, graph.constant(REST_RESTITUTION)]);
  const isFrictionless = box.friction === 0 ? [] : [graph.make('lessOrEqual', [friction, graph.zero])];
  const canRest = and([isInelastic, ...isFrictionless]);
  const stores = sides.flatMap(({ clamped, isInside }, i): Store[] => [
    { address: Position[axisNames[i]], node: clamped },
    { address: Velocity[axisNames[i]], node: graph.make('keep', [isInside, result.velocity[i]]) },
  ]);
  const areInside = and(sides.map(({ isInside }) => isInside));
  return { atRest: and(conditions), canRest: graph.make('or', [areInside, canRest]), stores };
}
