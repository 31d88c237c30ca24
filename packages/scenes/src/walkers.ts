/** Characters that walk as a component says, in which a rewound world finds what they wanted. */
import {
  type ColumnsOf,
  capsule,
  columnsOf,
  defineComponent,
  moveCharacter,
  type PhysicsWorld,
  realField,
  spawn,
} from '@principia/physics';
import { addComponent, set } from 'bitecs';

/** Radius of a walker, and height of its middle above its feet, m. */
export const WALKER = { radius: 0.28, middle: 0.7, density: 100 } as const;

/** The gap under its feet, m. */
export const GAP = WALKER.radius / 30;

/** What a walker wants, and how fast it is. */
export const Walker = defineComponent({
  fields: {
    /** Wanted speed to the right. */
    wanted: realField('m/s'),
    /** Speed of the jump that it wants, 0 for none. */
    jump: realField('m/s'),
    velocityX: realField('m/s'),
    velocityY: realField('m/s'),
    grounded: realField(''),
    /** It turns round at these places, unless they are the same. */
    from: realField('m'),
    to: realField('m'),
  },
});

export interface WalkerOptions {
  readonly gravity: number;
  /** Steepest slope to walk on, rad. */
  readonly maxSlope: number;
  /** Highest step, m. */
  readonly stepHeight: number;
}

const UPRIGHT = capsule(2 * (WALKER.middle - WALKER.radius), WALKER.radius);

/** Adds a walker with its feet at a place. Walkers pass through each other. */
export function addWalker(world: PhysicsWorld, feet: { x: number; y: number }, appearance: number, own: object = {}) {
  const id = spawn(world, {
    position: { x: feet.x, y: feet.y + WALKER.middle + GAP },
    rotation: { angle: Math.PI / 2 },
    velocity: {},
    kinematic: {},
    collider: { shape: UPRIGHT, density: WALKER.density, layers: 2, mask: 1 },
    appearance,
  });
  addComponent(world, id, set(columnsOf(world, Walker), own));
  return id;
}

/** Moves the walkers before each step. */
export function moveWalkers(world: PhysicsWorld, ids: readonly number[], options: WalkerOptions): void {
  const walker = columnsOf(world, Walker);
  world.phases.input.push((_, dt) => {
    for (const id of ids) moveWalker(world, walker, id, dt, options);
  });
}

function moveWalker(
  world: PhysicsWorld,
  walker: ColumnsOf<typeof Walker>,
  id: number,
  dt: number,
  { gravity, maxSlope, stepHeight }: WalkerOptions,
): void {
  const x = world.components.Position.x[id];
  if (walker.to[id] > walker.from[id]) {
    if (x > walker.to[id]) walker.wanted[id] = -Math.abs(walker.wanted[id]);
    if (x < walker.from[id]) walker.wanted[id] = Math.abs(walker.wanted[id]);
  }
  const jumps = walker.jump[id] > 0 && walker.grounded[id] === 1;
  // A jump begins with half a step of gravity, which puts every step on the parabola.
  const y = jumps ? walker.jump[id] - 0.5 * gravity * dt : walker.velocityY[id] - gravity * dt;
  // In the air it steers, or keeps its speed.
  const wanted = walker.wanted[id];
  const flies = walker.grounded[id] === 0 && wanted === 0;
  const velocity = { x: flies ? walker.velocityX[id] : wanted, y };
  const motion = moveCharacter(world, id, velocity, dt, { maxSlope, stepHeight });
  walker.velocityX[id] = motion.velocity.x;
  walker.velocityY[id] = motion.velocity.y;
  walker.grounded[id] = motion.grounded ? 1 : 0;
}
