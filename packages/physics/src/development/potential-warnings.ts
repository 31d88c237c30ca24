// A law whose potential is not that of its force: `energy(world)` would drift, and its integrator would be blamed.
import { warnOnce } from '../errors/warn-once.ts';
import type { Force, Law, PhysicsWorld } from '../world/types.ts';
import { firstRow } from './first-row.ts';
import { forceAt, type Place, potentialAt } from './law-values.ts';

/** Forces that were compared with their potential. */
const compared = new WeakSet<Force>();

/** So many bodies are tried, since a force may be zero where the first of them is. */
const BODIES = 4;

/** Derivatives are differences over these parts of the distance from the origin, or of a metre. */
const PARTS = [1e-4, 1e-5];

/** Differences of a smooth potential are exact to this part; force and gradient that differ by more than ten times as much are not one. */
const PRECISION = 1e-3;

export function warnAboutPotentials(world: PhysicsWorld): void {
  for (const force of world.forces) {
    const { law, sources = [] } = force;
    if (law?.potential === undefined || force.potential === undefined || compared.has(force)) continue;
    const parameters = new Map(
      law.parameters.map((parameter, p) => {
        const values = new Float64Array(3);
        if (!('fields' in parameter)) sources[p].write(world, values, 0, world.time);
        return [parameter, [values[0], values[1], values[2]] as const] as const;
      }),
    );
    let tried = 0;
    const wrong = firstRow(world, (id) => {
      if (tried === BODIES || !(world.components.Mass.value[id] > 0)) return false;
      tried++;
      const { x, y, z } = world.components.Position;
      return isWrong(law, { world, id, position: [x[id], y[id], world.dimensions === 2 ? 0 : z[id]], parameters });
    });
    if (tried > 0) compared.add(force);
    if (wrong > 0) warn(world, law, wrong);
  }
}

/** Whether the force and the gradient surely differ: at and near a kink of the potential its differences do not agree either. */
function isWrong(law: Law, place: Place): boolean {
  const force = forceAt(law, place);
  if (force === undefined) return false;
  for (let axis = 0; axis < place.world.dimensions; axis++) {
    const [coarse, fine] = PARTS.map((part) => derivative(law, place, axis, part));
    if (!(Math.abs(coarse - fine) <= PRECISION * Math.abs(fine))) continue;
    const size = Math.max(Math.abs(force[axis]), Math.abs(fine));
    if (Math.abs(force[axis] + fine) > 10 * PRECISION * size) return true;
  }
  return false;
}

/** The derivative of the potential by central differences; NaN at a kink, where those of both sides are not the same. */
function derivative(law: Law, place: Place, axis: number, part: number): number {
  const step = part * Math.max(1, Math.abs(place.position[axis]));
  const [before, here, after] = [-step, 0, step].map((by) => {
    const moved = place.position.map((x, i) => (i === axis ? x + by : x));
    return potentialAt(law, { ...place, position: [moved[0], moved[1], moved[2]] }) ?? Number.NaN;
  });
  const slope = (after - before) / (2 * step);
  const bend = (after - 2 * here + before) / step;
  return Math.abs(bend) <= 10 * PRECISION * Math.abs(slope) ? slope : Number.NaN;
}

function warn(world: PhysicsWorld, law: Law, body: number): void {
  const warning = {
    message: `the force of "${law.name}" is not minus the gradient of its potential, as at body ${body}: energy(world) is wrong.`,
    hint: 'Check the sign and the factor of `potential`, or let lawFromPotential derive the force from it.',
  };
  warnOnce(world, warning, `potential of ${law.name}`);
}
