// Warnings about valid input that is probably a mistake. Each is given once per world. The export condition
// `production` replaces this file by `no-warnings.ts`.
import type { ComponentName } from '../components/all.ts';
import { bitOf } from '../components/membership.ts';
import { warnOnce } from '../errors/warn-once.ts';
import type { PhysicsWorld, Plan, Warning } from '../world/types.ts';
import { warnAboutBodies, warnAboutInertiaTensors, warnAboutMotionByHand } from './body-warnings.ts';
import { firstRow } from './first-row.ts';
import { warnAboutFluids } from './fluid-warnings.ts';
import { constantsOf } from './force-parameters.ts';
import { warnAboutForces } from './force-warnings.ts';
import { warnAboutCrossedLimits, warnAboutJoints, warnAboutStrayFields } from './joint-warnings.ts';
import { warnAboutPotentials } from './potential-warnings.ts';
import { warnAboutSchemes } from './scheme-warnings.ts';
import { warnAboutSprings } from './spring-warnings.ts';

export { notePartRemoved, warnAboutDeadRef, warnAboutFreePin, warnAboutImpulse } from './body-warnings.ts';
export { warnAboutJoint } from './joint-warnings.ts';

/** The default of `world.onWarning`. */
export function printWarning({ message, hint }: Warning): void {
  globalThis.console?.warn(`Principia: ${message} ${hint}`);
}

/** Durations in this range are more often milliseconds of a frame than seconds, s. */
const FRAME_MILLISECONDS = { min: 5, max: 50 };

/** Warns if a duration looks like the milliseconds of a frame. */
export function warnAboutDuration(world: PhysicsWorld, seconds: number, what: string): void {
  if (seconds < FRAME_MILLISECONDS.min || seconds > FRAME_MILLISECONDS.max) return;
  const warning = {
    message: `${what} got ${seconds}, which looks like milliseconds; times are in seconds.`,
    hint: `A frame of ${seconds} ms lasts ${Number((seconds / 1000).toPrecision(6))} s. Set \`world.onWarning\` if the step is meant to be that long.`,
  };
  // Frames differ in length, and each would be another message.
  warnOnce(world, warning, `${what}: milliseconds`);
}

/** Warns if someone reads the contacts with walls of a world that notes none. */
export function warnAboutWallContacts(world: PhysicsWorld): void {
  warnOnce(world, {
    message: 'wallContacts(world) stays empty, because no system of this world notes contacts with walls.',
    hint: contactsHint(world),
  });
}

/** Where a world that has no contacts of particles has contacts. */
function contactsHint({ integrator }: PhysicsWorld): string {
  return integrator.solvesWalls === true
    ? 'A world of rigid bodies lists its contacts: contactEvents(world).'
    : 'Create the world with `preset: particleContacts`.';
}

/** Warns about the first fault of a world that neither handles faults nor throws them: its log is easily overlooked. */
export function warnAboutFaults(world: PhysicsWorld, isHandled: boolean): void {
  const [fault] = world.internal.stepFaults;
  if (fault === undefined || isHandled || world.onFault === 'throw') return;
  const { code, entity, field, value, hint = '' } = fault;
  const warning = {
    message: `${code}: ${field} of entity ${entity} was ${value}, and was dealt with as a fault; \`world.faults\` lists this and all others.`,
    hint: `${hint} \`on(world, 'fault', handler)\` tells you of each.`.trim(),
  };
  warnOnce(world, warning, 'fault');
}

/** Warns if a colour given for a body is invisible: the web writes 0xRRGGBB, and such a number has no alpha here. */
export function warnAboutColor(world: PhysicsWorld, color: unknown): void {
  if (typeof color !== 'number' || color <= 1 || color > 0xffffff) return;
  const warning = {
    message: `the colour 0x${color.toString(16).padStart(6, '0')} is invisible: its alpha, the highest of the bytes 0xAABBGGRR, is 0.`,
    hint: 'Give colours as rgba(1, 0.5, 0), from 0 to 1.',
  };
  warnOnce(world, warning, 'alpha 0');
}

/**
 * Warns about components, handlers and forces that had no effect in the step that has just ended, and about bodies that it
 * cannot follow.
 * @param ignoredEvents events that have handlers and that no system dispatches
 */
export function warnAboutWorld(world: PhysicsWorld, plan: Plan, dt: number, ignoredEvents: readonly string[]): void {
  warnAboutWalls(world, plan);
  warnAboutFlatComponents(world);
  for (const event of ignoredEvents) {
    warnOnce(world, {
      message: `a handler of "${event}" is never called, because no system of this world dispatches this event.`,
      hint: contactsHint(world),
    });
  }
  warnAboutUnreadComponents(world);
  warnAboutStrayValues(world);
  warnAboutInertiaTensors(world);
  warnAboutForces(world, dt);
  warnAboutFluids(world, plan, dt);
  warnAboutSchemes(world, dt);
  warnAboutPotentials(world);
  warnAboutSprings(world, dt);
  warnAboutShapes(world, plan);
  warnAboutMergers(world, plan);
  warnAboutMissingPositions(world);
  warnAboutSurfaces(world, plan);
  warnAboutRigidSurfaces(world, plan);
  warnAboutBodiesThatStandStill(world);
  warnAboutBodiesThatDoNotTurn(world);
  warnAboutSmallBodies(world, dt);
  warnAboutBodies(world);
  warnAboutJoints(world);
}

/** Columns of joints are looked at once in so many steps: no change of them is announced. */
const STEPS_BETWEEN = 32;

/** Warns about what is written to columns between steps and does not do what it is meant to. */
export function warnAboutColumns(world: PhysicsWorld): void {
  warnAboutMotionByHand(world);
  if (world.internal.counts.Joint === 0 || world.tick % STEPS_BETWEEN !== 0) return;
  warnAboutStrayFields(world);
  warnAboutCrossedLimits(world);
}

function warnAboutWalls(world: PhysicsWorld, plan: Plan): void {
  if (world.integrator.solvesWalls === true) return;
  const walls = [
    ['SegmentWall', 'segment walls'],
    ['PlaneWall', 'plane walls'],
  ] as const;
  for (const [component, system] of walls) {
    const isRun = plan.systems.walls.some(({ name }) => name === system);
    if (isRun || world.internal.counts[component] === 0) continue;
    const collides = plan.systems.collide.some(({ name }) => name === 'collide bodies');
    warnOnce(world, {
      message: `bodies pass through every ${component}, because no system of this world runs them.`,
      hint: collides
        ? `Put "${system}" back into \`world.phases.walls\`: replaceBoxWalls leaves it there.`
        : 'Create the world with `preset: particleContacts`.',
    });
  }
}

/** What only worlds of two dimensions have, and what takes its place in three. */
const FLAT = [
  ['SegmentWall', 'Use `planeWall` or boxWalls({ … }).'],
  ['Rotation', 'Spawn bodies with `orientation: {}`.'],
] as const;

function warnAboutFlatComponents(world: PhysicsWorld): void {
  if (world.dimensions === 2) return;
  const { counts } = world.internal;
  for (const [component, hint] of FLAT) {
    const message = `${component} has no effect, because this world has three dimensions.`;
    if (counts[component] > 0) warnOnce(world, { message, hint });
  }
  if (counts.AngularVelocity > 0) warnAboutMissingOrientations(world);
}

/** A ball may spin without an orientation for what touches it, or for a force that reads its spin. */
function warnAboutMissingOrientations(world: PhysicsWorld): void {
  if (world.forces.some(({ reads }) => reads.includes('AngularVelocity'))) return;
  const { x, y, z } = world.components.AngularVelocity;
  const { members } = world.internal;
  const seen = bitOf('Orientation') | bitOf('Collider');
  const body = firstRow(world, (id) => (members[id] & seen) === 0 && (x[id] !== 0 || y[id] !== 0 || z[id] !== 0));
  if (body === 0) return;
  const warning = {
    message: `body ${body} has an angular velocity and does not turn, because it has no Orientation.`,
    hint: 'Spawn bodies with `orientation: {}`.',
  };
  warnOnce(world, warning, 'no Orientation');
}

/** Components that only forces read, and a factory of such a force. */
const READ_BY_FORCES: Partial<Record<ComponentName, string>> = {
  LinearDrag: 'linearDrag()',
  QuadraticDrag: 'quadraticDrag()',
  AngularDrag: 'angularDrag()',
  GravityScale: 'uniformGravity()',
  Lift: 'lift()',
  Hull: 'buoyancy({ … })',
  Thrust: 'thrust()',
  Motor: 'motors()',
  Engine: 'rocketEngines()',
  Charge: 'magneticField({ … }) or mutualCoulomb()',
};

function warnAboutUnreadComponents(world: PhysicsWorld): void {
  const read = new Set([...world.forces.flatMap(({ reads }) => reads), ...(world.integrator.reads ?? [])]);
  for (const [component, factory] of Object.entries(READ_BY_FORCES) as [ComponentName, string][]) {
    if (world.internal.counts[component] === 0 || read.has(component)) continue;
    warnOnce(world, {
      message: `${component} has no effect, because no force of this world reads it.`,
      hint: `Add ${factory} to \`forces\`.`,
    });
  }
}

/** Components that are asked for before their columns are read: a value in the row of a body without them does nothing. */
const ASKED_FOR = ['GravityScale', 'MotionLocks'] as const;

/** Finds what was written before the first step, or before bodies came or changed. */
function warnAboutStrayValues(world: PhysicsWorld): void {
  const { members } = world.internal;
  for (const name of ASKED_FOR) {
    const bit = bitOf(name);
    for (const [field, column] of Object.entries<{ [row: number]: number }>(world.components[name])) {
      const stray = firstRow(world, (id) => column[id] !== 0 && (members[id] & bit) === 0);
      if (stray === 0) continue;
      const warning = {
        message: `${name}.${field} of body ${stray} is ${column[stray]} and has no effect, because the body does not have ${name}.`,
        hint: `Add it: addComponent(world, id, set(world.components.${name}, { ${field}: ${column[stray]} })).`,
      };
      warnOnce(world, warning, `${name} without the component`);
    }
  }
}

/** What falls is meant to land on a box, and a box to meet others as a box. */
function warnAboutShapes(world: PhysicsWorld, { systems }: Plan): void {
  if (world.integrator.solvesWalls === true || world.internal.counts.Collider < 2) return;
  const { Collider, Mass } = world.components;
  const meets = (id: number) => Collider.radius[id] > 0 && Collider.mask[id] !== 0 && Collider.sensor[id] === 0;
  const collides = systems.collide.some(({ name }) => name === 'collide bodies');
  // Circles have no shape of their own.
  const shaped = firstRow(world, (id) => meets(id) && Collider.shape[id] > 0 && (collides || !(Mass.value[id] > 0)));
  const moving = collides || shaped === 0 ? 0 : firstRow(world, (id) => meets(id) && Mass.value[id] > 0);
  if (shaped === 0 || !(collides || moving > 0)) return;
  const radius = Number(Collider.radius[shaped].toPrecision(3));
  const warning = {
    message: collides
      ? `body ${shaped} meets others as a disc of ${radius} m, the circle around its shape, because the contacts of this world know discs only.`
      : `body ${moving} passes through body ${shaped}, because no system of this world knows shapes.`,
    hint: 'Create the world with `preset: rigidBodies`.',
  };
  warnOnce(world, warning, 'shapes');
}

/** Among rigid bodies only discs merge. */
function warnAboutMergers(world: PhysicsWorld, { systems }: Plan): void {
  if (world.integrator.solvesWalls !== true) return;
  if (!systems.collide.some((system) => 'systemName' in system && system.systemName === 'merge on contact')) return;
  const { Collider, Mass } = world.components;
  const shaped = firstRow(world, (id) => Mass.value[id] > 0 && Collider.shape[id] > 0 && Collider.sensor[id] === 0);
  if (shaped === 0) return;
  const warning = {
    message: `body ${shaped} never merges, because mergeOnContact merges discs only, and it has another shape.`,
    hint: 'Give it a collider without `shape` if it is to merge.',
  };
  warnOnce(world, warning, 'shapes that merge');
}

/** Who says how a body bounces and rubs means it to touch something. */
function warnAboutSurfaces(world: PhysicsWorld, { systems }: Plan): void {
  if (world.integrator.solvesWalls === true || systems.walls.length + systems.collide.length > 0) return;
  if (world.internal.counts.Collider === 0 || world.forces.some(({ reads }) => reads.includes('Collider'))) return;
  const { restitution, friction } = world.components.Collider;
  const touching = firstRow(world, (id) => restitution[id] > 0 || friction[id] > 0);
  if (touching === 0) return;
  const warning = {
    message: `body ${touching} has restitution or friction and passes through everything, because no system of this world runs contacts or walls.`,
    hint: 'Create the world with `preset: particleContacts` or `preset: rigidBodies`, or with `walls`.',
  };
  warnOnce(world, warning, 'surfaces');
}

/** Fields of Collider that only rigid bodies have. */
const RIGID_SURFACES = [
  'sensor',
  'bullet',
  'oneWay',
  'group',
  'rollingResistance',
  'tangentSpeed',
  'frictionCombine',
  'restitutionCombine',
] as const;

function warnAboutRigidSurfaces(world: PhysicsWorld, { systems }: Plan): void {
  if (world.integrator.solvesWalls === true || systems.collide.length === 0) return;
  for (const field of RIGID_SURFACES) {
    const column: ArrayLike<number> = world.components.Collider[field];
    const body = firstRow(world, (id) => column[id] !== 0);
    if (body === 0) continue;
    const warning = {
      message: `body ${body} has \`collider.${field}\`, which has no effect: only rigid bodies have it.`,
      hint: 'Create the world with `preset: rigidBodies`.',
    };
    warnOnce(world, warning, field);
  }
}

/** Nothing that moves or collides is without a place. */
function warnAboutMissingPositions(world: PhysicsWorld): void {
  const { members } = world.internal;
  const [position, bodily] = [bitOf('Position'), bitOf('Mass') | bitOf('Velocity') | bitOf('Collider')];
  const lost = firstRow(world, (id) => (members[id] & bodily) !== 0 && (members[id] & position) === 0);
  if (lost === 0) return;
  const warning = {
    message: `entity ${lost} has Mass, Velocity or Collider and no Position, so that nothing moves or meets it.`,
    hint: 'Spawn it with `position: {}`, which is the origin.',
  };
  warnOnce(world, warning, 'no Position');
}

/** A static body does not fall because it gets a mass. */
function warnAboutBodiesThatStandStill(world: PhysicsWorld): void {
  if (world.integrator.solvesWalls !== true) return;
  const { members } = world.internal;
  const { Mass } = world.components;
  const [body, velocity] = [bitOf('Position') | bitOf('Collider'), bitOf('Velocity')];
  const still = firstRow(world, (id) => (members[id] & (body | velocity)) === body && Mass.value[id] > 0);
  if (still === 0) return;
  const warning = {
    message: `body ${still} has a mass and stands still, because it has no Velocity.`,
    hint: 'A body that is to move has Mass, Inertia, Velocity and AngularVelocity: addComponents adds what is missing.',
  };
  warnOnce(world, warning, 'no Velocity');
}

/** Friction is meant to roll a disc. A body that is meant not to turn says so by `inertia: Infinity` or by `motionLocks`. */
function warnAboutBodiesThatDoNotTurn(world: PhysicsWorld): void {
  if (world.integrator.solvesWalls !== true) return;
  const { Collider, Inertia, Mass, MotionLocks } = world.components;
  const { members } = world.internal;
  const [inertia, turning] = [bitOf('Inertia'), bitOf('AngularVelocity')];
  const isMeantToTurn = (id: number) => Mass.value[id] > 0 && Collider.friction[id] > 0 && MotionLocks.angle[id] === 0;
  const stiff = firstRow(world, (id) => (members[id] & inertia) === 0 && isMeantToTurn(id));
  if (stiff > 0) {
    const warning = {
      message: `body ${stiff} does not turn or roll, because it has no Inertia.`,
      hint: 'Spawn it with its mass and its collider, or add the component; `inertia: Infinity` says that it is meant not to turn.',
    };
    warnOnce(world, warning, 'no Inertia');
  }
  warnAboutKinematicSpin(world);
  const still = firstRow(
    world,
    (id) => (members[id] & (inertia | turning)) === inertia && Inertia.value[id] > 0 && Mass.value[id] > 0,
  );
  if (still === 0) return;
  const warning = {
    message: `body ${still} does not turn, because it has Inertia and no AngularVelocity.`,
    hint: 'Spawn it with `rotation: 0` and `angularVelocity: 0` as well.',
  };
  warnOnce(world, warning, 'no AngularVelocity');
}

function warnAboutKinematicSpin(world: PhysicsWorld): void {
  const { AngularVelocity, Mass } = world.components;
  const seen = bitOf('Collider') | bitOf('AngularVelocity');
  const all = seen | bitOf('Rotation');
  const { members } = world.internal;
  const still = firstRow(
    world,
    (id) => (members[id] & all) === seen && AngularVelocity.z[id] !== 0 && !(Mass.value[id] > 0),
  );
  if (still === 0) return;
  const warning = {
    message: `body ${still} has an angular velocity and does not turn, because it has no Rotation.`,
    hint: 'Spawn it with `rotation: 0` as well.',
  };
  warnOnce(world, warning, 'no Rotation');
}

/** A body may press itself into another like it by this part of its radius. */
const MOST_SUNK = 0.05;

/**
 * Depth to which a box presses itself into an equal one, in g/ω²: each of two corners carries half of the weight, and moves as 2/5
 * of the mass does, because it also turns its box, and the other box gives way as much.
 */
const DEPTH_OF_BOXES = 2.5;

/** Soft contacts give way by a length that does not depend on how small a body is. */
function warnAboutSmallBodies(world: PhysicsWorld, dt: number): void {
  const gravity = world.forces.find(({ name }) => name === 'uniform gravity');
  const frequency = world.integrator.contactAngularFrequency?.(dt);
  if (gravity === undefined || frequency === undefined) return;
  // A force of the user may have this name as well.
  const [[x, y] = [0, 0]] = constantsOf(world, gravity);
  const depth = (DEPTH_OF_BOXES * Math.sqrt(x * x + y * y)) / (frequency * frequency);
  const { members } = world.internal;
  const { radius, sensor, mask } = world.components.Collider;
  const scaled = bitOf('GravityScale');
  const isHeavy = (id: number) => world.components.Mass.value[id] > 0 && (members[id] & scaled) === 0;
  const isSmall = (id: number) => radius[id] > 0 && radius[id] * MOST_SUNK < depth;
  const small = firstRow(world, (id) => isSmall(id) && isHeavy(id) && sensor[id] === 0 && mask[id] !== 0);
  if (small === 0) return;
  const millimetres = Number((1000 * depth).toPrecision(2));
  const part = Math.round((100 * depth) / radius[small]);
  const warning = {
    message: `body ${small} is small for these steps: its weight presses it ${millimetres} mm into another like it, ${part} % of its radius.`,
    hint: 'Contacts are springs that sub-steps can follow: take more of them and stiffer ones, such as softStep({ substeps: 16, contactHertz: 120 }). A body that touches nothing takes `mask: 0`.',
  };
  warnOnce(world, warning, 'small');
}
