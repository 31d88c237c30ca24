import { attractors, createPhysicsWorld, keepState, rgba, rungeKutta4, spawn } from '@principia/physics';
import type { SceneRun } from '../../scene.ts';
import { defineExample } from '../define-example.ts';
import type { Point } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf, velocityOf } from '../support/read.ts';

const SUN = { x: 400, y: 300 };
const GM = 1e6;
/** The planets of the book: start, mass, period and eccentricity. */
const PLANETS = [
  {
    name: 'outer',
    at: { x: 400, y: 50 },
    v: { x: 65, y: 0 },
    mass: 10,
    period: 27.09,
    e: 0.0563,
    color: rgba(0.4, 0.7, 1),
  },
  {
    name: 'inner',
    at: { x: 500, y: 300 },
    v: { x: 0, y: 100 },
    mass: 3,
    period: 6.283,
    e: 0,
    color: rgba(1, 0.6, 0.4),
  },
  {
    name: 'middle',
    at: { x: 200, y: 300 },
    v: { x: 0, y: -70 },
    mass: 15,
    period: 17.251,
    e: 0.02,
    color: rgba(0.5, 0.9, 0.6),
  },
] as const;

/** Planets that a reader may add. */
const MAX_ADDED = 40;

interface Run extends SceneRun {
  readonly planets: readonly number[];
  /** Adds a planet; without a velocity it begins on a circle. */
  place(at: Point, velocity?: Point): void;
  /** Adds a planet at the next of some distances. */
  add(): void;
}

/** Velocity on a circle about the sun: as the inner planet turns. */
function circularVelocity(at: Point): Point {
  const [x, y] = [at.x - SUN.x, at.y - SUN.y];
  const r = Math.max(1, Math.sqrt(x * x + y * y));
  const speed = Math.sqrt(GM / r);
  return { x: (-y / r) * speed, y: (x / r) * speed };
}

/** Semi-major axis and eccentricity of the present orbit, from the energy and the angular momentum. */
function orbitOf({ world, planets }: Run, i: number) {
  const [at, v] = [positionOf(world, planets[i]), velocityOf(world, planets[i])];
  const [x, y] = [at.x - SUN.x, at.y - SUN.y];
  const energy = (v.x * v.x + v.y * v.y) / 2 - GM / Math.sqrt(x * x + y * y);
  const momentum = x * v.y - y * v.x;
  return { axis: -GM / (2 * energy), e: Math.sqrt(Math.max(0, 1 + (2 * energy * momentum * momentum) / (GM * GM))) };
}

export default defineExample({
  id: 'ch10-multiple-orbiters',
  title: 'Three planets and one sun',
  chapter: 10,
  tags: ['gravity', 'orbit', 'Kepler'],
  about:
    'Three planets go round a sun that is far heavier than they are. The nearer ones are faster and have less far to go. For all of them the square of the period grows as the cube of the size of the orbit, as Kepler found in 1618 and published in 1619. Their own masses do not matter.',
  duration: 60,
  parameters: {
    factor: { label: 'Factor of all speeds', unit: '×', initial: 1, min: 0.7, max: 1.25 },
    masses: { label: 'Factor of all masses', unit: '×', initial: 1, min: 0.1, max: 1000, scale: 'log' },
  },
  presets: [{ label: 'Slower planets', values: { factor: 0.8 } }],
  build({ factor, masses }, { integrator = rungeKutta4 }): Run {
    const world = createPhysicsWorld({ capacity: 8 + MAX_ADDED, forces: [attractors()], integrator });
    spawn(world, { position: SUN, attractor: GM, appearance: { size: 35, color: rgba(1, 0.8, 0.3) } });
    const planets = PLANETS.map(({ at, v, mass, color }) =>
      spawn(world, {
        position: at,
        velocity: { x: factor * v.x, y: factor * v.y },
        mass: masses * mass,
        appearance: { size: 9, color },
      }),
    );
    const added = { count: 0 };
    keepState(world, added);
    const place = (at: Point, velocity = circularVelocity(at)) => {
      if (added.count >= MAX_ADDED) return;
      added.count++;
      spawn(world, { position: at, velocity, mass: 1, appearance: { size: 6, color: rgba(1, 0.9, 0.5) } });
    };
    const add = () => place({ x: SUN.x + 120 + 10 * (added.count % 16), y: SUN.y });
    return { world, dt: 1 / 60, planets, place, add };
  },
  picture({ world, planets }) {
    return {
      yDown: true,
      view: { minX: 60, maxX: 740, minY: 10, maxY: 600 },
      trails: planets.map((body) => ({ body, length: 1000 })),
      arrows: planets.map((body) => velocityArrow(world, body, 0.6)),
    };
  },
  actions: { action: { label: 'Add', about: 'add a planet', key: 'n', press: ({ add }) => add() } },
  pointer: {
    about: 'place a planet there, on a circle about the sun; a drag gives it the velocity that you draw',
    aims: true,
    release({ place }, at, from) {
      const velocity = { x: at.x - from.x, y: at.y - from.y };
      // A click draws nothing.
      if (Math.abs(velocity.x) + Math.abs(velocity.y) < 5) place(from);
      else place(from, velocity);
    },
  },
  plots: (plot) => [
    plot(
      'Distances from the sun',
      'r, px',
      ...PLANETS.map(({ name }, i) => ({
        label: name,
        value: ({ world, planets }: Run) => distanceBetween(positionOf(world, planets[i]), SUN),
      })),
    ),
  ],
  checks: ({ at }) => [
    ...PLANETS.map(({ name, period }, i) => ({
      label: `Period of the ${name} planet`,
      unit: 's',
      exact: period,
      tolerance: { relative: 0.002 },
      at: {
        // The component of the place along the start velocity rises through zero once in each period.
        event: ({ world, planets }: Run) => {
          const { at, v } = PLANETS[i];
          const { x, y } = positionOf(world, planets[i]);
          return (x - at.x) * v.x + (y - at.y) * v.y;
        },
        from: 1,
        to: 2,
      },
    })),
    ...PLANETS.map(({ name, e }, i) =>
      at(
        30,
        `Eccentricity of the ${name} planet after 30 s`,
        { exact: e, absolute: 5.1e-5 },
        (run: Run) => orbitOf(run, i).e,
      ),
    ),
  ],
  tryThis: [
    'Make the planets a thousand times heavier: nothing changes, because the sun is fixed and they do not attract each other.',
    'Make them slower: all orbits become longer ellipses, with the sun in a focus.',
    'Press the picture anywhere: a planet begins on a circle there. Drag across, and it begins as you drew.',
  ],
});
