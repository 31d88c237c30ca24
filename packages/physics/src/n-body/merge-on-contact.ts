// Merges bodies where they touch, as drops and planetesimals do: a perfectly inelastic collision.
//
//   m = m₁ + m₂      r = (m₁ r₁ + m₂ r₂)/m      v = (m₁ v₁ + m₂ v₂)/m      R³ = R₁³ + R₂³  (R² in 2D)
//
// Mass, momentum, centre of mass and volume (area in 2D) are conserved; the kinetic energy μ (v₁ - v₂)²/2, with μ = m₁
// m₂/m, becomes heat, and the mutual potential energy is lost. The heavier body survives, the one with the lower id if
// equal; the other is despawned at the end of the step. If the survivor can rotate (Inertia and AngularVelocity), it
// takes the angular momentum of both about their common centre, and its inertia becomes proportional to m R²; otherwise that
// is lost. If it has a Charge it takes that of the other, too. Colour and other components of the absorbed body are lost.
//
// Among rigid bodies discs merge, as long as they are neither sensors nor kinematic: what is round has one shape after a
// merger, and of other shapes the broad phase knows the circle around them alone.
//
// Valid for impact speeds below about the escape speed (Leinhardt & Stewart, ApJ 745, 79, 2012). Overlaps are found at
// the end of the step; after `collideBodies`, which parts bodies, its contacts of the step merge. Cost: the broad phase,
// and 1 µs per merger.

import { despawn } from '../bodies/spawn.ts';
import { bitOf } from '../components/membership.ts';
import { isOpen } from '../ecs/rows.ts';
import { pow } from '../math/elementary.ts';
import { AXES } from '../memory/axes.ts';
import { ContactTableWord as Word } from '../memory/layouts.gen.ts';
import { namedResource } from '../memory/resource.ts';
import { activateContacts, contactTable } from '../particle-contacts/contact-table.ts';
import { collisionKernels } from '../particle-contacts/kernels.ts';
import { isSoftStep } from '../world/is-soft-step.ts';
import { nameSystem } from '../world/name-system.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Counts of mergers in a world. */
export interface Mergers {
  /** Mergers since the world was created. */
  readonly total: number;
  /** Mergers in the last step. */
  readonly lastStep: number;
}

interface State {
  total: number;
  lastStep: number;
  /** The body that absorbed each row in this step; 0 for rows that were not absorbed. */
  readonly into: Uint32Array;
  readonly absorbedIds: number[];
}

const stateOf = namedResource('mergers', (world): State => {
  activateContacts(world);
  return { total: 0, lastStep: 0, into: new Uint32Array(world.rows), absorbedIds: [] };
});

/** Returns the number of mergers. */
export function mergers(world: PhysicsWorld): Mergers {
  return stateOf(world);
}

/** System of the `collide` phase, before or after `collideBodies`: merges bodies with Mass whose colliders touch, of rigid bodies discs alone. */
export const mergeOnContact = /* @__PURE__ */ nameSystem('merge on contact', (world: PhysicsWorld) => {
  const state = stateOf(world);
  const { into, absorbedIds } = state;
  const table = contactTable(world);
  const { isResolved, words } = table;
  const isRigid = isSoftStep(world.integrator);
  if (!isResolved) findPairs(world);
  table.isResolved = false;
  const count = words[Word.count];
  const pairs = new Uint32Array(world.memory.buffer);
  for (let c = 0; c < count; c++) {
    const a = remaining(into, pairs[words[Word.a] / 4 + c]);
    const b = remaining(into, pairs[words[Word.b] / 4 + c]);
    if (a === b || !isFree(world, a) || !isFree(world, b)) continue;
    if (isRigid && !(isMergingDisc(world, a) && isMergingDisc(world, b))) continue;
    if (isResolved || overlap(world, a, b)) merge(world, state, a, b);
  }
  state.lastStep = absorbedIds.length;
  state.total += absorbedIds.length;
  for (let g = 0; g < absorbedIds.length; g++) {
    into[absorbedIds[g]] = 0;
    despawn(world, absorbedIds[g]);
  }
  absorbedIds.length = 0;
});

function findPairs(world: PhysicsWorld): void {
  const kernels = collisionKernels(world);
  const { internal, lastId } = world;
  kernels.beginContacts();
  kernels.findPairs(internal.sweptRows, world.dimensions);
  kernels.sortContacts(lastId);
}

/** Returns the body that `row` is part of. */
function remaining(into: Uint32Array, row: number): number {
  let body = row;
  while (into[body] !== 0) body = into[body];
  return body;
}

/** Immovable bodies do not merge: they act as walls. */
function isFree({ internal, components }: PhysicsWorld, row: number): boolean {
  const required = bitOf('Position') | bitOf('Velocity') | bitOf('Mass') | bitOf('Collider');
  return (internal.members[row] & required) === required && components.Mass.value[row] > 0;
}

/** Sensors touch nothing, and kinematic bodies go on whatever they meet. */
function isMergingDisc(world: PhysicsWorld, row: number): boolean {
  const { sensor, shape } = world.components.Collider;
  return sensor[row] === 0 && shape[row] === 0 && !isOpen(world, row, 'Kinematic');
}

function overlap({ components }: PhysicsWorld, a: number, b: number): boolean {
  const { Position: p, Collider } = components;
  const [dx, dy, dz] = [p.x[b] - p.x[a], p.y[b] - p.y[a], p.z[b] - p.z[a]];
  const reach = Collider.radius[a] + Collider.radius[b];
  return dx * dx + dy * dy + dz * dz < reach * reach;
}

function merge(world: PhysicsWorld, state: State, a: number, b: number): void {
  const { Mass, Position, Velocity, Collider, Charge } = world.components;
  const aStays = Mass.value[a] > Mass.value[b] || (Mass.value[a] === Mass.value[b] && a < b);
  const [survivor, absorbed] = aStays ? [a, b] : [b, a];
  const [m1, m2] = [Mass.value[survivor], Mass.value[absorbed]];
  const mass = m1 + m2;
  const radius = radiusOf(world.dimensions, Collider.radius[survivor], Collider.radius[absorbed]);
  addSpin(
    world,
    survivor,
    absorbed,
    (mass * radius * radius) / (m1 * Collider.radius[survivor] * Collider.radius[survivor]),
  );
  for (const axis of AXES[world.dimensions]) {
    const [x, v] = [Position[axis], Velocity[axis]];
    x[survivor] += (m2 / mass) * (x[absorbed] - x[survivor]);
    v[survivor] += (m2 / mass) * (v[absorbed] - v[survivor]);
  }
  Mass.value[survivor] = mass;
  if (isOpen(world, survivor, 'Charge')) Charge.value[survivor] += Charge.value[absorbed];
  Collider.radius[survivor] = radius;
  // Until the end of the step the absorbed body exists without mass or size: no force acts on it, and nothing touches it.
  Mass.value[absorbed] = 0;
  Collider.radius[absorbed] = 0;
  state.into[absorbed] = survivor;
  state.absorbedIds.push(absorbed);
  world.versions.style++;
}

function radiusOf(dimensions: 2 | 3, a: number, b: number): number {
  return dimensions === 2 ? Math.sqrt(a * a + b * b) : pow(a * a * a + b * b * b, 1 / 3);
}

/** L = I₁ ω₁ + I₂ ω₂ + μ d × u about the common centre. */
function addSpin(world: PhysicsWorld, survivor: number, absorbed: number, growth: number): void {
  const { Mass, Position: p, Velocity: v, Inertia, AngularVelocity: w } = world.components;
  const inertia = Inertia.value[survivor] * growth;
  const spins = (world.internal.members[survivor] & bitOf('AngularVelocity')) !== 0;
  if (!spins || inertia === 0) return;
  const [m1, m2] = [Mass.value[survivor], Mass.value[absorbed]];
  const reduced = (m1 * m2) / (m1 + m2);
  const between = (c: { x: ArrayLike<number>; y: ArrayLike<number>; z: ArrayLike<number> }) =>
    [c.x[absorbed] - c.x[survivor], c.y[absorbed] - c.y[survivor], c.z[absorbed] - c.z[survivor]] as const;
  const [dx, dy, dz] = between(p);
  const [ux, uy, uz] = between(v);
  const orbital = { x: dy * uz - dz * uy, y: dz * ux - dx * uz, z: dx * uy - dy * ux };
  for (const axis of AXES[3]) {
    const spin = Inertia.value[survivor] * w[axis][survivor] + Inertia.value[absorbed] * w[axis][absorbed];
    w[axis][survivor] = (spin + reduced * orbital[axis]) / inertia;
  }
  Inertia.value[survivor] = inertia;
}
