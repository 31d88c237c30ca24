// Mass, centre and moment of inertia of a compound body of which parts were removed, added or changed.
//
//   v' = v + ω × d        d  from the old centre of mass to the new one
//
// What is left of a rigid body moves on as it did: each of its points keeps its velocity, which this is at the new centre
// (Goldstein, Classical Mechanics, section 4.9). So the body keeps the momentum of the parts that are left.
import { circle } from '../collision/shapes/2d/circle.ts';
import { shapeAt } from '../collision/shapes/shape-pool.ts';
import { assertOutsideStep } from '../ecs/guards.ts';
import { isOpen, teleport } from '../ecs/rows.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkNumber } from '../errors/validate.ts';
import { cos, sin } from '../math/elementary.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { compoundMass, type MassPart } from './compound-mass.ts';
import { partsOf } from './parts.ts';

/**
 * Gives a compound body the mass, the centre of mass and the moment of inertia of the parts that it has now, after parts were
 * despawned, attached, moved or given another shape. The parts and the joints of the body stay where they are, and each point moves on as
 * it did. A body that does not turn stays so.
 * @param density of all parts, kg/m², or a function that returns that of a part from its id
 * @throws PhysicsError E_RANGE for a body without parts or mass, or parts without area; E_TYPE, E_NONFINITE, E_STALE, E_REENTRANT
 *   (during a step), E_DESTROYED: nothing is changed
 */
export function setCompoundDensity(
  world: PhysicsWorld,
  body: number,
  density: number | ((part: number) => number),
): void {
  const parts = partsOf(world, body);
  assertOutsideStep(world, 'setCompoundDensity', 'Call it after the step.');
  const { Mass, Inertia } = world.components;
  const { x, y } = world.components.Attachment;
  if (parts.length === 0 || !(Mass.value[body] > 0)) throw withoutMass(body, parts.length);
  const sum = compoundMass(
    parts.map((part) => massPart(world, part, typeof density === 'number' ? density : density(part))),
  );
  if (sum.mass === 0) throw withoutMass(body, parts.length);
  Mass.value[body] = sum.mass;
  if (Inertia.value[body] > 0) Inertia.value[body] = sum.inertia;
  const shift = moveCentre(world, body, sum.x, sum.y);
  for (const part of parts) [x[part], y[part]] = [x[part] - sum.x, y[part] - sum.y];
  shiftJoints(world, body, sum, shift);
}

function withoutMass(body: number, parts: number): PhysicsError {
  const lack = parts === 0 ? 'no parts' : 'no mass, or parts without area';
  return new PhysicsError('E_RANGE', `setCompoundDensity: body ${body} has ${lack}.`, {
    entity: body,
    field: 'body',
    hint:
      parts === 0
        ? 'Despawn a body that has lost its last part; setDensity(world, body, density) is for those that never had any.'
        : 'Give spawnCompound densities or a mass.',
  });
}

function massPart(world: PhysicsWorld, part: number, density: unknown): MassPart {
  const checked = checkNumber(density, 'density', { above: 0, max: 1e38 });
  const { Attachment, Collider } = world.components;
  const { area, inertiaPerMass } = shapeAt(world, Collider.shape[part]) ?? circle(Collider.radius[part]);
  return { x: Attachment.x[part], y: Attachment.y[part], mass: checked * area, inertiaPerMass };
}

interface Point {
  readonly x: number;
  readonly y: number;
}

/** Returns how far the centre moves in the world, m. @param x, y the new centre, in the frame of the body */
function moveCentre(world: PhysicsWorld, body: number, x: number, y: number): Point {
  const { Position, Rotation, Velocity, AngularVelocity } = world.components;
  const [c, s] = [cos(Rotation.angle[body]), sin(Rotation.angle[body])];
  const [dx, dy] = [c * x - s * y, s * x + c * y];
  Position.x[body] += dx;
  Position.y[body] += dy;
  Velocity.x[body] -= AngularVelocity.z[body] * dy;
  Velocity.y[body] += AngularVelocity.z[body] * dx;
  teleport(world, body);
  return { x: dx, y: dy };
}

/**
 * Anchors are in the frame of the body, whose origin is its centre of mass; a rack is where its centre is along its axis.
 * @param centre of the body in its frame @param shift of the centre in the world
 */
function shiftJoints(world: PhysicsWorld, body: number, centre: Point, shift: Point): void {
  if (world.internal.counts.Joint === 0) return;
  const { a, b, ax, ay, bx, by, isRack, angle, axis } = world.components.Joint;
  for (let id = 1; id <= world.lastId; id++) {
    if (!isOpen(world, id, 'Joint')) continue;
    if (a[id] === body) [ax[id], ay[id]] = [ax[id] - centre.x, ay[id] - centre.y];
    if (b[id] !== body) continue;
    [bx[id], by[id]] = [bx[id] - centre.x, by[id] - centre.y];
    if (isRack[id] === 1) angle[id] += cos(axis[id]) * shift.x + sin(axis[id]) * shift.y;
  }
}
