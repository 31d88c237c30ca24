// Fountains of sparks: particles are born and expire continuously without creating or removing entities. The population
// is steady from the first step, because the first sparks have uniformly drawn remaining lifetimes.
import {
  burst,
  createEmitter,
  createPhysicsWorld,
  type Emitter,
  quadraticDrag,
  semiImplicitEuler,
  setEmitter,
  step,
  uniformGravity,
} from '@principia/physics';
import { countOf, defineScene, type SceneRun } from './scene.ts';

/** A run with its emitters. */
export interface Sparks extends SceneRun {
  readonly emitters: readonly Emitter[];
}

const DT = 1 / 60;
/** Distance of the fountains, m. */
const SPACING = 20;
const SPARK_MASS = 0.001;

/** Fountains of sparks that are born, fall and end, a tenth of them every second. */
export const emitters = defineScene({
  name: 'emitters',
  description: 'fountains of sparks that are born, fall and end, a tenth of them every second',
  precision: 'f32',
  parameters: {
    count: countOf('sparks alive', 100_000, 4_000_000),
    fountains: { about: 'emitters', unit: '', initial: 10, min: 1, max: 1000, integer: true },
    lifetime: { about: 'life of a spark', unit: 's', initial: 10, min: 0.1, max: 1000 },
    speed: { about: 'largest speed at birth', unit: 'm/s', initial: 40, min: 0, max: 1000 },
    drag: { about: 'drag coefficient of a spark', unit: 'kg/m', initial: 1e-5, min: 0, max: 1 },
  },
  build({ dimensions, precision, seed, progress, parameters }): Sparks {
    const { count, lifetime, speed, drag } = parameters;
    const fountains = Math.min(parameters.fountains, count);
    const each = Math.ceil(count / fountains);
    // The first sparks expire at random times, so their number fluctuates by its square root, which needs spare
    // capacity.
    const capacity = each + Math.ceil(4 * Math.sqrt(each) + (2 * DT * each) / lifetime);
    const world = createPhysicsWorld({
      dimensions,
      precision,
      seed,
      capacity: fountains * capacity,
      integrator: semiImplicitEuler,
      forces: [uniformGravity(), quadraticDrag()],
    });
    const made = Array.from({ length: fountains }, (_, f) => {
      const position = { x: (f - (fountains - 1) / 2) * SPACING };
      const motion = { speed: [0.2 * speed, speed], spread: 0.5, mass: SPARK_MASS, quadraticDrag: drag } as const;
      // The count need not be a multiple of the number of fountains.
      const sparks = Math.floor(((f + 1) * count) / fountains) - Math.floor((f * count) / fountains);
      const emitter = createEmitter(world, { capacity, position, lifetime: [1e-6, lifetime], ...motion });
      burst(emitter, sparks);
      progress?.(Math.floor(((f + 1) * count) / fountains), count);
      return { emitter, sparks };
    });
    step(world, DT);
    for (const { emitter, sparks } of made) setEmitter(emitter, { lifetime, rate: sparks / lifetime });
    return { world, dt: DT, emitters: made.map(({ emitter }) => emitter), losesEnergy: 'sparks are born and expire' };
  },
});
