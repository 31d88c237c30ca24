import { attractors, createPhysicsWorld, type PhysicsWorld, rgba, spawn, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { distanceBetween, lengthOf, positionOf, velocityOf } from '../support/read.ts';

const SUN = { x: 275, y: 200 };
const START = { x: 200, y: 50 };
const GM = 1e6;

/** Velocities at the start, with the semi-major axis, eccentricity and period to which they lead. */
const LAUNCHES = [
  { vx: 80, vy: -40, a: 254.73, e: 0.3416, T: 25.545, color: rgba(0.42, 0.72, 1) },
  { vx: 70, vy: -40, a: 184.31, e: 0.1057, T: 15.722, color: rgba(1, 0.7, 0.28) },
  { vx: 85, vy: -40, a: 322.51, e: 0.4805, T: 36.391, color: rgba(0.37, 0.84, 0.64) },
  { vx: 80, vy: 0, a: 180.97, e: 0.452, T: 15.297, color: rgba(1, 0.48, 0.45) },
  { vx: 100, vy: 0, a: 519.29, e: 0.7528, T: 74.353, color: rgba(0.72, 0.61, 1) },
  { vx: 105, vy: 0, a: 1110.25, e: 0.8812, T: 232.44, color: rgba(1, 0.88, 0.54) },
] as const;

interface Launched {
  readonly world: PhysicsWorld;
  radialSpeed(i: number): number;
  eccentricity(i: number): number;
}

export default defineExample({
  id: 'ch06-orbits-presets',
  title: 'Six throws, six orbits',
  chapter: 6,
  tags: ['gravity', 'orbit', 'kepler'],
  about:
    'Six planets start at the same place with different velocities. All fly along ellipses with the sun in a focus, and all come back to where they started. The long ellipses take much longer: the square of the period goes with the cube of the size, as Kepler found before anybody knew of gravity.',
  duration: 480,
  parameters: {
    launches: { label: 'Number of planets', initial: 6, min: 1, max: 6, integer: true },
    mass: { label: 'Gravity of the sun', initial: 1, min: 0.98, max: 2 },
  },
  build({ launches, mass }: ValuesOf<'launches' | 'mass'>, { integrator = velocityVerlet }: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 16, forces: [attractors()], integrator });
    spawn(world, { position: SUN, attractor: GM * mass, appearance: { size: 70, color: rgba(1, 0.8, 0.3) } });
    const planets = LAUNCHES.slice(0, launches).map(({ vx, vy, color }) =>
      spawn(world, { position: START, velocity: { x: vx, y: vy }, mass: 1, collider: 16, appearance: color }),
    );
    const radialSpeed = (i: number) => {
      const [p, v] = [positionOf(world, planets[i]), velocityOf(world, planets[i])];
      return (p.x - SUN.x) * v.x + (p.y - SUN.y) * v.y;
    };
    // Length of the vector (v² − GM/r) r/GM − (r·v) v/GM, which points to the nearest place.
    const eccentricity = (i: number) => {
      const [{ x, y }, v] = [positionOf(world, planets[i]), velocityOf(world, planets[i])];
      const [dx, dy, along] = [x - SUN.x, y - SUN.y, radialSpeed(i)];
      const factor = v.x * v.x + v.y * v.y - (GM * mass) / distanceBetween({ x, y }, SUN);
      return lengthOf({ x: factor * dx - along * v.x, y: factor * dy - along * v.y }) / (GM * mass);
    };
    return { world, dt: 1 / 60, planets, radialSpeed, eccentricity };
  },
  picture: ({ planets }) => ({
    yDown: true,
    view: { minX: -1500, maxX: 1700, minY: -150, maxY: 2250 },
    trails: planets.map((body) => ({ body, length: 2000, interval: 6 })),
  }),
  plots: (plot) => [
    plot(
      'Distance from the sun',
      'r, px',
      ...[0, 1].map((i) => ({
        label: `planet ${i + 1}`,
        value: ({ world, planets }: { world: Parameters<typeof positionOf>[0]; planets: readonly number[] }) =>
          distanceBetween(positionOf(world, planets[i % planets.length]), SUN),
      })),
    ),
  ],
  checks: LAUNCHES.flatMap(({ vx, vy, a, e, T }, i) => [
    {
      label: `Period of the throw (${vx}, ${-vy}): ${T} s`,
      unit: 's',
      exact: T,
      tolerance: { relative: 1e-3 },
      at: { event: ({ radialSpeed }: Launched) => radialSpeed(i), from: 1, to: 2 },
    },
    {
      // The time of a perihelion in periods by Kepler's law from the axis alone.
      label: 'The same in units of 2π √(a³/GM)',
      exact: 1,
      tolerance: { relative: 1e-3 },
      at: { event: ({ radialSpeed }: Launched) => radialSpeed(i), from: 1, to: 2 },
      measure: ({ world }: Launched) => world.time / (2 * Math.PI * a * Math.sqrt(a / GM)),
    },
    {
      label: 'Its eccentricity, far from the start: below 1, so it comes back',
      exact: e,
      tolerance: { absolute: 1e-3 },
      at: { time: T / 2 },
      measure: ({ eccentricity }: Launched) => eccentricity(i),
    },
  ]),
  tryThis: [
    'Make the gravity of the sun a little stronger: the widest orbit shrinks by far the most.',
    'Watch the planets pass near the sun: whoever comes from far away is fastest there.',
  ],
});
