// Warnings about bodies whose parts or columns were changed in a way that is surely not meant.
import { bitOf } from '../components/membership.ts';
import { warnOnce } from '../errors/warn-once.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { firstRow, has, isKinematic } from './first-row.ts';

/** Bodies that lost a part since the last look, by world. */
const cutBodies = new WeakMap<PhysicsWorld, Set<number>>();

/** Notes that a part of a body was despawned. */
export function notePartRemoved(world: PhysicsWorld, body: number): void {
  const cut = cutBodies.get(world);
  if (cut === undefined) cutBodies.set(world, new Set([body]));
  else cut.add(body);
}

/** Called when bodies or components came or went. */
export function warnAboutBodies(world: PhysicsWorld): void {
  warnAboutEmptyCompounds(world);
  findKinematic(world);
  warnAboutValuesOfParts(world);
  warnAboutFarGround(world);
}

/** Farther than this, m, neighbouring numbers of f32 are 1 mm apart: a fifth of what contacts overlap, and a quarter of what 1 m/s is a sub-step. */
const FAR = 2 ** 13;

/** Warns about ground that is too far off for f32. What moves may fall so far, and is not meant. */
function warnAboutFarGround(world: PhysicsWorld): void {
  if (world.precision !== 'f32' || world.integrator.solvesWalls !== true) return;
  const { Mass, Position, Collider } = world.components;
  const isFar = (id: number) => Math.max(Math.abs(Position.x[id]), Math.abs(Position.y[id])) > FAR;
  const ground = firstRow(world, (id) => Collider.radius[id] > 0 && !(Mass.value[id] > 0) && isFar(id));
  if (ground === 0) return;
  const warning = {
    message: `body ${ground} is at (${Position.x[ground]}, ${Position.y[ground]}) m, where numbers of f32 are 1 mm apart or more: what is slow stands still there, joints open, and stacks do not fall asleep.`,
    hint: "Make the world with `precision: 'f64'`, or keep what is played within 8 km of the origin.",
  };
  warnOnce(world, warning, 'far ground');
}

/** What acts on the body of a part, or says how it may move. */
const OF_BODIES = [
  ...(['Hull', 'Charge', 'LinearDrag', 'QuadraticDrag', 'AngularDrag', 'Lift', 'Thrust', 'Motor', 'Engine'] as const),
  ...(['GravityScale', 'MotionLocks', 'NeverSleep', 'Kinematic'] as const),
];

/** Warns about what a part has and its body should have. */
function warnAboutValuesOfParts(world: PhysicsWorld): void {
  const { counts } = world.internal;
  const names = OF_BODIES.filter((each) => counts[each] > 0);
  if (counts.Attachment === 0 || names.length === 0) return;
  const ofBodies = (id: number) => names.find((each) => has(world, id, each));
  const part = firstRow(world, (id) => has(world, id, 'Attachment') && ofBodies(id) !== undefined);
  if (part === 0) return;
  const name = ofBodies(part);
  const body = world.components.Attachment.body[part];
  const warning = {
    message: `the ${name} of part ${part} has no effect, because forces act on compound bodies and not on their parts.`,
    hint:
      name === 'Hull'
        ? `Give one to its body, ${body}: spawnCompound(world, { hull: { volume, halfHeight }, parts }).`
        : `Give it to its body, ${body}, as by spawnCompound(world, { parts, … }).`,
  };
  warnOnce(world, warning, 'values of a part');
}

/** Warns about an impulse on a body that none can move. */
export function warnAboutImpulse(world: PhysicsWorld, body: number): void {
  const isDriven = isKinematic(world, body);
  const warning = {
    message: `an impulse was applied to body ${body}, which ${isDriven ? 'is kinematic' : 'has no mass'} and is not moved by it.`,
    hint: isDriven
      ? 'Write its Velocity, or remove Kinematic.'
      : 'Give it a mass, as by `collider: { density: 100 }`; to hit only what moves, ask for Mass.value[id] > 0.',
  };
  warnOnce(world, warning, 'impulse without effect');
}

/** Warns about a body that is moved as a pin, and that forces, springs and contacts move as well. */
export function warnAboutFreePin(world: PhysicsWorld, body: number): void {
  const mass = world.components.Mass.value[body];
  if (!(mass > 0 && mass < Infinity) || isKinematic(world, body)) return;
  const warning = {
    message: `movePin gave body ${body} a velocity, but it is not pinned: forces, springs and contacts change that velocity.`,
    hint: 'Call pin(world, node) once before, or give the body `kinematic: {}`.',
  };
  warnOnce(world, warning, 'pin that is free');
}

/** Warns about the id of a body in the place of a reference, which no reference is. */
export function warnAboutDeadRef(world: PhysicsWorld, ref: number): void {
  if (!(ref <= world.capacity) || (world.internal.members[ref] & bitOf('Position')) === 0) return;
  const warning = {
    message: `isAlive got ${ref}, which is the id of a body, and not a reference of this world.`,
    hint: 'Keep entityRef(world, id) and pass that; of an id ask isBody(world, id).',
  };
  warnOnce(world, warning, 'isAlive of an id');
}

/** A body of velocity 0 that is in another place after each of so many steps is moved by hand. */
const STEPS_BY_HAND = 20;

/** So many bodies are watched. */
const MAX_WATCHED = 64;

interface Watched {
  readonly id: number;
  x: number;
  y: number;
  steps: number;
}

const watched = new WeakMap<PhysicsWorld, readonly Watched[]>();

/** Finds the bodies without mass or with Kinematic that others may rest on, and that have a velocity. */
function findKinematic(world: PhysicsWorld): void {
  if (world.integrator.solvesWalls !== true) return;
  const { members } = world.internal;
  const { Collider, Mass, Position } = world.components;
  const solid = bitOf('Position') | bitOf('Velocity') | bitOf('Collider');
  const found: Watched[] = [];
  firstRow(world, (id) => {
    if ((members[id] & solid) !== solid || Collider.sensor[id] !== 0) return false;
    if (Mass.value[id] > 0 && !isKinematic(world, id)) return false;
    return found.push({ id, x: Position.x[id], y: Position.y[id], steps: 0 }) === MAX_WATCHED;
  });
  watched.set(world, found);
}

/** Called after each step. */
export function warnAboutMotionByHand(world: PhysicsWorld): void {
  const bodies = watched.get(world);
  if (bodies === undefined || bodies.length === 0) return;
  const { Position, Velocity } = world.components;
  for (const body of bodies) {
    const { id } = body;
    const [x, y] = [Position.x[id], Position.y[id]];
    const isMoved = (x !== body.x || y !== body.y) && Velocity.x[id] === 0 && Velocity.y[id] === 0;
    body.steps = isMoved ? body.steps + 1 : 0;
    body.x = x;
    body.y = y;
    if (body.steps < STEPS_BY_HAND) continue;
    const warning = {
      message: `body ${id} has no velocity and its Position is written before each step: what lies on it stays behind, and what it hits gets no speed from it.`,
      hint: 'Write its Velocity, (target - position) / dt, and the step moves it.',
    };
    warnOnce(world, warning, 'moved by hand');
    watched.delete(world);
    return;
  }
}

function warnAboutEmptyCompounds(world: PhysicsWorld): void {
  const cut = cutBodies.get(world);
  if (cut === undefined) return;
  cutBodies.delete(world);
  const { members } = world.internal;
  const { Attachment, Mass } = world.components;
  const [position, shown] = [bitOf('Position'), bitOf('Collider')];
  const isBare = (id: number) => (members[id] & (position | shown)) === position && Mass.value[id] > 0;
  const bare = new Set([...cut].filter(isBare));
  if (bare.size === 0) return;
  firstRow(world, (id) => {
    if ((members[id] & bitOf('Attachment')) !== 0) bare.delete(Attachment.body[id]);
    return false;
  });
  const [empty] = bare;
  if (empty === undefined) return;
  const warning = {
    message: `body ${empty} has lost the last of its parts, and moves on as a body that meets nothing.`,
    hint: 'Despawn it as well, with the last part: partsOf(world, body) lists those that are left.',
  };
  warnOnce(world, warning, 'no parts');
}

export function warnAboutInertiaTensors(world: PhysicsWorld): void {
  const { InertiaTensor, Orientation, AngularVelocity } = world.internal.counts;
  if (InertiaTensor <= Math.min(Orientation, AngularVelocity)) return;
  warnOnce(world, {
    message: 'some bodies have an InertiaTensor and do not rotate, because they lack Orientation or AngularVelocity.',
    hint: 'Spawn them with `orientation: {}` and `angularVelocity: {}` as well.',
  });
}
