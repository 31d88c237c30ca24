/** Two balls that meet head-on on a line. */
import {
  createPhysicsWorld,
  energy,
  momentum,
  type PhysicsWorldOptions,
  particleContacts,
  rgba,
  spawn,
} from '@principia/physics';
import type { Picture } from '../picture.ts';
import { velocityArrow } from './arrows.ts';
import { velocityOf } from './read.ts';

/** Mass, kg, and velocity before, px/s, of the left and of the right ball. */
export interface Encounter {
  readonly m1: number;
  readonly m2: number;
  readonly u1: number;
  readonly u2: number;
  readonly e: number;
}

/** The parameters that both examples have. */
export const ENCOUNTER_PARAMETERS = {
  m1: { label: 'Mass of the left ball', unit: 'kg', initial: 1, min: 0.1, max: 200, scale: 'log' },
  m2: { label: 'Mass of the right ball', unit: 'kg', initial: 125, min: 0.1, max: 200, scale: 'log' },
  u1: { label: 'Velocity of the left ball', unit: 'px/s', initial: 250, min: 100, max: 300 },
  u2: { label: 'Velocity of the right ball', unit: 'px/s', initial: 50, min: -100, max: 60 },
} as const;

/** Velocity of a ball of mass m₁ after it met one of m₂: (m₁ u₁ + m₂ u₂ + m₂ e (u₂ − u₁))/(m₁ + m₂). */
export function velocityAfter(e: number, [m1, u1]: readonly number[], [m2, u2]: readonly number[]): number {
  return (m1 * u1 + m2 * u2 + m2 * e * (u2 - u1)) / (m1 + m2);
}

/** Energy that is lost, ½ μ (1 − e²) (u₁ − u₂)² with the reduced mass μ. */
export function lostEnergy({ m1, m2, u1, u2, e }: Encounter): number {
  const reduced = (m1 * m2) / (m1 + m2);
  return (reduced * (1 - e * e) * (u1 - u2) * (u1 - u2)) / 2;
}

const radiusOf = (mass: number) => Math.min(60, 15 + 4 * Math.sqrt(mass));

export function meetOnLine({ m1, m2, u1, u2, e }: Encounter, options: PhysicsWorldOptions) {
  const world = createPhysicsWorld({ preset: particleContacts, capacity: 4, ...options });
  const add = (x: number, speed: number, mass: number, appearance: number) =>
    spawn(world, {
      position: { x, y: 0 },
      velocity: { x: speed },
      mass,
      collider: { radius: radiusOf(mass), restitution: e },
      appearance,
    });
  const left = add(60 - radiusOf(m1), u1, m1, rgba(0.95, 0.4, 0.35));
  const right = add(180 + radiusOf(m2), u2, m2, rgba(0.4, 0.65, 1));
  const start = { momentum: momentum(world).x, energy: energy(world).kinetic };
  return { world, dt: 1 / 60, left, right, start, v: (id: number) => velocityOf(world, id).x };
}

type EncounterRun = ReturnType<typeof meetOnLine>;

export const encounterPicture = ({ world, left, right }: EncounterRun): Picture => ({
  view: { minX: -80, maxX: 620, minY: -180, maxY: 180 },
  arrows: [velocityArrow(world, left, 0.4), velocityArrow(world, right, 0.4)],
});

export const ENCOUNTER_PLOTS = [
  {
    title: 'Velocities',
    y: { label: 'v, px/s' },
    series: [
      { label: 'left', value: ({ left, v }: EncounterRun) => v(left) },
      { label: 'right', value: ({ right, v }: EncounterRun) => v(right) },
    ],
  },
  {
    title: 'Energy of motion',
    y: { label: 'E, J' },
    series: [{ label: 'both', value: ({ world }: EncounterRun) => energy(world).kinetic }],
  },
] as const;
