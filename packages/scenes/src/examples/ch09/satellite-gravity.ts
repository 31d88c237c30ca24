import { attractors, createPhysicsWorld, pow, rgba, rungeKutta4, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { forceArrow, velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf, velocityOf } from '../support/read.ts';

const EARTH = { x: 400, y: 300 };
const GM = 1e6;
const SPIN = 0.4;
/** Where gravity gives a satellite the angular speed of the Earth, (GM/ω²)^(1/3). */
const GEOSTATIONARY = pow(GM / (SPIN * SPIN), 1 / 3);

const angularSpeed = (radius: number) => Math.sqrt(GM / (radius * radius * radius));

export default defineExample({
  id: 'ch09-satellite-gravity',
  title: 'How high does a satellite stand still?',
  chapter: 9,
  tags: ['circular motion', 'gravity', 'satellite'],
  about:
    'Gravity alone decides how fast a satellite must go round: ω = √(GM/r³), faster when nearer. Only at one distance is that as fast as the Earth turns. A satellite there hangs above one place; a lower one runs ahead, a higher one falls behind.',
  duration: 60,
  parameters: {
    radius: { label: 'Distance from the centre', unit: 'px', initial: 200, min: 90, max: 260 },
  },
  presets: [
    { label: 'Geostationary', values: { radius: GEOSTATIONARY } },
    { label: 'Low orbit', values: { radius: 100 } },
  ],
  build({ radius }, { integrator = rungeKutta4 }) {
    const world = createPhysicsWorld({ capacity: 5, forces: [attractors()], integrator });
    const earth = spawn(world, {
      position: EARTH,
      velocity: {},
      attractor: GM,
      rotation: 0,
      angularVelocity: SPIN,
      appearance: { size: 70, shape: 3, color: rgba(0.25, 0.5, 0.95) },
    });
    const satellite = spawn(world, {
      position: { x: EARTH.x + radius, y: EARTH.y },
      velocity: { y: radius * angularSpeed(radius) },
      mass: 1,
      appearance: { size: 9, shape: 2, color: rgba(1, 0.85, 0.4) },
    });
    /** Present angular speed, from the position and the velocity. */
    const omega = () => {
      const [at, v] = [positionOf(world, satellite), velocityOf(world, satellite)];
      const [x, y] = [at.x - EARTH.x, at.y - EARTH.y];
      return (x * v.y - y * v.x) / (x * x + y * y);
    };
    return { world, dt: 1 / 240, earth, satellite, omega };
  },
  picture({ world, satellite }) {
    const at = () => positionOf(world, satellite);
    const pull = (): Point => {
      const r = distanceBetween(at(), EARTH);
      return { x: (GM * (EARTH.x - at().x)) / (r * r * r), y: (GM * (EARTH.y - at().y)) / (r * r * r) };
    };
    return {
      view: { minX: 110, maxX: 690, minY: 30, maxY: 570 },
      lines: [{ from: EARTH, to: at, color: COLORS.ground, width: 1 }],
      trails: [{ body: satellite, length: 500, interval: 8 }],
      arrows: [forceArrow(world, satellite, 'gravity', pull, 2), velocityArrow(world, satellite, 0.7)],
    };
  },
  plots: (plot) => [
    plot(
      'Angular speed',
      'ω, rad/s',
      { label: 'satellite', value: ({ omega }) => omega(), exact: (_, { radius }) => angularSpeed(radius) },
      { label: 'Earth', value: ({ world, earth }) => world.components.AngularVelocity.z[earth] },
    ),
  ],
  checks: ({ at }) => [
    at(
      30,
      'Angular speed after 30 s, √(GM/r³)',
      { exact: ({ radius }) => angularSpeed(radius), unit: 'rad/s', relative: 1e-9 },
      ({ omega }) => omega(),
    ),
    {
      label: 'Period',
      unit: 's',
      exact: 17.7715,
      tolerance: { absolute: 5e-5 },
      at: { event: ({ world, satellite }) => positionOf(world, satellite).y - EARTH.y, from: 1, to: 2 },
    },
    at(
      30,
      'Angular speed at 184.2016 px: that of the Earth',
      { exact: SPIN, unit: 'rad/s', relative: 1e-9, preset: 'Geostationary' },
      ({ omega }) => omega(),
    ),
    at(
      60,
      'Distance after 60 s',
      { exact: ({ radius }) => radius, unit: 'px', relative: 1e-8 },
      ({ world, satellite }) => distanceBetween(positionOf(world, satellite), EARTH),
    ),
  ],
  tryThis: [
    'Choose “Geostationary”: the mark on the Earth stays below the satellite.',
    'Halve the distance: the satellite needs only about a third of the time for a turn.',
  ],
});
