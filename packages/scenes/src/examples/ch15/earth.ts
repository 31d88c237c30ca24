import { atan2, createPhysicsWorld, rgba, spawn, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { globeLines, point, pointOn, rotate, rotationAbout, times } from '../support/space.ts';

const RADIUS = 100;

export default defineExample({
  id: 'ch15-earth',
  title: 'The spinning Earth',
  chapter: 15,
  tags: ['3D', 'rotation', 'earth'],
  about:
    'The globe spins about an axis that is tilted by 23.4°, as that of the Earth is; the tilt gives us summer and winter. The orange cross is a town: it goes round with the globe, once in a day of ten and a half seconds. The spin is counted in time and not in pictures, so it is equally fast on every screen.',
  dimensions: 3,
  duration: 22,
  parameters: {
    spin: { label: 'Angular velocity', unit: 'rad/s', initial: 0.6, min: 0.1, max: 3 },
    tilt: { label: 'Tilt of the axis', unit: '°', initial: 23.4, min: 0, max: 90 },
    latitude: { label: 'Latitude of the town', unit: '°', initial: 48, min: -80, max: 80 },
  },
  presets: [{ label: 'Uranus, lying on its side', values: { tilt: 90 } }],
  build(
    { spin, tilt, latitude }: ValuesOf<'spin' | 'tilt' | 'latitude'>,
    { integrator = velocityVerlet }: BuildOptions,
  ) {
    const world = createPhysicsWorld({ dimensions: 3, capacity: 4, integrator });
    const start = rotationAbout(point(0, 0, 1), (-tilt * Math.PI) / 180);
    const axis = rotate(start, point(0, 1, 0));
    const globe = { position: {}, velocity: {}, mass: 1, inertia: 1, orientation: start };
    const ball = spawn(world, {
      ...globe,
      angularVelocity: times(axis, spin),
      appearance: { size: 0.985 * RADIUS, color: rgba(0.15, 0.4, 0.75) },
    });
    const side = rotate(rotationAbout(point(0, 0, 1), (latitude * Math.PI) / 180), point(1.03 * RADIUS, 0, 0));
    const town = () => pointOn(world, ball, side);
    return { world, dt: 1 / 60, ball, axis, town };
  },
  picture: ({ world, ball, axis, town }) => ({
    view: { minX: -170, maxX: 170, minY: -140, maxY: 140, minZ: -120, maxZ: 120 },
    camera: { eye: point(0, 60, 400), target: point(0, 0, 0) },
    lines: [
      ...globeLines(RADIUS, (local) => pointOn(world, ball, local), 0x7fb2ff),
      { from: times(axis, -1.35 * RADIUS), to: times(axis, 1.35 * RADIUS), color: COLORS.white },
    ],
    dots: [{ at: town, color: COLORS.orange }],
  }),
  plots: (plot) => [plot('Place of the town to the right', 'x, px', { label: 'town', value: ({ town }) => town().x })],
  checks: ({ at }) => [
    {
      // The town is behind its start first, and comes back to it from behind.
      label: 'Length of a day, 2π/ω',
      unit: 's',
      exact: ({ spin }) => (2 * Math.PI) / spin,
      tolerance: { relative: 1e-3 },
      at: { event: ({ town }) => town().z, from: 1, to: 2 },
    },
    {
      label: 'Steps of 1/60 s in a day',
      exact: 200 * Math.PI,
      tolerance: { relative: 1e-3 },
      at: { event: ({ town }) => town().z, from: 1, to: 2 },
      measure: ({ world }) => world.tick,
    },
    at(
      20,
      'Latitude of the town after 20 s',
      { exact: ({ latitude }) => latitude, unit: '°', absolute: 1e-3 },
      ({ axis, town }) => latitudeOf((town().x * axis.x + town().y * axis.y) / (1.03 * RADIUS)),
    ),
  ],
  tryThis: [
    'Put the town at 80°: it hardly moves, for it is near the pole.',
    'Choose Uranus: its axis lies in the plane of its orbit, and each pole has day for half a year.',
  ],
});

/** The latitude, degrees, whose sine is given. */
function latitudeOf(sine: number): number {
  return (atan2(sine, Math.sqrt(1 - sine * sine)) * 180) / Math.PI;
}
