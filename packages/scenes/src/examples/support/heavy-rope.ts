/** A rope of fifteen heavy beads on springs, hung up at one end. */
import { linearDrag, type PhysicsWorld, rgba, spawn, springs, uniformGravity } from '@principia/physics';

export const ROPE = { count: 15, mass: 10, length: 20, gravity: 10, support: { x: 100, y: 100 } };

export const ropeForces = () => [uniformGravity({ y: ROPE.gravity }), linearDrag(), springs()];

/** Beads on the straight line from the support to the right. The last is free; a bead without mass does not move. */
export function addRope(world: PhysicsWorld, stiffness: number, drag: number): number[] {
  const { count, mass, length, support } = ROPE;
  let above = spawn(world, { position: support });
  return Array.from({ length: count }, (_, i) => {
    const position = { x: support.x + length * (i + 1), y: support.y };
    const appearance = { size: 5, color: rgba(1, 0.75, 0.4) };
    const bead = spawn(world, { position, velocity: {}, mass, linearDrag: drag, collider: 5, appearance });
    spawn(world, { spring: { a: above, b: bead, stiffness, damping: 20, length } });
    above = bead;
    return bead;
  });
}
