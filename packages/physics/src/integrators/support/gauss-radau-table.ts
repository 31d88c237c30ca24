// The constants of the Gauss-Radau scheme of order 15, and its memory.

import type { RealColumn } from '../../components/define.ts';
import { MOVABLE } from '../../ecs/partial-entities.ts';
import { allocate } from '../../memory/arena.ts';
import { AXES } from '../../memory/axes.ts';
import { realBytes, realColumn } from '../../memory/columns.ts';
import { RADAU_TABLE_BYTES, RadauTableWord as Word } from '../../memory/layouts.gen.ts';
import { allocateRecord } from '../../memory/record.ts';
import { namedResource } from '../../memory/resource.ts';
import type { PhysicsWorld } from '../../world/types.ts';
import { integratorKernels } from './integrator-kernels.ts';

/**
 * The nodes, in steps: 0 and the roots of (P7(x) + P8(x))/(1 + x) with x = 2h - 1, P Legendre's polynomials. The end
 * of the step is not a node but has weights too.
 */
export const NODES = [
  0, 0.05626256053692214, 0.1802406917368924, 0.3526247171131696, 0.5471536263305554, 0.7342101772154105,
  0.8853209468390958, 0.9775206135612875,
];

const TERMS = 7;
const AXIS_COLUMNS = 19;

/** Number of real columns in 3D. */
export const RADAU_COLUMNS = 3 * AXIS_COLUMNS;

/** State kept between sub-steps: suggested length, and last length (0: none). */
export const SUGGESTED = 0;
export const LENGTH = 1;
/**
 * The attempted sub-step: its start within the step, its length, and the length that would have met the tolerance,
 * s.
 */
export const PASSED = 2;
export const STEP = 3;
export const NEXT = 4;
/** Change of the last term by a sweep over the nodes, relative to the largest acceleration. */
export const CHANGE = 5;
/** The number of force evaluations in this step. */
export const EVALUATIONS = 6;
/** The largest acceleration at the nodes, m/s². */
export const LARGEST = 7;
/** The rounding error of b₆ in the attempted sub-step, m/s²; negative: not measured. */
export const NOISE = 8;
/** The number of shortened sub-steps until rounding errors are measured again. */
export const WAIT = 9;
const SCALARS = 10;

/** Columns of an axis, kernels/integrators/radau.ts: b₆, and acceleration, position and velocity at the start. */
export const LAST_TERM = 6;
export const START_ACCELERATION = 14;
export const START_POSITION = 15;
export const START_VELOCITY = 16;

export type Radau = ReturnType<typeof makeRadau>;

export const radauOf = namedResource('Gauss-Radau', makeRadau);

function makeRadau(world: PhysicsWorld) {
  const { precision, rows } = world;
  const { arena } = world.internal;
  const stride = rows * realBytes(precision) + 320;
  const blocks = AXES[world.dimensions].map(() => allocate(arena, AXIS_COLUMNS * stride, 'Gauss-Radau'));
  const constants = (values: readonly number[], what: string) => {
    const [column, address] = realColumn(arena, precision, values.length, what);
    (column as RealColumn).set(values);
    return address;
  };
  const weights = constants([...NODES, 1].flatMap(weightsAt), 'Gauss-Radau weights');
  const reciprocals = constants(NODES.flatMap(reciprocalsAt), 'Gauss-Radau nodes');
  const powers = constants(newtonPolynomials().flat(), 'Gauss-Radau powers');
  const { at: table, words } = allocateRecord(arena, RADAU_TABLE_BYTES, 'Gauss-Radau table');
  const { Position, Velocity, Mass } = world.addresses;
  const { force } = world.scratch.at;
  const three = ({ x, y, z }: { x: number; y: number; z: number }) => [x, y, z];
  const [x, y, z = 0] = blocks;
  words.set(three(Position), Word.positionX);
  words.set(three(Velocity), Word.velocityX);
  words.set(three(force), Word.forceX);
  words.set([x, y, z], Word.blockX);
  words[Word.mass] = Mass.value;
  words[Word.stride] = stride;
  words[Word.axes] = world.dimensions;
  words[Word.weights] = weights;
  words[Word.reciprocals] = reciprocals;
  words[Word.powers] = powers;
  const scalars = new Float64Array(arena.memory.buffer, allocate(arena, 8 * SCALARS, 'Gauss-Radau'), SCALARS);
  return { table, scalars, kernels: integratorKernels(world), blocks, stride, membership: -1, rows: 0 };
}

/** Clears the columns of removed bodies: their old values would keep moving the rows. */
export function clearRemovedBodies(world: PhysicsWorld, radau: Radau): void {
  const { kernels, internal, versions, lastId } = world;
  if (radau.membership === versions.membership) return;
  radau.membership = versions.membership;
  const rows = Math.max(radau.rows, lastId + 1);
  radau.rows = lastId + 1;
  for (const block of radau.blocks) {
    for (let column = 0; column < AXIS_COLUMNS; column++) {
      kernels.zeroMissing(block + column * radau.stride, internal.membersAt, MOVABLE, 0, rows);
    }
  }
}

/**
 * Returns the integrals of 1, h, … h⁷ from 0 to h: double integrals for positions (8 weights), single ones for
 * velocities (8 more).
 */
function weightsAt(h: number): number[] {
  const powers = [h];
  for (let k = 1; k <= TERMS + 1; k++) powers.push(powers[k - 1] * h);
  return [
    ...Array.from({ length: 8 }, (_, k) => powers[k + 1] / ((k + 1) * (k + 2))),
    ...Array.from({ length: 8 }, (_, k) => powers[k] / (k + 1)),
  ];
}

/** Returns 1/(h - h_k) for the earlier nodes, padded to 8. */
function reciprocalsAt(h: number, s: number): number[] {
  return NODES.map((node, k) => (k < s ? 1 / (h - node) : 0));
}

/** Returns in row k the coefficients of h, h², … h⁷ in h (h - h₁) … (h - h_k). */
export function newtonPolynomials(): number[][] {
  const rows: number[][] = [];
  let polynomial = [1];
  for (let k = 0; k < TERMS; k++) {
    rows.push(Array.from({ length: TERMS }, (_, m) => polynomial[m] ?? 0));
    const node = NODES[k + 1];
    polynomial = Array.from({ length: k + 2 }, (_, m) => (polynomial[m - 1] ?? 0) - node * (polynomial[m] ?? 0));
  }
  return rows;
}
