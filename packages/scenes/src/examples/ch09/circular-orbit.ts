import { attractors, cos, createPhysicsWorld, positionFirstEuler, rgba, sin, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

const SUN = { x: 400, y: 300 };
const GM = 1e6;

export default defineExample({
  id: 'ch09-circular-orbit',
  title: 'The speed of a circular orbit',
  chapter: 9,
  tags: ['gravity', 'orbit', 'circular motion', 'integrators'],
  about:
    'With the speed √(GM/r), and exactly across, gravity is just what a circle of the radius r needs. Launched at the same speed but at an angle, the planet moves on an ellipse, with the same period and the same mean of its nearest and farthest distance.',
  duration: 500,
  parameters: {
    radius: { label: 'Distance r at the start', unit: 'px', initial: 250, min: 100, max: 280 },
    slant: { label: 'Launched at an angle of', unit: '°', initial: 0, min: 0, max: 60 },
    factor: { label: 'Speed, in units of √(GM/r)', unit: '×', initial: 1, min: 0.6, max: 1.2 },
  },
  presets: [
    { label: 'Nearer', values: { radius: 150 } },
    { label: 'Launched at 45°', values: { slant: 45 } },
  ],
  build({ radius, slant, factor }, options) {
    const world = createPhysicsWorld({ capacity: 4, forces: [attractors()], ...options });
    spawn(world, { position: SUN, attractor: GM, appearance: { size: 40, color: rgba(1, 0.8, 0.3) } });
    const [speed, angle] = [factor * Math.sqrt(GM / radius), (slant * Math.PI) / 180];
    const planet = spawn(world, {
      position: { x: SUN.x, y: SUN.y - radius },
      velocity: { x: speed * cos(angle), y: speed * sin(angle) },
      mass: 1,
      collider: 10,
    });
    return { world, dt: 1 / 60, planet, distance: () => distanceBetween(positionOf(world, planet), SUN) };
  },
  picture({ world, planet }, { radius }) {
    const circle = (a: number) => ({ x: SUN.x + radius * sin(a), y: SUN.y - radius * cos(a) });
    return {
      yDown: true,
      view: { minX: 60, maxX: 740, minY: 20, maxY: 620 },
      curves: [{ points: pointsOf(circle, 0, 2 * Math.PI), color: COLORS.ground, dashed: true, label: 'circle' }],
      trails: [{ body: planet, length: 1500 }],
      arrows: [velocityArrow(world, planet, 1)],
    };
  },
  plots: (plot) => [plot('Distance from the sun', 'r, px', { label: 'planet', value: ({ distance }) => distance() })],
  checks: ({ largest, smallest }) => [
    {
      label: 'Period, 2π √(r³/GM)',
      unit: 's',
      exact: 2 * Math.PI * Math.sqrt(250 ** 3 / 1e6),
      tolerance: { relative: 1e-4 },
      at: { event: ({ world, planet }) => positionOf(world, planet).x - SUN.x, from: 1, to: 2 },
    },
    largest(500, 'Largest distance in 500 s', { exact: 250.003, unit: 'px', absolute: 5e-3 }, ({ distance }) =>
      distance(),
    ),
    smallest(
      500,
      'Smallest distance in 500 s',
      { exact: 249.475, unit: 'px', absolute: 5e-3, integrator: positionFirstEuler },
      ({ distance }) => distance(),
    ),
    largest(
      500,
      'Largest distance in 500 s',
      { exact: 250.529, unit: 'px', absolute: 5e-3, integrator: positionFirstEuler },
      ({ distance }) => distance(),
    ),
    {
      label: 'Period, 2π √(r³/GM)',
      unit: 's',
      exact: 11.5429,
      tolerance: { relative: 1e-4 },
      at: { event: ({ world, planet }) => positionOf(world, planet).x - SUN.x, from: 1, to: 2 },
      preset: 'Nearer',
    },
    largest(
      60,
      'Largest distance, r (1 + sin 45°)',
      { exact: 250 * (1 + Math.SQRT1_2), unit: 'px', relative: 1e-4, preset: 'Launched at 45°' },
      ({ distance }) => distance(),
    ),
    {
      label: 'Period on the ellipse: the same',
      unit: 's',
      exact: 2 * Math.PI * Math.sqrt(250 ** 3 / 1e6),
      tolerance: { relative: 1e-3 },
      at: { event: ({ world, planet }) => positionOf(world, planet).x - SUN.x, from: 1, to: 2 },
      preset: 'Launched at 45°',
    },
  ],
  tryThis: [
    'Choose “Launched at 45°”: the ellipse passes close to the sun, and the planet is back after the same time.',
    'Change the integrator to position-first Euler: the circle is slightly out of place.',
  ],
});
