// Bodies that become one where they touch, as drops and planetesimals do: perfectly inelastic.
//
//   m = m₁ + m₂      r = (m₁ r₁ + m₂ r₂)/m      v = (m₁ v₁ + m₂ v₂)/m      R³ = R₁³ + R₂³  (R² in the plane)
//
// Mass, momentum, centre of mass and volume (area in 2D) are conserved; of the kinetic energy, μ (v₁ - v₂)²/2 becomes
// heat, with μ = m₁ m₂/m, and of the potential energy what the two had between them. The heavier body remains, the one
// with the lower id between equals; the other is despawned when the step ends. Where the one that remains can spin
// (Inertia and AngularVelocity), it takes up the angular momentum of the two about their centre, and its inertia grows
// as m R². Colour, charge and other components of the one that goes are lost.
//
// Valid where bodies hit at less than about their escape speed (Leinhardt & Stewart, ApJ 745, 79, 2012). Bodies are
// looked at where they are when the step ends. Cost: the broad phase, and 1 µs a merger.

import { despawn } from '../bodies/spawn.ts';
import { bitOf } from '../components/all.ts';
import { pow } from '../math/elementary.ts';
import { AXES } from '../memory/axes.ts';
import { ContactTableWord as Word } from '../memory/layouts.gen.ts';
import { resource } from '../memory/resource.ts';
import { activateContacts, contactTable } from '../particle-contacts/contact-table.ts';
import { collisionKernels } from '../particle-contacts/kernels.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** What has merged in a world. */
export interface Mergers {
  /** Since the world was made. */
  readonly total: number;
  /** In the last step. */
  readonly lastStep: number;
}

interface State {
  total: number;
  lastStep: number;
  /** The body each row became part of in this step; 0 where it is still itself. */
  readonly into: Uint32Array;
  readonly gone: number[];
}

const stateOf = resource((world): State => {
  activateContacts(world);
  return { total: 0, lastStep: 0, into: new Uint32Array(world.rows), gone: [] };
});

/** How many bodies have merged. */
export function mergers(world: PhysicsWorld): Mergers {
  return stateOf(world);
}

/** System of the `collide` phase: bodies with Mass whose colliders overlap become one. */
export function mergeOnContact(world: PhysicsWorld): void {
  const state = stateOf(world);
  const { into, gone } = state;
  const { words } = findPairs(world);
  const count = words[Word.count];
  const pairs = new Uint32Array(world.memory.buffer);
  for (let c = 0; c < count; c++) {
    const a = remaining(into, pairs[words[Word.a] / 4 + c]);
    const b = remaining(into, pairs[words[Word.b] / 4 + c]);
    if (a === b || !isFree(world, a) || !isFree(world, b) || !overlap(world, a, b)) continue;
    merge(world, state, a, b);
  }
  state.lastStep = gone.length;
  state.total += gone.length;
  for (let g = 0; g < gone.length; g++) {
    into[gone[g]] = 0;
    despawn(world, gone[g]);
  }
  gone.length = 0;
}

function findPairs(world: PhysicsWorld) {
  const kernels = collisionKernels(world);
  const { internal, lastId } = world;
  kernels.beginContacts();
  kernels.findPairs(internal.sweptRows, internal.bodyList.count, world.dimensions);
  kernels.sortContacts(lastId);
  return contactTable(world);
}

/** The body that `row` is part of by now. */
function remaining(into: Uint32Array, row: number): number {
  let body = row;
  while (into[body] !== 0) body = into[body];
  return body;
}

/** Bodies that nothing moves do not merge: they are walls. */
function isFree({ internal, components }: PhysicsWorld, row: number): boolean {
  const wanted = bitOf('Position') | bitOf('Velocity') | bitOf('Mass') | bitOf('Collider');
  return (internal.members[row] & wanted) === wanted && components.Mass.value[row] > 0;
}

function overlap({ components }: PhysicsWorld, a: number, b: number): boolean {
  const { Position: p, Collider } = components;
  const [dx, dy, dz] = [p.x[b] - p.x[a], p.y[b] - p.y[a], p.z[b] - p.z[a]];
  const reach = Collider.radius[a] + Collider.radius[b];
  return dx * dx + dy * dy + dz * dz < reach * reach;
}

function merge(world: PhysicsWorld, state: State, a: number, b: number): void {
  const { Mass, Position, Velocity, Collider } = world.components;
  const aStays = Mass.value[a] > Mass.value[b] || (Mass.value[a] === Mass.value[b] && a < b);
  const [stays, goes] = aStays ? [a, b] : [b, a];
  const [m1, m2] = [Mass.value[stays], Mass.value[goes]];
  const mass = m1 + m2;
  const radius = radiusOf(world.dimensions, Collider.radius[stays], Collider.radius[goes]);
  addSpin(world, stays, goes, (mass * radius * radius) / (m1 * Collider.radius[stays] * Collider.radius[stays]));
  for (const axis of AXES[world.dimensions]) {
    const [x, v] = [Position[axis], Velocity[axis]];
    x[stays] += (m2 / mass) * (x[goes] - x[stays]);
    v[stays] += (m2 / mass) * (v[goes] - v[stays]);
  }
  Mass.value[stays] = mass;
  Collider.radius[stays] = radius;
  // Until the step ends the other one is there without mass, and nothing acts on it.
  Mass.value[goes] = 0;
  state.into[goes] = stays;
  state.gone.push(goes);
  world.versions.style++;
}

function radiusOf(dimensions: 2 | 3, a: number, b: number): number {
  return dimensions === 2 ? Math.sqrt(a * a + b * b) : pow(a * a * a + b * b * b, 1 / 3);
}

/** L = I₁ ω₁ + I₂ ω₂ + μ d × u about the centre of the two. */
function addSpin(world: PhysicsWorld, stays: number, goes: number, growth: number): void {
  const { Mass, Position: p, Velocity: v, Inertia, AngularVelocity: w } = world.components;
  const inertia = Inertia.value[stays] * growth;
  const spins = (world.internal.members[stays] & bitOf('AngularVelocity')) !== 0;
  if (!spins || inertia === 0) return;
  const [m1, m2] = [Mass.value[stays], Mass.value[goes]];
  const reduced = (m1 * m2) / (m1 + m2);
  const between = (c: { x: ArrayLike<number>; y: ArrayLike<number>; z: ArrayLike<number> }) =>
    [c.x[goes] - c.x[stays], c.y[goes] - c.y[stays], c.z[goes] - c.z[stays]] as const;
  const [dx, dy, dz] = between(p);
  const [ux, uy, uz] = between(v);
  const orbital = { x: dy * uz - dz * uy, y: dz * ux - dx * uz, z: dx * uy - dy * ux };
  for (const axis of AXES[3]) {
    const own = Inertia.value[stays] * w[axis][stays] + Inertia.value[goes] * w[axis][goes];
    w[axis][stays] = (own + reduced * orbital[axis]) / inertia;
  }
  Inertia.value[stays] = inertia;
}
