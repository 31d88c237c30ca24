/** The simulation: the scene, and the settings that a running world can apply. It needs no display. */
import { contacts, cos, explode, keepState, replaceForce, sin, uniformGravity } from '@principia/physics';
import { type BouncingBalls, ballDrag, bouncingBalls } from '@principia/scenes';

/** The settings of the balls. */
export interface BallValues {
  readonly count: number;
  readonly gravity: number;
  readonly restitution: number;
  readonly drag: number;
  readonly friction: number;
  readonly collisions: boolean;
  readonly wrap: boolean;
}

export interface BallOptions {
  readonly values: BallValues;
  readonly seed: number;
  readonly dimensions: 2 | 3;
}

export const { parameters } = bouncingBalls;

/** Balls, and a spout that pours them. */
export interface BallsRun extends BouncingBalls {
  /** Whether balls are poured: the spout takes them from the room, in the order of their ids. */
  readonly spout: { isOpen: boolean };
}

export function createBalls({ values, seed, dimensions }: BallOptions): BallsRun {
  const { count, gravity, restitution, drag, friction } = values;
  const collisions = values.collisions ? 1 : 0;
  const wrap = values.wrap ? 1 : 0;
  const balls = bouncingBalls.create({
    seed,
    dimensions,
    count,
    gravity,
    restitution,
    drag,
    friction,
    collisions,
    wrap,
  });
  return { ...balls, spout: addSpout(balls) };
}

/** Share of all balls that the spout pours in a second, and their speed, m/s. */
const POUR_SHARE = 0.15;
const POUR_SPEED = 3;
/** Angle between two poured balls, rad: the golden angle spreads them evenly over the mouth of the spout. */
const GOLDEN_ANGLE = 2.399963;

/** Adds a system that pours. A poured ball is one that lay in the room, so that the number of balls stays. */
function addSpout({ world, balls, room, radius, dt }: BouncingBalls): { isOpen: boolean } {
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

/** Radius of a blast, m, and the speed that it gives at its centre, m/s. */
const BLAST = { radius: 2.2, speed: 14 } as const;

/** Blows up what is about a point. */
export function blast({ world, mass }: BouncingBalls, centre: { x: number; y: number; z: number }): void {
  const { x, y } = centre;
  const point = world.dimensions === 3 ? centre : { x, y };
  explode(world, { centre: point, impulse: BLAST.speed * mass, radius: BLAST.radius });
}

/** Applies a changed setting to the running world; false if the setting requires a new world. */
export function applyValue(sim: BallsRun, name: string, values: BallValues): boolean {
  const { world, radius } = sim;
  const { Collider, QuadraticDrag } = world.components;
  const last = world.lastId + 1;
  if (name === 'gravity') replaceForce(world, uniformGravity({ y: -values.gravity }));
  else if (name === 'restitution') Collider.restitution.fill(values.restitution, 1, last);
  else if (name === 'friction') Collider.friction.fill(values.friction, 1, last);
  else if (name === 'drag') QuadraticDrag.coefficient.fill(ballDrag(values.drag, radius), 1, last);
  else if (name === 'collisions') sim.setCollisions(values.collisions);
  else return false;
  return true;
}

/** Contacts between balls in the last step; undefined if collisions are off. */
export function countContacts({ world }: BallsRun): number | undefined {
  return world.phases.collide.length === 0 ? undefined : contacts(world).count;
}

/** Returns a function that clamps the target of a dragged ball to the room, in place. */
export function clampToRoom({ room, radius }: BallsRun) {
  return (point: { x: number; y: number; z: number }): void => {
    for (const axis of ['x', 'y', 'z'] as const) {
      const low = Math.min(room.min[axis] + radius, 0.5 * (room.min[axis] + room.max[axis]));
      const high = Math.max(room.max[axis] - radius, 0.5 * (room.min[axis] + room.max[axis]));
      point[axis] = Math.min(high, Math.max(low, point[axis]));
    }
  };
}
