import {
  angularMomentum,
  attractors,
  createPhysicsWorld,
  energy,
  rgba,
  spawn,
  velocityVerlet,
} from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { distanceBetween, positionOf, velocityOf } from '../support/read.ts';

const SUN = { x: 275, y: 200 };
const START = { x: 200, y: 50 };
const GM = 1e6;

/** Semi-major axis of an orbit that starts with this velocity. */
const axisOf = (vx: number, vy: number) => 1 / (2 / distanceBetween(SUN, START) - (vx * vx + vy * vy) / GM);

export default defineExample({
  id: 'ch06-orbits',
  title: 'A planet orbits a fixed sun',
  chapter: 6,
  tags: ['gravity', 'orbit', 'energy', 'integrators'],
  about:
    'The planet starts at its nearest point to the sun. Gravity GM/r² bends its path into an ellipse with the sun in a focus: it is fast when near and slow when far, so that the line to the sun sweeps equal areas in equal times.',
  duration: 80,
  parameters: {
    vx: { label: 'Velocity to the right', unit: 'px/s', initial: 80, min: 40, max: 105 },
    vy: { label: 'Velocity downwards', unit: 'px/s', initial: -40, min: -60, max: 0 },
  },
  presets: [
    { label: 'Nearly a circle', values: { vx: 70, vy: -40 } },
    { label: 'A long ellipse', values: { vx: 100, vy: 0 } },
  ],
  build({ vx, vy }, { integrator = velocityVerlet }) {
    const world = createPhysicsWorld({ capacity: 4, forces: [attractors()], integrator });
    spawn(world, { position: SUN, attractor: GM, appearance: { size: 70, color: rgba(1, 0.8, 0.3) } });
    const planet = spawn(world, { position: START, velocity: { x: vx, y: vy }, mass: 1, collider: 10 });
    return { world, dt: 1 / 60, planet };
  },
  picture({ world, planet }) {
    const at = () => positionOf(world, planet);
    const acceleration = (): Point => {
      const [{ x, y }, r] = [at(), distanceBetween(at(), SUN)];
      const pull = GM / (r * r * r);
      return { x: pull * (SUN.x - x), y: pull * (SUN.y - y) };
    };
    return {
      yDown: true,
      view: { minX: -30, maxX: 650, minY: -60, maxY: 560 },
      trails: [{ body: planet, length: 1600 }],
      arrows: [
        { label: 'v', from: at, vector: () => velocityOf(world, planet), scale: 0.8, color: COLORS.green },
        { label: 'a', from: at, vector: acceleration, scale: 2, color: COLORS.red },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Energies',
      'energy, kg px²/s²',
      { label: 'kinetic', value: ({ world }) => energy(world).kinetic },
      { label: 'potential', value: ({ world }) => energy(world).potential },
      { label: 'total', value: ({ world }) => energy(world).total },
    ),
    plot('Distance from the sun', 'r, px', {
      label: 'distance',
      value: ({ world, planet }) => distanceBetween(positionOf(world, planet), SUN),
    }),
  ],
  checks: ({ at, largest }) => [
    {
      label: 'Period, 2π √(a³/GM)',
      unit: 's',
      exact: ({ vx, vy }) => 2 * Math.PI * axisOf(vx, vy) * Math.sqrt(axisOf(vx, vy) / GM),
      tolerance: { relative: 1e-3 },
      // At the nearest point the radial velocity turns from inwards to outwards.
      at: {
        event: ({ world, planet }) => radialSpeed(positionOf(world, planet), velocityOf(world, planet)),
        from: 1,
        to: 2,
      },
    },
    largest(30, 'Largest distance', { exact: 341.76, unit: 'px', relative: 1e-3 }, ({ world, planet }) =>
      distanceBetween(positionOf(world, planet), SUN),
    ),
    at(
      30,
      'Angular momentum after 30 s',
      { exact: 15000, unit: 'kg px²/s', relative: 1e-12 },
      ({ world }) => angularMomentum(world, SUN).z,
    ),
  ],
  tryThis: [
    'Change the integrator to explicit Euler: the planet spirals outwards, because it gains energy in every turn.',
    'Start faster: √2 times the speed on a circle is enough to escape.',
  ],
});

function radialSpeed(at: Point, v: Point): number {
  return (at.x - SUN.x) * v.x + (at.y - SUN.y) * v.y;
}
