import { attractors, cos, createPhysicsWorld, rgba, rungeKutta4, sin, spawn } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { type Arrow, COLORS, type Point, pointsOf } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf, speedOf } from '../support/read.ts';

const CENTRE = { x: 0, y: 0 };
const POINTS = 400;
const [START, DT] = [200, 1 / 240];

/** The nearest that the body comes, px: the other end of its ellipse, or its start. */
function nearest({ mass, speed }: ValuesOf<'mass' | 'speed'>): number {
  const other = START / ((2 * mass) / (START * speed * speed) - 1);
  return other > 0 ? Math.min(START, other) : START;
}

/** Whether a step turns the body by less than a tenth of a radian there, as the integrator needs. */
function hasShortSteps(values: ValuesOf<'mass' | 'speed'>): boolean {
  const r = nearest(values);
  return values.mass * DT * DT < 0.01 * r * r * r;
}

/** Gravity of the mass at a point, −GM r/r³. */
function fieldAt({ x, y }: Point, mass: number): Point {
  const r = Math.sqrt(x * x + y * y);
  return { x: (-mass * x) / (r * r * r), y: (-mass * y) / (r * r * r) };
}

/** Work of the field on one kilogram that is carried round a circle beside the mass. */
function workRound(mass: number): number {
  let work = 0;
  for (let i = 0; i < POINTS; i++) {
    const a = (2 * Math.PI * i) / POINTS;
    const { x, y } = fieldAt({ x: 180 + 90 * cos(a), y: 90 * sin(a) }, mass);
    work += ((-x * sin(a) + y * cos(a)) * 90 * 2 * Math.PI) / POINTS;
  }
  return work;
}

/** Flow of the field through a sphere of 100 px whose mass is aside of its middle, by 4π GM. */
function flowThrough(aside: number): number {
  let flow = 0;
  for (let i = 0; i < POINTS; i++) {
    // The sphere is symmetric about the line to the mass: rings of equal height.
    const c = (2 * (i + 0.5)) / POINTS - 1;
    const s = Math.sqrt(1 - c * c);
    const [x, y] = [100 * c - aside, 100 * s];
    const r = Math.sqrt(x * x + y * y);
    flow += (1e4 * (x * c + y * s)) / (r * r * r) / POINTS;
  }
  return flow;
}

export default defineExample({
  id: 'ch10-field-of-a-particle',
  title: 'The field around a mass',
  chapter: 10,
  tags: ['gravity', 'field', 'potential', 'energy'],
  about:
    'A mass changes the space around it: at each point there is an arrow that says how a body there would be accelerated. The circles join points of equal potential. A body that goes round and comes back has gained and lost the same: the field does no work on a closed path.',
  duration: 30,
  parameters: {
    mass: { label: 'Mass, GM', unit: 'px³/s²', initial: 1e6, min: 1e5, max: 4e6 },
    speed: { label: 'Speed of the body', unit: 'px/s', initial: 50, min: 20, max: 90 },
  },
  presets: [{ label: 'A quarter of the mass', values: { mass: 2.5e5 } }],
  build({ mass, speed }, { integrator = rungeKutta4 }) {
    const world = createPhysicsWorld({ capacity: 4, forces: [attractors()], integrator });
    spawn(world, { position: CENTRE, attractor: mass, appearance: { size: 14, color: rgba(1, 0.8, 0.35) } });
    const body = spawn(world, { position: { x: START }, velocity: { y: speed }, mass: 1, collider: 6 });
    const total = () => {
      const v = speedOf(world, body);
      return (v * v) / 2 - mass / distanceBetween(positionOf(world, body), CENTRE);
    };
    return { world, dt: DT, body, total };
  },
  picture({ world, body }, { mass }) {
    const grid = [-5, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5].flatMap((i) => [-3, -2, -1, 0, 1, 2, 3].map((j) => [i, j]));
    const arrows: Arrow[] = grid
      .filter(([i, j]) => i * i + j * j > 1)
      .map(([i, j]) => {
        const from = { x: 55 * i, y: 55 * j };
        const field = fieldAt(from, mass);
        return { label: '', from, vector: () => field, scale: 2e5 / (mass / 2), color: COLORS.ground };
      });
    const circle = (r: number) => pointsOf((a) => ({ x: r * cos(a), y: r * sin(a) }), 0, 2 * Math.PI, 100);
    return {
      view: { minX: -320, maxX: 320, minY: -215, maxY: 215 },
      curves: [60, 80, 120, 240].map((r) => ({ points: circle(r), color: COLORS.blue, dashed: true })),
      trails: [{ body, length: 1500, interval: 4 }],
      arrows: [...arrows, velocityArrow(world, body, 0.5)],
    };
  },
  plots: (plot) => [
    plot(
      'Energy of the body',
      'E, kg px²/s²',
      { label: 'total', value: ({ total }) => total() },
      { label: 'of motion', value: ({ world, body }) => (speedOf(world, body) * speedOf(world, body)) / 2 },
    ),
  ],
  checks: ({ at }) => [
    at(0, 'Work on a closed path', { exact: 0, unit: 'kg px²/s²', absolute: 1e-9 }, () => workRound(1e6)),
    at(0, 'Flow through a sphere about the mass, by 4π GM', { exact: 1, relative: 1e-3 }, () => flowThrough(0)),
    at(0, 'The same with the mass far from the middle of the sphere', { exact: 1, relative: 1e-3 }, () =>
      flowThrough(60),
    ),
    at(
      30,
      'Energy of the body after 30 s',
      {
        exact: ({ mass, speed }) => (speed * speed) / 2 - mass / START,
        holds: hasShortSteps,
        unit: 'kg px²/s²',
        relative: 1e-4,
      },
      ({ total }) => total(),
    ),
  ],
  tryThis: [
    'Choose “A quarter of the mass”: now 50 px/s is just enough to escape.',
    'Make the body slow: it falls close past the mass, where the arrows are long, and is fast there.',
  ],
});
