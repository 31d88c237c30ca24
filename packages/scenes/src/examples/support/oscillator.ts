/** An oscillator of 1 kg with the angular frequency 1/s, to see what an integrator does to its amplitude. */
import {
  cos,
  createPhysicsWorld,
  energy,
  type Integrator,
  type PhysicsWorld,
  powerLaw,
  sin,
  spawn,
} from '@principia/physics';
import type { ExampleParameter } from '../define-example.ts';
import { COLORS, type Picture, pointsOf } from '../picture.ts';
import type { Plot } from '../plot.ts';
import { lengthOf, positionOf, velocityOf } from './read.ts';

/** Amplitude at the start, px. */
export const AMPLITUDE = 200;

export interface OscillatorRun {
  readonly world: PhysicsWorld;
  readonly ball: number;
  readonly dt: number;
  /** √(x² + v²) of the present state, px: constant in the exact motion. */
  amplitude(): number;
  /** Energy as a fraction of that at the start, less 1. */
  energyError(): number;
}

export const rateParameter: ExampleParameter = {
  label: 'Steps per second',
  unit: '1/s',
  initial: 60,
  min: 2,
  max: 240,
  scale: 'log',
};

export function oscillator(rate: number, integrator: Integrator): OscillatorRun {
  const forces = [powerLaw({ strength: -1, exponent: 1 })];
  const world = createPhysicsWorld({ capacity: 4, forces, integrator });
  const ball = spawn(world, { position: { x: -AMPLITUDE }, velocity: {}, mass: 1 });
  const start = energy(world).total;
  return {
    world,
    ball,
    dt: 1 / rate,
    amplitude: () => lengthOf({ x: positionOf(world, ball).x, y: velocityOf(world, ball).x }),
    energyError: () => energy(world).total / start - 1,
  };
}

/** The path in the plane of place and velocity: a circle in the exact motion. */
export function phasePicture({ world, ball }: OscillatorRun, reach: number): Picture {
  const now = () => ({ x: positionOf(world, ball).x, y: velocityOf(world, ball).x });
  const circle = (angle: number) => ({ x: -AMPLITUDE * cos(angle), y: AMPLITUDE * sin(angle) });
  return {
    // The axes have the same scale, so that a circle looks round.
    graph: { x: { label: 'place, px' }, y: { label: 'velocity, px/s' } },
    view: { minX: -1.6 * reach, maxX: 1.6 * reach, minY: -reach, maxY: reach },
    curves: [{ points: pointsOf(circle, 0, 2 * Math.PI), now: circle, label: 'exact', color: COLORS.white }],
    lines: [{ from: { x: 0, y: 0 }, to: now, color: COLORS.grey, width: 1 }],
    dots: [
      { at: () => ({ x: now().x, y: 0 }), radius: 9, color: COLORS.blue },
      { at: now, radius: 7 },
    ],
  };
}

export const amplitudePlot: Plot<OscillatorRun, unknown> = {
  title: 'Amplitude',
  y: { label: 'amplitude, px' },
  series: [{ label: 'stepped', value: ({ amplitude }) => amplitude(), exact: () => AMPLITUDE }],
};

/** The n-th power by multiplication, which is the same on every engine. */
export function integerPower(base: number, n: number): number {
  let product = 1;
  for (let i = 0; i < n; i++) product *= base;
  return product;
}
