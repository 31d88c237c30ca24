// What a character does to bodies with mass: one that it meets gets the impulse that ends the approach, as if both were free,
// and the one that it stands on its weight, since what holds that holds the character, too: there 1/M and 1/I are left out.
//
//   j = -(v - u) · n / (1/m + 1/M + (r × n)²/I)
//
//   v  velocity of the character    u  velocity of the body at the point    n  normal, from the body    m, M  their masses
//   r  point from the centre of the body    I  moment of inertia of the body
//
// Source: inelastic collision, Goldstein, Classical Mechanics, section 1.1.
import { applyImpulse } from '../bodies/impulse.ts';
import { isOpen } from '../ecs/rows.ts';
import type { PhysicsWorld } from '../world/types.ts';
import type { Character } from './character.ts';
import { dot, plus, type Surface, type Vector2 } from './surface.ts';
import { bodyBehind, canTurn, isMovable, velocityAt } from './surface-body.ts';

/** A character presses on its ground with no more than this many times the mass that resists it. */
const MAX_RATIO = 10;

/**
 * Pushes each body once. A character without mass pushes none.
 * @param ground the body that the character stands on, 0 for none
 */
export function pushBodies(
  { world, id }: Character,
  surfaces: readonly Surface[],
  velocity: Vector2,
  ground: number,
): void {
  const mass = isOpen(world, id, 'Mass') ? world.components.Mass.value[id] : 0;
  if (!(mass > 0)) return;
  const pushed = new Set<number>();
  for (const surface of surfaces) {
    const { point, normal } = surface;
    const body = bodyBehind(world, surface.id);
    if (pushed.has(body) || !isMovable(world, body)) continue;
    const approach = -dot(plus(velocity, velocityAt(world, body, point), -1), normal);
    if (!(approach > 0)) continue;
    pushed.add(body);
    const inverseMass = inverseMassAt(world, body, point, normal);
    const effective = body === ground ? Math.min(mass, MAX_RATIO / inverseMass) : 1 / (1 / mass + inverseMass);
    const impulse = effective * approach;
    const vector = { x: -impulse * normal.x, y: -impulse * normal.y };
    applyImpulse(world, body, vector, canTurn(world, body) ? point : undefined);
  }
}

/** 1/M + (r × n)²/I */
function inverseMassAt(world: PhysicsWorld, body: number, point: Vector2, normal: Vector2): number {
  const { Mass, Inertia, Position } = world.components;
  const lever = (point.x - Position.x[body]) * normal.y - (point.y - Position.y[body]) * normal.x;
  const inertia = canTurn(world, body) ? Inertia.value[body] : 0;
  return 1 / Mass.value[body] + (inertia > 0 ? (lever * lever) / inertia : 0);
}
