// Warnings about forces that do not go with the integrator of the world.
import { warnOnce } from '../errors/warn-once.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';

export function warnAboutSchemes(world: PhysicsWorld, dt: number): void {
  warnAboutVelocities(world);
  warnAboutGyration(world, dt);
  warnAboutMissingGravity(world);
}

/** Schemes that split a step into drifts and kicks, which a force that depends on the velocity makes first order. */
const SPLIT = ['leapfrog', 'drift-kick-drift', 'Yoshida 4', 'Yoshida 6'];

/** A pull by the pointer is no part of what is computed, and the correction of orbits is so small that its order does not matter. */
const HARMLESS = ['pointer pull', 'post-Newtonian'];

function warnAboutVelocities(world: PhysicsWorld): void {
  const { name } = world.integrator;
  if (!SPLIT.includes(name)) return;
  const force = world.forces.find((each) => readsVelocity(each) && actsOnAnything(world, each));
  if (force === undefined) return;
  const warning = {
    message: `${name} is of first order with the force "${force.name}", which depends on the velocity, and may be worse than Euler's scheme.`,
    hint: 'Take velocityVerlet or rungeKutta4; for a magnetic field boris({ field }).',
  };
  warnOnce(world, warning, 'velocity in a split scheme');
}

/** Springs read velocities whether they damp or not. */
function readsVelocity({ name, law, reads }: Force): boolean {
  return law !== undefined && reads.includes('Velocity') && !HARMLESS.some((each) => name.startsWith(each));
}

/** Whether there are bodies with all that a force reads. */
function actsOnAnything({ internal }: PhysicsWorld, { reads }: Force): boolean {
  const counts: Readonly<Record<string, number>> = internal.counts;
  return reads.every((component) => counts[component] !== 0);
}

/** Speeds that grow by less in a minute are not worth a word. */
const SLOW_GROWTH = 0.01;

/** Semi-implicit Euler with the length of a sub-step gains (Ω h)²/2 of the speed in each. */
function warnAboutGyration(world: PhysicsWorld, dt: number): void {
  const { solvesWalls, evaluations } = world.integrator;
  const field = world.forces.find(({ name }) => name.startsWith('magnetic field'));
  if (solvesWalls !== true || field === undefined) return;
  const values = new Float64Array(3);
  field.sources?.[0]?.write(world, values, 0, world.time);
  const { Charge, Mass } = world.components;
  let fastest = 0;
  for (let id = 1; id <= world.lastId; id++) {
    if (Mass.value[id] > 0) fastest = Math.max(fastest, Math.abs((Charge.value[id] * values[2]) / Mass.value[id]));
  }
  const rate = (fastest * fastest * dt) / evaluations / 2;
  if (!(60 * rate > SLOW_GROWTH)) return;
  const warning = {
    message: `charges in the magnetic field gain ${Number((100 * rate).toPrecision(2))} % of their speed a second, because rigid bodies move by semi-implicit Euler in their sub-steps.`,
    hint: 'Take more sub-steps, softStep({ substeps: 64 }), or for charges that are discs `preset: particleContacts` with boris({ field }).',
  };
  warnOnce(world, warning, 'gyration of rigid bodies');
}

/** The orbits of Wisdom and Holman are those of the forces between the bodies, and not instead of them. */
function warnAboutMissingGravity(world: PhysicsWorld): void {
  if (world.integrator.name !== 'Wisdom-Holman' || world.forces.some(({ local }) => !local)) return;
  if (world.internal.counts.Mass < 2) return;
  warnOnce(world, {
    message:
      'wisdomHolman moves nothing on orbits by itself: without mutualGravity in `forces` bodies fly straight on.',
    hint: 'Add mutualGravity({ G }) with the same G to `forces`.',
  });
}
