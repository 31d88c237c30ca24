import { explode } from '@principia/physics';
import type { BouncingBalls } from '@principia/scenes';

/** Radius of a blast, m, and the speed that it gives at its centre, m/s. */
const BLAST = { radius: 2.2, speed: 14 } as const;

/** Blows up what is about a point. */
export function blast({ world, mass }: BouncingBalls, centre: { x: number; y: number; z: number }): void {
  const { x, y, z } = centre;
  const point = world.dimensions === 3 ? { x, y, z } : { x, y };
  explode(world, { centre: point, impulse: BLAST.speed * mass, radius: BLAST.radius });
}
