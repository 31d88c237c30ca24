import {
  angularMomentum,
  attractors,
  createPhysicsWorld,
  positionFirstEuler,
  rgba,
  spawn,
  velocityVerlet,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { velocityArrow } from '../support/arrows.ts';
import { lengthOf, positionOf, velocityOf } from '../support/read.ts';
import { globeLines, point, pointOn } from '../support/space.ts';

const GM = 50000;
const START = 300;
/** Axis of the orbit of a Moon that starts at right angles with a speed. */
const axisOf = (speed: number) => 1 / (2 / START - (speed * speed) / GM);

export default defineExample({
  id: 'ch15-earth-moon',
  title: 'The Moon goes round the Earth',
  chapter: 15,
  tags: ['3D', 'gravity', 'orbit'],
  about:
    'The Moon starts at the far end of its ellipse, is faster and nearer after half a turn, and comes back. Gravity acts along the line between both, so the Moon never leaves the plane in which it started, also in space. Meanwhile the Earth spins below it.',
  dimensions: 3,
  duration: 245,
  parameters: {
    speed: { label: 'Speed at the start', unit: 'px/s', initial: 12, min: 10.5, max: 15 },
    slope: { label: 'Speed upwards', unit: 'px/s', initial: 0, min: 0, max: 8 },
  },
  presets: [{ label: 'An inclined orbit', values: { slope: 5 } }],
  build({ speed, slope }: ValuesOf<'speed' | 'slope'>, { integrator = velocityVerlet }: BuildOptions) {
    const world = createPhysicsWorld({ dimensions: 3, capacity: 4, forces: [attractors()], integrator });
    const earth = spawn(world, {
      position: {},
      attractor: GM,
      orientation: {},
      angularVelocity: { y: 0.06 },
      appearance: { size: 98, color: rgba(0.15, 0.4, 0.75) },
    });
    const velocity = { y: slope, z: -speed };
    const white = rgba(0.85, 0.86, 0.9);
    const ball = spawn(world, { position: { x: START }, velocity, mass: 1, collider: 25, appearance: white });
    const r = () => lengthOf(positionOf(world, ball));
    const radialSpeed = () => {
      const [p, v] = [positionOf(world, ball), velocityOf(world, ball)];
      return p.x * v.x + p.y * v.y + p.z * v.z;
    };
    return { world, dt: 1 / 60, earth, ball, r, radialSpeed };
  },
  picture: ({ world, earth, ball }) => ({
    view: { minX: -270, maxX: 350, minY: -120, maxY: 160, minZ: -280, maxZ: 280 },
    camera: { eye: point(0, 450, 1000), target: point(40, 0, 0) },
    lines: globeLines(100, (local) => pointOn(world, earth, local), 0x7fb2ff),
    trails: [{ body: ball, length: 1800, interval: 4 }],
    arrows: [velocityArrow(world, ball, 6)],
  }),
  plots: (plot) => [plot('Distance of the Moon', 'r, px', { label: 'distance', value: ({ r }) => r() })],
  checks: ({ at, largest, smallest }) => [
    smallest(121, 'Smallest distance', { exact: 228.169, unit: 'px', relative: 1e-3 }, ({ r }) => r()),
    {
      label: 'Period, 2π √(a³/GM)',
      unit: 's',
      exact: ({ speed, slope }) => {
        const a = axisOf(Math.sqrt(speed * speed + slope * slope));
        return 2 * Math.PI * a * Math.sqrt(a / GM);
      },
      tolerance: { relative: 1e-3 },
      at: { event: ({ radialSpeed }) => radialSpeed(), from: 1, to: 2 },
    },
    largest(
      121,
      'Largest distance from the plane of the start',
      { exact: 0, unit: 'px', absolute: 0 },
      ({ world, ball }) => Math.abs(positionOf(world, ball).y),
    ),
    ...[velocityVerlet, positionFirstEuler].map((integrator) =>
      at(
        240,
        'Angular momentum after 240 s, relative to 3600',
        { exact: 1, absolute: 1e-12, integrator },
        ({ world }) => angularMomentum(world).y / 3600,
      ),
    ),
  ],
  tryThis: [
    'Start at 12.91 px/s: the orbit becomes a circle, and the distance in the plot a level line.',
    'Choose the inclined orbit: the Moon now rises above the equator and sinks below it.',
  ],
});
