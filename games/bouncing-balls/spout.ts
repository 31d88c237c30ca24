/** A spout in the ceiling that pours balls. */
import { cos, keepState, sin } from '@principia/physics';
import type { BouncingBalls } from '@principia/scenes';

/** The spout takes balls from the room, in the order of their ids. */
export interface Spout {
  /** Whether balls are poured. */
  isOpen: boolean;
}

/** Share of all balls that the spout pours in a second, and their speed, m/s. */
const POUR_SHARE = 0.15;
const POUR_SPEED = 3;
/** Angle between two poured balls, rad: the golden angle spreads them evenly over the mouth of the spout. */
const GOLDEN_ANGLE = 2.399963;

/** Adds a system that pours. A poured ball is one that lay in the room, so that the number of balls stays. */
export function addSpout({ world, balls, room, radius, dt }: BouncingBalls): Spout {
  const spout = { isOpen: false };
  // The number of balls due, and of those poured. A typed array, because snapshots copy it without garbage.
  const progress = new Float64Array(2);
  keepState(world, spout, progress);
  const { Position, Velocity, Mass } = world.components;
  const centre = { x: (room.min.x + room.max.x) / 2, z: (room.min.z + room.max.z) / 2 };
  const put = (id: number, at: number) => {
    const angle = GOLDEN_ANGLE * at;
    const reach = 2 * radius * Math.sqrt((at % 7) / 7);
    const place = { x: centre.x + reach * cos(angle), y: room.max.y - 1.5 * radius, z: centre.z + reach * sin(angle) };
    for (const axis of ['x', 'y', 'z'] as const) {
      if (axis === 'z' && world.dimensions === 2) continue;
      Position[axis][id] = place[axis];
      world.previous.Position[axis][id] = place[axis];
      Velocity[axis][id] = axis === 'y' ? -POUR_SPEED : 0;
    }
    world.versions.pose++;
  };
  world.phases.input.push(() => {
    if (!spout.isOpen) return;
    progress[0] += Math.min(balls.length, Math.max(8, POUR_SHARE * balls.length)) * dt;
    for (; progress[0] >= 1; progress[0]--) {
      const id = balls[progress[1] % balls.length];
      // A dragged ball has no mass and stays in its hand.
      if (Mass.value[id] > 0) put(id, progress[1]);
      progress[1]++;
    }
  });
  return spout;
}
