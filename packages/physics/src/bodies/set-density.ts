// Mass and moment of inertia of a body from its shape, at any time after it was spawned.
import { shapeAt } from '../collision/shapes/shape-pool.ts';
import { assertOutsideStep } from '../ecs/guards.ts';
import { isOpen } from '../ecs/rows.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkNumber } from '../errors/validate.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { solidOf } from './collider-shape.ts';
import { setCompoundDensity } from './compound-density.ts';
import { partsOf } from './parts.ts';

/**
 * Gives a body the mass and the moment of inertia of its collider, or of its parts as `setCompoundDensity` does, as `spawn` computes them
 * from a density. Position, velocity and spin stay; a body that does not turn stays so, and an InertiaTensor grows with the mass. For a
 * mass m of a body without parts pass m/A, where A is the area of its shape, `box(1, 1).area`. The hull stays: after `setShape` write
 * `Hull.volume` and `Hull.halfHeight` of what floats.
 * @param density kg/m², in three dimensions kg/m³
 * @throws PhysicsError E_RANGE for a body without mass, without a collider or of a segment; E_TYPE, E_NONFINITE, E_STALE, E_REENTRANT
 *   (during a step), E_DESTROYED: nothing is changed
 */
export function setDensity(world: PhysicsWorld, body: number, density: number): void {
  if (partsOf(world, body).length > 0) {
    setCompoundDensity(world, body, density);
    return;
  }
  assertOutsideStep(world, 'setDensity', 'Call it after the step.');
  const { Mass, Inertia, InertiaTensor, Collider } = world.components;
  const checked = checkNumber(density, 'density', { above: 0, max: 1e38 });
  if (!(Mass.value[body] > 0))
    throw refusal(body, 'mass', 'mass', 'What has no mass stands still: spawn it with a density.');
  if (!isOpen(world, body, 'Collider'))
    throw refusal(body, 'Collider', 'collider', 'Write the columns of Mass and Inertia of a body without a shape.');
  const solid = solidOf(world, shapeAt(world, Collider.shape[body]), Collider.radius[body]);
  const mass = checked * solid.massPerDensity;
  if (!(mass > 0)) throw refusal(body, 'area', 'collider', 'Write the column of Mass.');
  const ratio = mass / Mass.value[body];
  Mass.value[body] = mass;
  if (Inertia.value[body] > 0) Inertia.value[body] = mass * solid.inertiaPerMass;
  if (isOpen(world, body, 'InertiaTensor'))
    for (const axis of ['x', 'y', 'z'] as const) InertiaTensor[axis][body] *= ratio;
}

function refusal(body: number, lack: string, field: string, hint: string): PhysicsError {
  return new PhysicsError('E_RANGE', `setDensity: body ${body} has no ${lack}.`, { entity: body, field, hint });
}
