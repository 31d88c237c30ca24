// Which bodies stop a character: those that its collider collides with, from the sides from which they are solid.
import type { Shape } from '../collision/shapes/2d/shape.ts';
import { shapeAt } from '../collision/shapes/shape-pool.ts';
import { isOpen } from '../ecs/rows.ts';
import { cos, sin } from '../math/elementary.ts';
import type { PhysicsWorld } from '../world/types.ts';
import type { Character } from './character.ts';
import { dot, gapTo, type Surface, type Vector2 } from './surface.ts';
import { velocityAt } from './surface-body.ts';

/** Cosine of the greatest angle between the normal of a one-way platform and its upward direction, as in the contacts. */
const ONE_WAY_COSINE = 0.5;

/** Whether a surface stops a character at a position. */
export function isObstacle(character: Character, surface: Surface, position: Vector2): boolean {
  if (surface.isWall) return true;
  const { world, id } = character;
  const { Collider } = world.components;
  const other = surface.id;
  if (!collide(world, id, other)) return false;
  if (Collider.oneWay[other] === 1 && !isOnUpperSide(character, surface, position)) return false;
  const shape = shapeAt(world, Collider.shape[other]);
  return shape?.neighbours === undefined || dot(surface.normal, outward(world, other, shape)) > 0;
}

/** Whether two bodies are on layers of each other's masks, unless their groups decide. */
function collide({ components }: PhysicsWorld, a: number, b: number): boolean {
  const { layers, mask, group } = components.Collider;
  if (group[a] !== 0 && group[a] === group[b]) return group[a] > 0;
  return (layers[a] & mask[b]) !== 0 && (layers[b] & mask[a]) !== 0;
}

/** Whether a character is above a one-way platform, or was before the platform's last movement. */
function isOnUpperSide(character: Character, surface: Surface, position: Vector2): boolean {
  const { world, margin, dt } = character;
  const angle = angleOf(world, surface.id);
  if (dot(surface.normal, { x: -sin(angle), y: cos(angle) }) < ONE_WAY_COSINE) return false;
  const moved = dot(velocityAt(world, surface.id, surface.point), surface.normal) * dt;
  return gapTo(surface, position) > -2 * margin - Math.max(moved, 0);
}

/** The outward normal of a segment of a chain, which is solid from one side only. */
function outward(world: PhysicsWorld, id: number, { normals: [x, y] }: Shape): Vector2 {
  const angle = angleOf(world, id);
  const [c, s] = [cos(angle), sin(angle)];
  return { x: c * x - s * y, y: s * x + c * y };
}

function angleOf(world: PhysicsWorld, id: number): number {
  return isOpen(world, id, 'Rotation') ? world.components.Rotation.angle[id] : 0;
}
