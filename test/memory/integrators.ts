/** A program for `node --expose-gc`: prints as JSON how many bytes a step of the named integrator allocates and keeps. */
import { getHeapStatistics } from 'node:v8';
import {
  boris,
  createPhysicsWorld,
  INTEGRATORS,
  type Integrator,
  type IntegratorName,
  mutualGravity,
  type PhysicsWorld,
  powerLaw,
  spawn,
  step,
  wisdomHolman,
  xpbd,
} from '@principia/physics';

declare const gc: () => void;

const STEPS = 3000;
/** Steps before the measurement: code that is not compiled yet allocates iterators and numbers. */
const WARM = 10_000;
/** Bytes per step that the measurement itself allocates; a larger result is measured again. */
const NOISE = 8;
const heap = () => getHeapStatistics().used_heap_size;

/** Bodies in a harmonic potential, or planets around a star for Wisdom-Holman. No force depends on time. */
function build(name: string): PhysicsWorld {
  const forces = name === 'wisdomHolman' ? [mutualGravity({ G: 1 })] : [powerLaw({ strength: -1, exponent: 1 })];
  const world = createPhysicsWorld({ dimensions: 3, capacity: 110, integrator: integratorOf(name), forces });
  spawn(world, { position: {}, velocity: {}, mass: 1 });
  for (let i = 1; i < 100; i++) {
    const r = 1 + i;
    spawn(world, { position: { x: r }, velocity: { y: 1 / Math.sqrt(r), z: 1e-3 }, mass: 1e-6, charge: 1e-3 });
  }
  return world;
}

function integratorOf(name: string): Integrator {
  if (name === 'wisdomHolman') return wisdomHolman({ G: 1 });
  if (name === 'boris') return boris({ field: { z: 1 } });
  return name === 'xpbd' ? xpbd() : INTEGRATORS[name as IntegratorName].create();
}

function measure(name: string): { allocated: number; kept: number } {
  const world = build(name);
  for (let i = 0; i < WARM; i++) step(world, 0.02);
  const round = () => {
    gc();
    const start = heap();
    for (let i = 0; i < STEPS; i++) step(world, 0.02);
    const allocated = heap() - start;
    gc();
    return { allocated: allocated / STEPS, kept: (heap() - start) / STEPS };
  };
  // A leak shows in every round; a compiler that has changed its mind, and works when it has the time, only in some.
  const rounds = [round(), round(), round()];
  const least = (key: 'allocated' | 'kept') => Math.min(...rounds.map((each) => each[key]));
  while (rounds.length < 12 && least('allocated') > NOISE) rounds.push(round());
  return { allocated: least('allocated'), kept: least('kept') };
}

process.stdout.write(JSON.stringify(measure(process.argv[2])));
