import { cos, createPhysicsWorld, rungeKutta4, sin, spawn, stringTension, uniformGravity } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, type Point, pointsOf } from '../picture.ts';
import { forceArrow, velocityArrow } from '../support/arrows.ts';
import { pendulumPeriod } from '../support/pendulum.ts';
import { distanceBetween, positionOf, speedOf } from '../support/read.ts';

const PIVOT = { x: 350, y: 50 };

export default defineExample({
  id: 'ch09-pendulum',
  title: 'A pendulum and the pull of its string',
  chapter: 9,
  tags: ['pendulum', 'oscillation', 'tension', 'centripetal force'],
  about:
    'The string holds the bob on a circle. It carries part of the weight, and pulls it round the bend: hardest at the bottom, where the bob is fastest. A small swing takes 2π √(L/g), whatever the mass. A wide swing takes a little longer.',
  duration: 100,
  parameters: {
    degrees: { label: 'Start', unit: '°', initial: 30, min: 1, max: 85 },
    length: { label: 'Length L', unit: 'px', initial: 200, min: 50, max: 250 },
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 100, min: 10, max: 300 },
  },
  presets: [
    { label: 'A small swing', values: { degrees: 1 } },
    { label: 'A wide swing', values: { degrees: 80 } },
  ],
  build({ degrees, length, gravity }, { integrator = rungeKutta4 }) {
    const forces = [uniformGravity({ y: gravity }), stringTension({ pivot: PIVOT, length })];
    const world = createPhysicsWorld({ capacity: 4, forces, integrator });
    const angle = (degrees * Math.PI) / 180;
    const position = { x: PIVOT.x + length * sin(angle), y: PIVOT.y + length * cos(angle) };
    const bob = spawn(world, { position, mass: 1, collider: 14 });
    const height = () => positionOf(world, bob).y - PIVOT.y;
    const tension = () => (gravity * height()) / length + speedOf(world, bob) * (speedOf(world, bob) / length);
    return { world, dt: 1 / 60, bob, tension };
  },
  picture({ world, bob, tension }, { degrees, length, gravity }) {
    const at = () => positionOf(world, bob);
    const arc = (a: number) => ({ x: PIVOT.x + length * sin(a), y: PIVOT.y + length * cos(a) });
    const edge = (degrees * Math.PI) / 180;
    const pull = (): Point => ({
      x: (tension() * (PIVOT.x - at().x)) / length,
      y: (tension() * (PIVOT.y - at().y)) / length,
    });
    return {
      yDown: true,
      view: { minX: 100, maxX: 600, minY: 10, maxY: 380 },
      lines: [
        { from: { x: 300, y: PIVOT.y }, to: { x: 400, y: PIVOT.y }, color: COLORS.grey, width: 4 },
        { from: PIVOT, to: at },
      ],
      curves: [{ points: pointsOf(arc, -edge, edge, 60), color: COLORS.ground, dashed: true }],
      arrows: [
        forceArrow(world, bob, 'weight', () => ({ x: 0, y: gravity }), 0.6),
        { ...forceArrow(world, bob, 'tension', pull, 0.6), color: COLORS.yellow },
        velocityArrow(world, bob, 0.8),
      ],
    };
  },
  plots: (plot) => [
    plot('Displacement', 'x, px', { label: 'bob', value: ({ world, bob }) => positionOf(world, bob).x - PIVOT.x }),
    plot('Tension', 'T, N', { label: 'string', value: ({ tension }) => tension() }),
  ],
  checks: ({ at, largest, smallest }) => [
    {
      label: 'Period, by the elliptic integral',
      unit: 's',
      exact: ({ degrees, length, gravity }) => pendulumPeriod(length, gravity, degrees),
      tolerance: { relative: 1e-3 },
      at: { event: ({ world, bob }) => positionOf(world, bob).x - PIVOT.x, from: 1, to: 2 },
    },
    largest(
      10,
      'Largest speed, √(2gL(1 − cos φ))',
      { exact: 100 * (Math.sqrt(3) - 1), unit: 'px/s', relative: 1e-3 },
      ({ world, bob }) => speedOf(world, bob),
    ),
    largest(
      10,
      'Largest tension, at the bottom',
      { exact: 100 * (3 - Math.sqrt(3)), unit: 'N', relative: 1e-3 },
      ({ tension }) => tension(),
    ),
    smallest(
      10,
      'Smallest tension, m g cos φ at the ends',
      { exact: 50 * Math.sqrt(3), unit: 'N', relative: 1e-3 },
      ({ tension }) => tension(),
    ),
    at(
      100,
      'Length of the string after 100 s',
      { exact: ({ length }) => length, unit: 'px', absolute: 0.01 },
      ({ world, bob }) => distanceBetween(positionOf(world, bob), PIVOT),
    ),
    {
      label: 'Period of a small swing, 2π √(L/g)',
      unit: 's',
      exact: 8.88577,
      tolerance: { relative: 1e-3 },
      at: { event: ({ world, bob }) => positionOf(world, bob).x - PIVOT.x, from: 1, to: 2 },
      preset: 'A small swing',
    },
  ],
  tryThis: [
    'Make the string a quarter as long: the pendulum swings twice as fast.',
    'Choose “A wide swing”: its period is about a seventh longer, and at the bottom the string carries more than two and a half times the weight.',
  ],
});
