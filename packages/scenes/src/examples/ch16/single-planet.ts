import { attractors, createPhysicsWorld, energy, rgba, rungeKutta4, spawn } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { lengthOf, positionOf, velocityOf } from '../support/read.ts';
import { cross, dot, type Point3, point, times } from '../support/space.ts';

const GM = 50000;
const START = point(0, 250, 0);
/** Steps between two copies of the planet that are left behind. */
const COPY_STEPS = 40;
const COPIES = 63;

const axisOf = (r: Point3, v: Point3) => 1 / (2 / lengthOf(r) - dot(v, v) / GM);

export default defineExample({
  id: 'ch16-single-planet',
  title: 'One planet in space',
  chapter: 16,
  tags: ['3D', 'gravity', 'orbit', 'integrators'],
  about:
    'A planet starts at its nearest point to the sun, at right angles to the line between both, on an inclined path. A copy of it stays behind every two seconds: far apart where it is fast, close together where it is slow. The copies lie on an ellipse, and in one plane.',
  dimensions: 3,
  duration: 135,
  parameters: {
    along: { label: 'Speed along x', unit: 'px/s', initial: 5, min: 0, max: 15 },
    aside: { label: 'Speed along z', unit: 'px/s', initial: 14, min: 5, max: 15 },
  },
  build({ along, aside }: ValuesOf<'along' | 'aside'>, { integrator = rungeKutta4 }: BuildOptions) {
    const world = createPhysicsWorld({ dimensions: 3, capacity: 4, forces: [attractors()], integrator });
    spawn(world, { position: {}, attractor: GM, appearance: { size: 40, color: rgba(1, 0.8, 0.35) } });
    const velocity = point(along, 0, aside);
    const planet = spawn(world, {
      position: START,
      velocity,
      mass: 1,
      appearance: { size: 8, color: rgba(0.45, 0.7, 1) },
    });
    const copies: Point[] = [];
    world.phases.finish.push(() => {
      if (world.tick % COPY_STEPS === 0 && copies.length < COPIES) copies.push(positionOf(world, planet));
    });
    const normal = cross(START, velocity);
    const begin = energy(world).total;
    const state = () => ({ r: positionOf(world, planet), v: velocityOf(world, planet) });
    return { world, dt: 0.05, planet, state, normal: times(normal, 1 / lengthOf(normal)), begin, copies };
  },
  picture: ({ planet, copies, state }) => ({
    view: { minX: -120, maxX: 120, minY: -320, maxY: 260, minZ: -270, maxZ: 270 },
    camera: { eye: point(900, 300, 500), target: point(0, -20, 0) },
    trails: [{ body: planet, length: 1400, interval: 2 }],
    dots: Array.from({ length: COPIES }, (_, i) => ({ at: () => copies[i] ?? START, radius: 3, color: COLORS.blue })),
    arrows: [{ label: 'v', from: () => state().r, vector: () => state().v, scale: 5, color: COLORS.green }],
  }),
  plots: (plot) => [
    plot('Distance from the sun', 'r, px', { label: 'distance', value: ({ state }) => lengthOf(state().r) }),
  ],
  checks: ({ at, largest }) => [
    at(125, 'Semi-major axis after 125 s', { exact: 279.33, unit: 'px', relative: 1e-5 }, ({ state }) =>
      axisOf(state().r, state().v),
    ),
    largest(125, 'Largest distance, a (1 + e)', { exact: 308.659, unit: 'px', relative: 1e-5 }, ({ state }) =>
      lengthOf(state().r),
    ),
    {
      label: 'Back at its nearest after a turn, 2π √(a³/GM)',
      unit: 's',
      exact: 131.181,
      tolerance: { relative: 1e-4 },
      at: { event: ({ state }) => dot(state().r, state().v), count: 1 },
    },
    // Rounding of a sum of 2500 steps of about 1.
    largest(
      125,
      'Largest distance from the plane of the start',
      { exact: 0, unit: 'px', absolute: 1e-10 },
      ({ state, normal }) => Math.abs(dot(state().r, normal)),
    ),
    at(
      125,
      'Relative change of the energy after 125 s',
      { exact: 0, absolute: 1e-12 },
      ({ world, begin }) => energy(world).total / begin - 1,
    ),
  ],
  tryThis: [
    'Give it a speed of 14.14 px/s in all: the orbit becomes a circle.',
    'Change the integrator to explicit Euler: the copies leave the ellipse.',
  ],
});
