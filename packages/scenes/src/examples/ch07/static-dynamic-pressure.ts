import { accelerationField, atan2, createPhysicsWorld, rgba, rungeKutta4, spawn } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf, velocityOf } from '../support/read.ts';

const DENSITY = 1.2;
const [LEFT, RIGHT] = [-40, 40];

/** Half width of the pipe: 10 m at its ends, and a bell-shaped throat in the middle. */
const halfWidth = (x: number, throat: number) => 10 - (10 - throat) / (1 + (x * x) / 100);
/** Its slope, dw/dx. */
function widening(x: number, throat: number): number {
  const bell = 1 + (x * x) / 100;
  return ((10 - throat) * x) / (50 * bell * bell);
}

/** When the air that starts at the left end is in the throat: the integral of dx/v = w dx/flow. */
function timeToThroat({ speed, throat }: ValuesOf<'speed' | 'throat'>): number {
  const area = -10 * LEFT - 10 * (10 - throat) * atan2(-LEFT, 10);
  return area / (speed * halfWidth(LEFT, throat));
}

export default defineExample({
  id: 'ch07-static-dynamic-pressure',
  title: 'Air through a narrow pipe',
  chapter: 7,
  tags: ['pressure', 'fluids', 'Bernoulli'],
  about:
    'Where a pipe is narrow the air must go faster. Something has to speed it up: the pressure is lower in the throat than before it. Bernoulli found that the static pressure p and the dynamic one, ½ ρ v², have the same sum all the way.',
  duration: 12,
  parameters: {
    speed: { label: 'Speed at the entry', unit: 'm/s', initial: 10, min: 2, max: 20 },
    throat: { label: 'Half width of the throat', unit: 'm', initial: 5, min: 3, max: 10 },
  },
  presets: [{ label: 'A straight pipe', values: { throat: 10 } }],
  build({ speed, throat }, { integrator = rungeKutta4 }) {
    const flow = speed * halfWidth(LEFT, throat);
    // The air is pushed by the slope of the pressure: −dp/dx /ρ = v dv/dx with v = flow/width.
    const push = accelerationField((x, _y, _z, _time, out) => {
      const w = halfWidth(x, throat);
      out.x = (-flow * flow * widening(x, throat)) / (w * w * w);
      out.y = 0;
      out.z = 0;
    });
    const world = createPhysicsWorld({ capacity: 40, forces: [push], integrator });
    const { Position: p, Velocity: v } = world.components;
    const parcels = Array.from({ length: 24 }, (_, i) => {
      const x = LEFT + ((RIGHT - LEFT) * i) / 24;
      const velocity = { x: flow / halfWidth(x, throat) };
      return spawn(world, { position: { x }, velocity, mass: 1, appearance: { size: 0.8, color: rgba(0.6, 0.85, 1) } });
    });
    world.phases.input.push(() => {
      for (const id of parcels) {
        if (p.x[id] < RIGHT) continue;
        p.x[id] = LEFT;
        v.x[id] = speed;
        world.versions.pose++;
      }
    });
    /** Dynamic pressure of a parcel, and what Bernoulli leaves of a static pressure of 1000 Pa at the entry. */
    const dynamic = (id: number) => 0.5 * DENSITY * v.x[id] * v.x[id];
    const still = (id: number) => {
      const w = halfWidth(p.x[id], throat);
      return 1000 + 0.5 * DENSITY * (speed * speed - (flow * flow) / (w * w));
    };
    const first = parcels[0];
    return { world, dt: 1 / 240, parcels, first, dynamic, still };
  },
  picture({ world, first, dynamic, still }, { throat }) {
    const wall = (sign: number) => pointsOf((x) => ({ x, y: sign * halfWidth(x, throat) }), LEFT, RIGHT, 120);
    return {
      view: { minX: -42, maxX: 42, minY: -24, maxY: 24 },
      curves: [
        { points: wall(1), color: COLORS.orange },
        { points: wall(-1), color: COLORS.orange },
      ],
      dots: [{ at: () => positionOf(world, first), color: COLORS.red, radius: 8 }],
      arrows: [velocityArrow(world, first, 0.4)],
      labels: [
        { at: { x: -38, y: -17 }, text: () => `static ${still(first).toFixed(0)} Pa` },
        { at: { x: -38, y: -21 }, text: () => `dynamic ${dynamic(first).toFixed(0)} Pa` },
      ],
    };
  },
  plots: [
    {
      title: 'Pressure at the red parcel',
      x: { label: 'x, m', value: ({ world, first }) => positionOf(world, first).x },
      y: { label: 'p, Pa' },
      series: [
        { label: 'static', value: ({ still, first }) => still(first) },
        { label: 'dynamic', value: ({ dynamic, first }) => dynamic(first) },
        { label: 'sum', value: ({ still, dynamic, first }) => still(first) + dynamic(first) },
      ],
    },
  ],
  checks: ({ at, largest }) => [
    at(
      0,
      'Dynamic pressure at the entry, ½ ρ v²',
      { exact: ({ speed }) => 0.5 * DENSITY * speed * speed, unit: 'Pa', relative: 1e-12 },
      ({ dynamic, first }) => dynamic(first),
    ),
    largest(
      6,
      'Largest speed, where the pipe is narrowest',
      {
        exact: ({ speed, throat }) => (speed * halfWidth(LEFT, throat)) / throat,
        holds: (values) => timeToThroat(values) < 6,
        unit: 'm/s',
        relative: 1e-3,
      },
      ({ world, first }) => velocityOf(world, first).x,
    ),
    at(
      3,
      'Sum of both pressures after 3 s',
      { exact: ({ speed }) => 1000 + 0.5 * DENSITY * speed * speed, unit: 'Pa', relative: 1e-6 },
      ({ still, dynamic, first }) => still(first) + dynamic(first),
    ),
  ],
  tryThis: [
    'Make the throat still narrower, 3 m: the air is more than three times as fast there as at the entry.',
    'Choose “A straight pipe”: speed and pressure are the same everywhere.',
  ],
});
