// Warnings about forces that do not go with the integrator of the world.
import { bitOf } from '../components/membership.ts';
import { warnOnce } from '../errors/warn-once.ts';
import type { Force, Integrator, PhysicsWorld } from '../world/types.ts';
import { firstRow } from './first-row.ts';
import { parameterOf } from './force-parameters.ts';
import { growthRate } from './gyration-growth.ts';

export function warnAboutSchemes(world: PhysicsWorld, dt: number): void {
  warnAboutVelocities(world);
  warnAboutGyration(world, dt);
  warnAboutMissingGravity(world);
  warnAboutOrderOfPlanets(world);
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

/** Speeds that change by less in a minute are not worth a word. */
const SLOW_CHANGE = 0.01;

/** No scheme but that of Boris keeps the speed of what a force turns by Ω, rad/s. */
function warnAboutGyration(world: PhysicsWorld, dt: number): void {
  const { integrator } = world;
  for (const force of world.forces) {
    const turning = turningOf(world, force);
    // Worlds without such a force do not instantiate the logarithm that the rate is made of.
    if (turning === undefined || growthRate(integrator, 0, dt) === undefined) continue;
    const drag = dragRates(world);
    const rateOf = (id: number) => growthRate(integrator, turning(id), dt) ?? 0;
    // Where drag takes more than is gained nothing gets faster, and where it takes more than is lost it is what counts.
    const changed = firstRow(
      world,
      (id) => world.components.Mass.value[id] > 0 && 60 * (Math.abs(rateOf(id)) - drag(id)) > SLOW_CHANGE,
    );
    if (changed === 0) continue;
    const scheme =
      integrator.solvesWalls === true
        ? 'rigid bodies move by semi-implicit Euler in their sub-steps'
        : `the integrator is ${integrator.name}`;
    const warning = {
      message: `${changeOfSpeed(force, changed, rateOf(changed))}, because ${scheme}.`,
      hint: hintOnGyration(integrator, force),
    };
    warnOnce(world, warning, `gyration: ${force.name}`);
  }
}

const isMagnetic = ({ name }: Force) => name.startsWith('magnetic field');

/** Rates above 1/s are stated as the time in which the speed doubles or halves, because per cents a second would be huge numbers. */
function changeOfSpeed(force: Force, body: number, rate: number): string {
  const size = Math.abs(rate);
  const percent = Number((100 * size).toPrecision(2));
  const seconds = Number((Math.LN2 / size).toPrecision(2));
  const gains = rate > 0;
  if (isMagnetic(force)) {
    const change = gains ? `double their speed every ${seconds} s` : `lose half of their speed every ${seconds} s`;
    const slowly = `${gains ? 'gain' : 'lose'} ${percent} % of their speed a second`;
    return `charges in the magnetic field ${size > 1 ? change : slowly}`;
  }
  const fast = `"${force.name}" ${gains ? 'doubles' : 'halves'} the speed of body ${body} every ${seconds} s`;
  const slow = `"${force.name}" makes body ${body} ${gains ? 'faster' : 'slower'} by ${percent} % a second`;
  return `${size > 1 ? fast : slow}, though it does no work`;
}

function hintOnGyration({ name, order, solvesWalls }: Integrator, force: Force): string {
  const isField = isMagnetic(force);
  if (solvesWalls === true) {
    const other = isField ? 'boris({ field })' : 'velocityVerlet or rungeKutta4';
    return `Take more sub-steps, softStep({ substeps: 64 }), or for ${isField ? 'charges' : 'bodies'} that are discs \`preset: particleContacts\` with ${other}.`;
  }
  if (isField) return 'Take boris({ field }).';
  if (name === 'Runge-Kutta 4') return 'Take shorter steps.';
  return order === 1 ? 'Take velocityVerlet or rungeKutta4.' : 'Take rungeKutta4, or shorter steps.';
}

type Rate = (id: number) => number;

/** How fast a force that is perpendicular to the velocity turns it, rad/s; undefined for other forces. */
function turningOf(world: PhysicsWorld, force: Force): Rate | undefined {
  const { AngularVelocity, Charge, Collider, Lift, Mass, Velocity } = world.components;
  const name = force.name.replace(' (restricted)', '');
  const at = (of: string) => parameterOf(world, force, of) ?? [0, 0, 0];
  if (name === 'magnetic field') {
    const field = lengthOf(at('field'));
    return (id) => Math.abs(Charge.value[id] * field) / Mass.value[id];
  }
  const wind = at('wind');
  const flowOf = (id: number) => [Velocity.x[id] - wind[0], Velocity.y[id] - wind[1], Velocity.z[id] - wind[2]];
  if (name === 'lift') return (id) => (Math.abs(Lift.coefficient[id]) * lengthOf(flowOf(id))) / Mass.value[id];
  if (name !== 'Magnus force') return undefined;
  const factor = Math.PI * at('density')[0] * at('coefficient')[0];
  return (id) => {
    const [w, radius] = [flowOf(id), Collider.radius[id]];
    const speed = lengthOf(w);
    const [x, y, z] = [AngularVelocity.x[id], AngularVelocity.y[id], AngularVelocity.z[id]];
    const across = lengthOf([y * w[2] - z * w[1], z * w[0] - x * w[2], x * w[1] - y * w[0]]);
    return speed === 0 ? 0 : (factor * radius * radius * radius * across) / speed / Mass.value[id];
  };
}

function lengthOf([x, y, z]: readonly number[]): number {
  return Math.sqrt(x * x + y * y + z * z);
}

/** What drag takes of the speed in a second. */
function dragRates(world: PhysicsWorld): Rate {
  const { LinearDrag, Mass, QuadraticDrag, Velocity } = world.components;
  const read = new Set(world.forces.flatMap(({ reads }) => reads));
  return (id) => {
    const speed = lengthOf([Velocity.x[id], Velocity.y[id], Velocity.z[id]]);
    const linear = read.has('LinearDrag') ? LinearDrag.coefficient[id] : 0;
    const quadratic = read.has('QuadraticDrag') ? QuadraticDrag.coefficient[id] * speed : 0;
    return (linear + quadratic) / Mass.value[id];
  };
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

/** Planets whose orbits differ by less have about the same error in either order. */
const NEAR_ORBITS = 0.5;

/** The coordinates of Jacobi measure each planet from the centre of those before it. */
function warnAboutOrderOfPlanets(world: PhysicsWorld): void {
  const { integrator, lastId } = world;
  if (integrator.name !== 'Wisdom-Holman') return;
  const { value } = world.components.Mass;
  let star = 0;
  for (let id = 1; id <= lastId; id++) if (isSource(world, id) && value[id] > value[star]) star = id;
  let [widest, outer] = [0, 0];
  for (let id = 1; id <= lastId; id++) {
    if (id === star || !isSource(world, id)) continue;
    const axis = semiMajorAxis(world, star, id);
    if (axis < NEAR_ORBITS * widest) {
      const warning = {
        message: `wisdomHolman takes planets in the order in which they were created, and body ${id} moves inside of body ${outer}, which comes before it: the error is up to a hundred times as large.`,
        hint: 'Create planets by increasing distance from the star. Moons need another integrator, such as gaussRadau().',
      };
      warnOnce(world, warning, 'order of planets');
      return;
    }
    if (axis > widest) [widest, outer] = [axis, id];
  }
}

function isSource({ components, internal }: PhysicsWorld, id: number): boolean {
  const bits = bitOf('Position') | bitOf('Mass');
  return (internal.members[id] & (bits | bitOf('TestParticle'))) === bits && components.Mass.value[id] > 0;
}

/** Of the orbit about the star, m; infinite for a body that leaves it. */
function semiMajorAxis({ components, integrator }: PhysicsWorld, star: number, id: number): number {
  const { Mass, Position: p, Velocity: v } = components;
  const mu = (integrator.parameters?.G?.value ?? 0) * (Mass.value[star] + Mass.value[id]);
  const r = lengthOf([p.x[id] - p.x[star], p.y[id] - p.y[star], p.z[id] - p.z[star]]);
  const speed = lengthOf([v.x[id] - v.x[star], v.y[id] - v.y[star], v.z[id] - v.z[star]]);
  const inverse = 2 / r - (speed * speed) / mu;
  return inverse > 0 ? 1 / inverse : Number.POSITIVE_INFINITY;
}
