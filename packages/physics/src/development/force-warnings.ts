// Warnings about forces: those that act twice, and those that cannot act as they were meant to.
import { COMPONENTS, type ComponentName } from '../components/all.ts';
import { bitOf, bitsOf } from '../components/membership.ts';
import { warnOnce } from '../errors/warn-once.ts';
import type { Force, Law, ParameterSource, PhysicsWorld } from '../world/types.ts';
import { firstRow } from './first-row.ts';
import { constantsOf } from './force-parameters.ts';

export function warnAboutForces(world: PhysicsWorld, dt: number): void {
  warnAboutRepeatedForces(world);
  warnAboutGravityAlongZ(world);
  warnAboutConstantsOfGravity(world);
  warnAboutMagneticFields(world);
  warnAboutRepeatedSources(world);
  warnAboutRestrictedPairs(world);
  warnAboutFuel(world);
  warnAboutTorques(world);
  warnAboutStrongDrag(world, dt);
  warnAboutStrongAngularDrag(world, dt);
}

function warnAboutRepeatedForces(world: PhysicsWorld): void {
  const known = new Set<string | Force>();
  const tables: object[] = [];
  for (const force of world.forces) {
    const key = signatureOf(world, force, tables);
    if (known.has(force) || (key !== undefined && known.has(key))) {
      warnOnce(world, {
        message: `the force "${force.name}" is in \`world.forces\` twice with the same parameters, and acts twice.`,
        hint: 'Remove one of them.',
      });
    }
    known.add(force);
    if (key !== undefined) known.add(key);
  }
}

/** Forces without a law that all their parameters and the equation tell apart: those of others hide what they act on. */
const PLAIN = ['springs', 'mutual gravity', 'mutual Coulomb'];

/**
 * Identifies forces that do the same: laws with equal constants and equal values of the world, such as the seed of noise, those of
 * `restrictForce` included. Functions of a user may differ in what they compute, and tables in what they will contain.
 * @param tables the functions that find tables, in the order in which they were met
 */
function signatureOf(world: PhysicsWorld, force: Force, tables: object[]): string | undefined {
  const { name, equation, law, parameters, sources = [] } = force;
  if (law === undefined) return PLAIN.includes(name) ? JSON.stringify([name, equation, parameters]) : undefined;
  if (sources.some(({ when }) => when === 'stage')) return undefined;
  const values = constantsOf(world, force);
  law.parameters.forEach((parameter, i) => {
    if (!('fields' in parameter)) return;
    const { write } = sources[i];
    // The waves are in memory of each force, and follow from its options.
    if (name === 'turbulent drag') values[i] = rowsOf(world, values[i]);
    else values[i] = [tables.includes(write) ? tables.indexOf(write) : tables.push(write) - 1];
  });
  return JSON.stringify([name, law.structure, values]);
}

/** Numbers of a wave of `turbulentDrag`. */
const WAVE = 8;

function rowsOf({ memory }: PhysicsWorld, [at, count]: readonly number[]): number[] {
  return [...new Float64Array(memory.buffer, at, WAVE * count)];
}

/** What is normal to the plane moves nothing in it. */
function warnAboutGravityAlongZ(world: PhysicsWorld): void {
  if (world.dimensions === 3) return;
  const z = world.forces
    .filter(({ name }) => name === 'uniform gravity')
    .map(({ parameters }) => parameters?.accelerationZ?.value ?? 0)
    .find((value) => value !== 0);
  if (z === undefined) return;
  const warning = {
    message: `uniformGravity has z = ${z}, which has no effect in a 2D world.`,
    hint: 'Give it as y, such as uniformGravity({ y: -9.8 }), or create the world with `dimensions: 3`.',
  };
  warnOnce(world, warning, 'gravity along z');
}

/** Constants that differ by less are the same, rounded. */
const ROUNDING = 1e-9;

/** The orbits of Wisdom and Holman and the forces between the bodies are of one gravity. */
function warnAboutConstantsOfGravity(world: PhysicsWorld): void {
  const { name, parameters } = world.integrator;
  const gravity = world.forces.filter((force) => force.name === 'mutual gravity');
  const [ofOrbits, ofForces] = [parameters?.G?.value, gravity[0]?.parameters?.G?.value];
  if (name !== 'Wisdom-Holman' || gravity.length !== 1 || ofOrbits === undefined || ofForces === undefined) return;
  if (Math.abs(ofOrbits - ofForces) <= ROUNDING * Math.abs(ofOrbits)) return;
  warnOnce(world, {
    message: `wisdomHolman has G = ${ofOrbits}, but mutualGravity has G = ${ofForces}: the orbits are wrong.`,
    hint: `Give both the same: wisdomHolman({ G: ${ofForces} }).`,
  });
}

/** The scheme of Boris replaces the force of its field. */
function warnAboutMagneticFields(world: PhysicsWorld): void {
  const { name, scheme } = world.integrator;
  const isSteady = ({ sources = [] }: { readonly sources?: readonly ParameterSource[] }) =>
    sources.length === 1 && sources[0].when === 'once';
  if (name !== 'Boris' || scheme === undefined || !isSteady(scheme)) return;
  const [field] = constantsOf(world, scheme);
  const isSame = (force: Force) =>
    force.name === 'magnetic field' &&
    isSteady(force) &&
    constantsOf(world, force)[0].every((value, axis) => value === field[axis]);
  if (field.every((value) => value === 0) || !world.forces.some(isSame)) return;
  warnOnce(world, {
    message: 'the magnetic field of boris is in `world.forces` as well, and acts twice.',
    hint: 'Leave magneticField out of `forces`: the integrator replaces it.',
  });
}

/** Forces of fixed sources beside one of all pairs, in which these sources are. */
function warnAboutRepeatedSources(world: PhysicsWorld): void {
  const acts = (name: string) => world.forces.some((force) => force.name === name);
  const { Attractor, Charge, Mass } = world.components;
  const { members } = world.internal;
  const isPlaced = (id: number) => (members[id] & bitOf('Position')) !== 0;
  if (acts('fixed charges') && acts('mutual Coulomb')) {
    const fixed = firstRow(world, (id) => isPlaced(id) && Charge.value[id] !== 0 && !(Mass.value[id] > 0));
    if (fixed > 0) warnOnce(world, REPEATED_CHARGES, 'repeated charges');
  }
  if (!(acts('attractors') && acts('mutual gravity'))) return;
  const heavy = firstRow(world, (id) => isPlaced(id) && Attractor.mu[id] > 0 && Mass.value[id] > 0);
  if (heavy === 0) return;
  const warning = {
    message: `body ${heavy} has Attractor and Mass, and attracts twice: by attractors and by mutualGravity.`,
    hint: 'Leave out its Attractor; or give it no Mass, and it stays where it is.',
  };
  warnOnce(world, warning, 'repeated attraction');
}

const REPEATED_CHARGES = {
  message: 'charges without mass act twice: by fixedCharges and by mutualCoulomb, which includes them.',
  hint: 'Leave fixedCharges out of `forces`.',
};

/** Forces between bodies of which both ends are meant. */
const PAIRS = ['springs', 'mutual gravity', 'mutual Coulomb', 'enclosed gas'];

/** Limits of time leave them whole, and their potential. */
function warnAboutRestrictedPairs(world: PhysicsWorld): void {
  for (const { name, potential } of world.forces) {
    const pair = PAIRS.find((each) => name === `${each} (restricted)`);
    if (pair === undefined || potential !== undefined) continue;
    warnOnce(world, {
      message: `"${pair}" restricted to some bodies or a region acts on one end of a pair where only that is within: momentum and energy are not kept.`,
      hint: 'Restrict forces on single bodies; leave springs and masses out of the world instead, or make the others test particles.',
    });
  }
}

/** Fuel is part of the mass. A body with Mass and the value 0 waits in the pool of an emitter, or has burnt all of it. */
function warnAboutFuel(world: PhysicsWorld): void {
  if (world.internal.counts.Engine === 0) return;
  const { Engine, Mass } = world.components;
  const isMassless = (id: number) => (world.internal.members[id] & bitOf('Mass')) === 0;
  const isTooLight = (id: number) => Mass.value[id] > 0 && Engine.fuel[id] >= Mass.value[id];
  const light = firstRow(world, (id) => isTooLight(id) || (Engine.exhaustSpeed[id] > 0 && isMassless(id)));
  if (light === 0) return;
  const message = isMassless(light)
    ? `the engine of body ${light} pushes nothing, because the body has no Mass.`
    : `body ${light} has ${Engine.fuel[light]} kg of fuel in a mass of ${Mass.value[light]} kg, which includes the fuel.`;
  const hint = 'Give `mass` as the sum of the empty mass and the fuel.';
  warnOnce(world, { message, hint }, 'fuel above mass');
}

/** What a body may lack that a torque is meant to turn. */
const TURNING = ['Inertia', 'InertiaTensor', 'AngularVelocity', 'Rotation', 'Orientation'];

/** Worlds of rigid bodies ask this of every body. */
function warnAboutTorques(world: PhysicsWorld): void {
  if (world.integrator.solvesWalls === true) return;
  for (const { name, law, reads } of world.forces) {
    // On which bodies a law acts that reads components of the user is not asked here.
    if (law?.torque === undefined || readsOwnComponents(law)) continue;
    const known = reads.filter((each): each is ComponentName => each in COMPONENTS && !TURNING.includes(each));
    warnAboutTorque(world, name === 'constant torque' ? 'constantTorque' : `"${name}"`, known);
  }
}

/** An expression: those of laws have these fields. */
type Tree = NonNullable<Law['torque']>;

/** Whether the torque asks for a component of the user, which the `reads` of a force leave out. */
function readsOwnComponents({ torque }: Law): boolean {
  const isOwn = ({ op, data }: Tree) =>
    (op === 'column' && typeof (data as { component: unknown }).component !== 'string') ||
    (op === 'has' && typeof data !== 'string');
  const seen = new Set<unknown>();
  const visit = (expression: Tree): boolean => {
    if (seen.has(expression)) return false;
    seen.add(expression);
    return isOwn(expression) || expression.args.some((each) => visit(each as Tree));
  };
  return torque !== undefined && visit(torque);
}

/** Names a body that a torque acts on and does not turn: one that has the moment of inertia or the spin, but not both. */
function warnAboutTorque(world: PhysicsWorld, force: string, reads: readonly ComponentName[]): void {
  const { members, moreMembers } = world.internal;
  const { Mass, MotionLocks, Inertia } = world.components;
  const { first, second } = bitsOf(reads);
  const [inertia, turning] = [bitOf('Inertia') | bitOf('InertiaTensor'), bitOf('AngularVelocity')];
  const isActedOn = (id: number) =>
    (members[id] & first) === first && (moreMembers[id] & second) === second && Mass.value[id] > 0;
  // An infinite moment of inertia is stored as 0.
  const isHeld = (id: number) =>
    MotionLocks.angle[id] !== 0 || ((members[id] & inertia) !== 0 && !(Inertia.value[id] > 0));
  const hasOneOf = (id: number) => ((members[id] & inertia) !== 0) !== ((members[id] & turning) !== 0);
  const still = firstRow(world, (id) => hasOneOf(id) && isActedOn(id) && !isHeld(id));
  if (still === 0) return;
  const pose =
    world.dimensions === 2 ? '`rotation: 0` and `angularVelocity: 0`' : '`orientation: {}` and `angularVelocity: {}`';
  const isWithoutInertia = (members[still] & inertia) === 0;
  const warning = {
    message: `${force} does not turn body ${still}, because it has ${isWithoutInertia ? 'AngularVelocity and no Inertia' : 'Inertia and no AngularVelocity'}.`,
    hint: isWithoutInertia
      ? 'Spawn it with `inertia` as well, such as discInertia(mass, radius).'
      : `Spawn it with ${pose} as well.`,
  };
  warnOnce(world, warning, `torque of ${force}`);
}

/** A drag that takes more than twice the speed of a body in a step throws it back, faster each time. */
function warnAboutStrongDrag(world: PhysicsWorld, dt: number): void {
  const { isStable } = world.integrator;
  const { LinearDrag, QuadraticDrag, Mass, Velocity } = world.components;
  const acts = (name: string) => world.forces.some((force) => force.name === name);
  const hasBoth = acts('immersed drag') || acts('turbulent drag');
  const [hasLinear, hasQuadratic] = [hasBoth || acts('linear drag'), hasBoth || acts('quadratic drag')];
  if (isStable === undefined || !(hasLinear || hasQuadratic)) return;
  const rateOf = (id: number) => {
    const { x, y, z } = Velocity;
    const speed = Math.sqrt(x[id] * x[id] + y[id] * y[id] + z[id] * z[id]);
    const linear = hasLinear ? LinearDrag.coefficient[id] : 0;
    const quadratic = hasQuadratic ? 2 * QuadraticDrag.coefficient[id] * speed : 0;
    return (linear + quadratic) / Mass.value[id];
  };
  const thrown = firstRow(world, (id) => Mass.value[id] > 0 && rateOf(id) > 0 && !isStable(0, rateOf(id) * dt));
  if (thrown === 0) return;
  const warning = {
    message: `the drag of body ${thrown} takes more of its speed in a step than it has, and throws it back faster.`,
    hint: `Take steps below ${(1 / rateOf(thrown)).toPrecision(2)} s, a smaller coefficient, or a heavier body.`,
  };
  warnOnce(world, warning, 'strong drag');
}

/** In worlds of particles a step has one torque, whatever the integrator. */
const MAX_TURN_LOST = 2;

/** The same of rotation. */
function warnAboutStrongAngularDrag(world: PhysicsWorld, dt: number): void {
  const { isStable, solvesWalls } = world.integrator;
  if (!world.forces.some(({ name }) => name === 'angular drag')) return;
  const { AngularDrag, Inertia, InertiaTensor, Mass } = world.components;
  const rateOf = (id: number) => {
    const moments = [Inertia.value[id], InertiaTensor.x[id], InertiaTensor.y[id], InertiaTensor.z[id]];
    return AngularDrag.coefficient[id] / Math.min(...moments.filter((moment) => moment > 0));
  };
  const turning = bitOf('AngularVelocity');
  const turns = (id: number) => Mass.value[id] > 0 && (world.internal.members[id] & turning) !== 0;
  const isCalm = (lost: number) => (solvesWalls === true ? (isStable?.(0, lost) ?? true) : lost <= MAX_TURN_LOST);
  const thrown = firstRow(world, (id) => turns(id) && rateOf(id) > 0 && !isCalm(rateOf(id) * dt));
  if (thrown === 0) return;
  const warning = {
    message: `the angular drag of body ${thrown} takes more of its spin in a step than it has, and turns it back faster.`,
    hint: `Take steps below ${(1 / rateOf(thrown)).toPrecision(2)} s, a smaller coefficient, or a larger moment of inertia.`,
  };
  warnOnce(world, warning, 'strong angular drag');
}
