import {
  createPhysicsWorld,
  createRandom,
  mutualGravity,
  type PhysicsWorld,
  type Random,
  rgba,
  spawn,
  velocityVerlet,
} from '@principia/physics';
import { type BuildOptions, choiceOf, defineExample, type ValuesOf } from '../define-example.ts';
import type { Point } from '../picture.ts';
import { rootOf } from '../support/functions.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

type Values = ValuesOf<'count' | 'mass' | 'turn'>;

/** Nearest distance of the two on their parabola, and their distance at the start, m. */
const [NEAREST, START] = [1.6, 8];

/** Barker's equation: time from the nearest point until tan(φ/2) = d, s, and back. Murray and Dermott, section 2.4. */
const barker = (d: number, mass: number) =>
  Math.sqrt((2 * NEAREST * NEAREST * NEAREST) / (1 + mass)) * (d + (d * d * d) / 3);
const TANGENT = Math.sqrt(START / NEAREST - 1);
const distanceAt = (t: number, mass: number) => {
  const d = rootOf((x) => barker(x, mass) - (t - barker(TANGENT, mass)), -10, 10);
  return NEAREST * (1 + d * d);
};

/** Place and velocity of the second galaxy, seen from the first, on the parabola r = 2 q/(1 + cos φ). */
function approach(mass: number): { place: Point; velocity: Point } {
  const c = (2 * NEAREST) / START - 1;
  const s = -Math.sqrt(1 - c * c);
  const speed = Math.sqrt((1 + mass) / (2 * NEAREST));
  return { place: { x: START * c, y: START * s }, velocity: { x: -speed * s, y: speed * (1 + c) } };
}

const times = ({ x, y }: Point, factor: number) => ({ x: factor * x, y: factor * y });

interface Disc {
  readonly centre: Point;
  readonly drift: Point;
  readonly mass: number;
  readonly count: number;
  /** 1 for stars that go round as the galaxies do, −1 for the other way. */
  readonly turn: number;
  readonly color: number;
}

/** A heavy centre with light stars on circles. @returns the centre */
function addGalaxy(world: PhysicsWorld, random: Random, { centre, drift, mass, count, turn, color }: Disc): number {
  for (let i = 0; i < count; i++) {
    const r = Math.sqrt(random.uniform(0.09 * mass, mass));
    const { x, y } = random.onCircle(r);
    const rate = (turn * Math.sqrt(mass / r)) / r;
    spawn(world, {
      position: { x: centre.x + x, y: centre.y + y },
      velocity: { x: drift.x - rate * y, y: drift.y + rate * x },
      mass: 1e-9,
      testParticle: {},
      appearance: { size: 0.03, color },
    });
  }
  const appearance = { size: 0.12, color: rgba(1, 0.95, 0.8) };
  return spawn(world, { position: centre, velocity: drift, mass, appearance });
}

export default defineExample({
  id: 'ch17-galaxy-collision',
  title: 'Two galaxies draw tails out of each other',
  chapter: 17,
  tags: ['gravity', 'galaxy', 'orbit', 'tides', 'n-body'],
  about:
    'Two galaxies pass on a parabola. Each is a heavy centre with light stars around it, which attract nothing: so the brothers Toomre computed it in 1972. Stars on the near side are pulled over as a bridge, and those on the far side are left behind as a long tail. Such tails are seen in the sky, at the Antennae and the Mice.',
  duration: 30,
  parameters: {
    count: { label: 'Stars of each', initial: 900, min: 10, max: 4000, integer: true },
    mass: { label: 'Mass of the second', unit: '×', initial: 1, min: 0.1, max: 1 },
    turn: choiceOf('Stars turn', ['with', 'against']),
  },
  presets: [
    { label: 'Turning against the orbit', values: { turn: 1 } },
    { label: 'A small companion', values: { mass: 0.25 } },
  ],
  build({ count, mass, turn }: Values, { seed, integrator = velocityVerlet }: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 8010, forces: [mutualGravity({ G: 1 })], integrator });
    const random = createRandom(seed);
    const { place, velocity } = approach(mass);
    const disc = { count, turn: turn === 0 ? 1 : -1 };
    const [first, second] = [-mass / (1 + mass), 1 / (1 + mass)];
    const centres = [
      { centre: times(place, first), drift: times(velocity, first), mass: 1, color: rgba(0.55, 0.75, 1) },
      { centre: times(place, second), drift: times(velocity, second), mass, color: rgba(1, 0.72, 0.42) },
    ].map((galaxy) => addGalaxy(world, random, { ...disc, ...galaxy }));
    const distance = () => distanceBetween(positionOf(world, centres[0]), positionOf(world, centres[1]));
    return { world, dt: 1 / 60, centres, distance };
  },
  picture({ centres }) {
    return {
      view: { minX: -8.5, maxX: 8.5, minY: -7.5, maxY: 7.5 },
      fills: [{ shape: { minX: -300, maxX: 300, minY: -300, maxY: 300 }, color: 0x05070f }],
      trails: centres.map((body) => ({ body, length: 1200, interval: 4, color: 0x39425e })),
    };
  },
  plots: (plot) => [
    plot('Distance of the centres', 'r, m', {
      label: 'stepped',
      value: ({ distance }) => distance(),
      exact: (t, { mass }: Values) => distanceAt(t, mass),
    }),
  ],
  checks: ({ at, smallest }) => [
    smallest(
      20,
      'Nearest distance of the centres, that of the parabola',
      { exact: NEAREST, unit: 'm', relative: 1e-4 },
      ({ distance }) => distance(),
    ),
    at(
      25,
      'Distance after 25 s, by Barker’s equation',
      { exact: ({ mass }) => distanceAt(25, mass), unit: 'm', relative: 1e-4 },
      ({ distance }) => distance(),
    ),
  ],
  tryThis: [
    'Choose “Turning against the orbit”: the stars meet the other galaxy only shortly, and hardly any tail is drawn.',
    'Choose “A small companion”: the large galaxy grows one spiral arm towards it and one away, as the Whirlpool has them.',
  ],
});
