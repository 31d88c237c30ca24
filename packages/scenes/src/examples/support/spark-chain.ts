/** Sparks that burst into new sparks when their life ends. */
import {
  burst,
  createEmitter,
  type Emitter,
  emitterCounts,
  endings,
  keepState,
  type PhysicsWorld,
  quadraticDrag,
  rgba,
  uniformGravity,
} from '@principia/physics';
import type { Point } from '../picture.ts';

/** Sparks whose life ends later than this burst no more, s after the launch. */
const CUT_OFF = 6;
/** Lifetimes are drawn between these, s; so three generations are all. */
const LIFETIME = [2, 4] as const;

/** Gravity downwards and drag of a terminal speed of 44.72 px/s. */
export const SPARK_FORCES = [uniformGravity({ y: 10 }), quadraticDrag()];

export interface SparkChain {
  /** Starts `copies` times `count` sparks at a point; each that ends early enough becomes `count` new ones. */
  launch(point: Point, count: number, copies?: number): void;
  /** Sparks that glow now, and that were born so far. */
  alive(): number;
  born(): number;
}

/** Sparks of three generations, each in a colour of its own. */
export function createSparkChain(world: PhysicsWorld, capacity: number): SparkChain {
  const colors = [rgba(1, 1, 0.2), rgba(0.3, 1, 0.3), rgba(1, 0.45, 0.8)];
  const generations = colors.map((color, i) =>
    createEmitter(world, {
      capacity: Math.max(2, Math.ceil(capacity * [0.02, 0.15, 0.83][i])),
      speed: 0,
      velocitySpread: { x: 75, y: 50 },
      lifetime: LIFETIME,
      mass: 1,
      quadraticDrag: 0.005,
      // Dark after 3.33 s, whatever the life.
      color: [color, color & 0x00ffffff],
      size: 2.5,
      reportEndings: true,
    }),
  );
  const state = { start: 0, count: 0 };
  keepState(world, state);
  world.phases.input.push(() => {
    if (world.time - state.start >= CUT_OFF) return;
    for (let i = 0; i + 1 < generations.length; i++) burstEndings(generations[i], generations[i + 1], state.count);
  });
  const sum = (key: 'alive' | 'born') => generations.reduce((total, emitter) => total + emitterCounts(emitter)[key], 0);
  return {
    launch(point, count, copies = 1) {
      state.start = world.time;
      state.count = count;
      burst(generations[0], count * copies, { position: point });
    },
    alive: () => sum('alive'),
    born: () => sum('born'),
  };
}

function burstEndings(from: Emitter, to: Emitter, count: number): void {
  const ended = endings(from);
  for (let k = 0; k < ended.count; k++) {
    burst(to, count, { position: { x: ended.states[6 * k], y: ended.states[6 * k + 1] } });
  }
}
