import {
  atan2,
  attractors,
  createPhysicsWorld,
  createRandom,
  dormandPrince,
  energy,
  log,
  rgba,
  spawn,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { star } from '../support/outline.ts';
import { positionOf, speedOf } from '../support/read.ts';
import { libration, rotatingFrame } from '../support/rotating-frame.ts';

type Values = ValuesOf<'ratio' | 'count' | 'spread'>;

/** Turns a second: a second is a year of the planet, a metre its distance from the sun. */
const SPIN = 2 * Math.PI;
const GM = SPIN * SPIN;
/** Amplitude of the yellow asteroid about L4, m. */
const SWING = 1e-5;
/** Nearest to the planet that asteroids start, °: what starts beside it falls onto it. */
const GAP = 20;

export default defineExample({
  id: 'ch17-trojans',
  title: 'Asteroids at the corners of a triangle',
  chapter: 17,
  tags: ['gravity', 'orbit', 'three bodies', 'stability', 'Lagrange points'],
  about:
    'We turn with the sun and a planet, so that both stand still. Sixty degrees before and behind the planet are Lagrange’s points L4 and L5, where gravity and the centrifugal force cancel. They are hills, not hollows: an asteroid rolls off, the Coriolis force bends its path round, and it stays. Jupiter keeps some ten thousand Trojans so.',
  duration: 60,
  conservesEnergy: true,
  parameters: {
    ratio: { label: 'Planet’s share', initial: 9.54e-4, min: 1e-4, max: 0.06, scale: 'log' },
    count: { label: 'Asteroids', initial: 200, min: 2, max: 1000, integer: true },
    spread: {
      label: 'Start within',
      unit: '°',
      initial: 25,
      min: 1,
      max: 110,
      about: `To both sides of the corner, but at least ${GAP}° from the planet`,
    },
  },
  presets: [
    { label: 'Horseshoes', values: { spread: 110 } },
    { label: 'A planet just too heavy', values: { ratio: 0.05, spread: 5 } },
  ],
  build({ ratio, count, spread }: Values, { seed, integrator = dormandPrince() }: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 1010, forces: [attractors(), rotatingFrame(SPIN)], integrator });
    const [sun, planet] = [
      { x: -ratio, y: 0 },
      { x: 1 - ratio, y: 0 },
    ];
    spawn(world, { position: sun, attractor: GM * (1 - ratio), appearance: { size: 0.07, color: rgba(1, 0.8, 0.3) } });
    spawn(world, { position: planet, attractor: GM * ratio, appearance: { size: 0.03, color: rgba(0.9, 0.6, 0.45) } });
    const random = createRandom(seed);
    const asteroids = Array.from({ length: count }, (_, i) => {
      const angle = (60 + random.uniform(Math.max(-spread, GAP - 60), spread)) * (i % 2 === 0 ? 1 : -1);
      const [place] = star(1, random.gaussian(1, 0.003), (angle * Math.PI) / 180);
      return spawn(world, {
        position: { x: sun.x + place.x, y: place.y },
        velocity: {},
        mass: 1,
        appearance: { size: 0.008, color: i % 2 === 0 ? rgba(0.43, 0.72, 1) : rgba(0.37, 0.84, 0.64) },
      });
    });
    const corner = { x: 1 / 2 - ratio, y: Math.sqrt(3) / 2 };
    const { displacement: d, velocity: v } = libration(ratio);
    const probe = spawn(world, {
      position: { x: corner.x + SWING * d.x, y: corner.y + SWING * d.y },
      velocity: { x: SPIN * SWING * v.x, y: SPIN * SWING * v.y },
      mass: 1,
      appearance: { size: 0.012, color: rgba(1, 0.88, 0.54) },
    });
    const start = energy(world).total;
    const strays = () => asteroids.filter((id, i) => positionOf(world, id).y > 0 !== (i % 2 === 0)).length;
    const degrees = (id: number) => {
      const { x, y } = positionOf(world, id);
      return (atan2(y, x - sun.x) * 180) / Math.PI;
    };
    return { world, dt: 1 / 240, sun, planet, corner, asteroids, probe, start, strays, degrees };
  },
  picture({ corner, planet, asteroids, probe }) {
    const { x, y } = corner;
    const points = [
      { name: 'L4', x, y },
      { name: 'L5', x, y: -y },
    ];
    return {
      view: { minX: -1.3, maxX: 1.3, minY: -1.25, maxY: 1.25 },
      fills: [{ shape: { minX: -50, maxX: 50, minY: -50, maxY: 50 }, color: 0x05070f }],
      curves: [{ points: pointsOf((a) => star(1, 1, a)[0], 0, SPIN), color: 0x2b3350, dashed: true }],
      lines: points.map((to) => ({ from: planet, to, color: 0x2b3350, width: 1 })),
      dots: points.map((at) => ({ at, radius: 3, color: COLORS.red })),
      labels: points.map((at) => ({ at: { x: at.x + 0.03, y: at.y + 0.05 }, text: at.name, color: COLORS.red })),
      trails: [...asteroids.slice(0, 2), probe].map((body) => ({ body, length: 1500, interval: 2 })),
    };
  },
  plots: (plot) => [
    plot(
      'Angle from the planet',
      'angle, °',
      { label: 'before it', value: ({ degrees, asteroids }) => degrees(asteroids[0]) },
      { label: 'behind it', value: ({ degrees, asteroids }) => degrees(asteroids[1]) },
    ),
  ],
  checks: ({ at, largest }) => [
    {
      label: 'Period of a small swing about L4',
      unit: 's',
      exact: ({ ratio }) => 1 / libration(ratio).frequency,
      tolerance: { relative: 1e-3 },
      at: { event: ({ world, probe, corner }) => positionOf(world, probe).y - corner.y, from: 2, to: 3 },
    },
    largest(60, 'Asteroids that left their side in 60 years', { exact: 0, absolute: 0 }, ({ strays }) => strays()),
    at(
      60,
      'Change of Jacobi’s constant, as a fraction',
      { exact: 0, absolute: 1e-6 },
      ({ world, start }) => energy(world).total / start - 1,
    ),
    {
      label: 'Growth of the speed in two swings about L4, ln',
      exact: ({ ratio }) => (4 * Math.PI * libration(ratio).growth) / libration(ratio).frequency,
      tolerance: { relative: 0.01 },
      at: { event: ({ world, probe, corner }) => positionOf(world, probe).y - corner.y, from: 2, to: 4 },
      measure: ({ world, probe }) => log(speedOf(world, probe)),
      preset: 'A planet just too heavy',
    },
  ],
  tryThis: [
    'Choose “Horseshoes”: some go all the way round to the other side of the planet, and come back.',
    'Choose “A planet just too heavy”: beyond 3.85 % of the whole mass the paths wind outwards, and both crowds scatter.',
    'Make the planet lighter: the swings are slower, as the root of its mass.',
  ],
});
