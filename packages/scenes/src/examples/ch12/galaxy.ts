import { cos, createPhysicsWorld, createRandom, enclosedMassGravity, exp, rgba, sin, spawn } from '@principia/physics';
import type { SceneRun } from '../../scene.ts';
import { defineExample } from '../define-example.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

const CENTRE = { x: 300, y: 300 };
const [NUCLEUS, INNER, OUTER] = [1e5, 20, 300];
/** Mass of all stars, spread evenly over their distances from the centre. */
const STARS = 5e4;

/** Dark matter within each whole distance: the sum of 1000 l² exp(−√l). */
const DARK: readonly number[] = Array.from({ length: 501 }).reduce<number[]>((sums, _, l) => {
  sums.push((sums[l - 1] ?? 0) + 1000 * l * l * exp(-Math.sqrt(l)));
  return sums;
}, []);

/** Mass within a whole distance, kg. */
const massWithin = (r: number, dark: number) =>
  NUCLEUS + STARS * Math.min(1, Math.max(0, (r - INNER) / (OUTER - INNER))) + dark * DARK[r];
const circular = (r: number, dark: number) => {
  const below = Math.floor(r);
  const part = r - below;
  const mass = massWithin(below, dark) * (1 - part) + massWithin(below + 1, dark) * part;
  return Math.sqrt(mass / r);
};

interface Run extends SceneRun {
  readonly stars: readonly number[];
  readonly starts: readonly number[];
  readonly speedOn: (r: number) => number;
}

const SPEEDS = [
  [20, 92.852337],
  [100, 58.172664],
  [200, 43.066573],
  [300, 36.049415],
] as const;

export default defineExample({
  id: 'ch12-galaxy',
  title: 'A galaxy held together by what nobody sees',
  chapter: 12,
  tags: ['gravity', 'galaxy', 'dark matter', 'n-body'],
  about:
    'A star feels only the mass that is nearer to the centre than itself: the nucleus, other stars, and dark matter. Each star here has just the speed for a circle. Without the dark matter that speed would be too high in the outer parts, and they would fly off: that is how astronomers know that it is there.',
  duration: 60,
  parameters: {
    count: { label: 'Stars shown', initial: 1000, min: 10, max: 5000, integer: true },
    factor: { label: 'Speed over that for a circle', unit: '×', initial: 1, min: 0.2, max: 1.4 },
    dark: { label: 'Dark matter', unit: '×', initial: 1, min: 0, max: 2 },
  },
  presets: [
    { label: 'Without dark matter', values: { dark: 0 } },
    { label: 'Too slow', values: { factor: 0.4 } },
  ],
  build({ count, factor, dark }, { seed, ...options }): Run {
    const radii = Array.from({ length: 49 }, (_, i) => 20 + 10 * i);
    const masses = radii.map((r) => massWithin(r, dark));
    const force = enclosedMassGravity({ radii, masses, centre: CENTRE, gravitationalConstant: 1 });
    const world = createPhysicsWorld({ capacity: 5100, forces: [force], ...options });
    spawn(world, { position: CENTRE, appearance: { size: INNER, color: rgba(1, 0.9, 0.7) } });
    const random = createRandom(seed);
    const starts: number[] = [];
    const stars = Array.from({ length: count }, () => {
      const [r, angle] = [random.uniform(INNER + 1, OUTER), random.uniform(0, 2 * Math.PI)];
      // The stars always start with the speed that suits the usual dark matter.
      const speed = factor * circular(r, 1);
      starts.push(r);
      return spawn(world, {
        position: { x: CENTRE.x + r * cos(angle), y: CENTRE.y + r * sin(angle) },
        velocity: { x: -speed * sin(angle), y: speed * cos(angle) },
        mass: 10,
        appearance: { size: 1.5, color: rgba(1, 0.95, random.uniform(0.5, 1)) },
      });
    });
    return { world, dt: 1 / 60, stars, starts, speedOn: (r) => circular(r, dark) };
  },
  picture() {
    return {
      view: { minX: -60, maxX: 660, minY: -60, maxY: 660 },
      fills: [{ shape: { minX: -3000, maxX: 4000, minY: -3000, maxY: 4000 }, color: 0x05070f }],
    };
  },
  plots: (plot) => [
    plot('Mean distance of the stars from the centre', 'r, px', {
      label: 'stars',
      value: ({ world, stars }) =>
        stars.reduce((sum, id) => sum + distanceBetween(positionOf(world, id), CENTRE), 0) / stars.length,
    }),
  ],
  checks: ({ at, largest }) => [
    at(0, 'Dark matter within 300 px', { exact: 239868.0996, unit: 'kg', relative: 1e-9 }, () => DARK[300]),
    ...SPEEDS.map(([r, exact]) =>
      at(0, `Speed on a circle at ${r} px, √(GM/r)`, { exact, unit: 'px/s', absolute: 5e-7 }, ({ speedOn }) =>
        speedOn(r),
      ),
    ),
    largest(
      30,
      'Largest change of a star’s distance in 30 s, of the distance',
      { exact: 0, absolute: 0.02 },
      ({ world, stars, starts }) =>
        stars.reduce((most, id, i) => {
          const r = distanceBetween(positionOf(world, id), CENTRE);
          return Math.max(most, Math.abs(r / starts[i] - 1));
        }, 0),
    ),
  ],
  tryThis: [
    'Choose “Without dark matter”: the stars are too fast for what is left, and the galaxy spreads.',
    'Choose “Too slow”: the stars fall in, pass near the nucleus, and fill the disc with rosettes.',
  ],
});
