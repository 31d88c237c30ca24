import { createPhysicsWorld, energy, momentum, particleContacts, rgba, spawn } from '@principia/physics';
import { choiceOf, defineExample } from '../define-example.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf, velocityOf } from '../support/read.ts';

/** Two balls each: place, velocity, mass and radius. */
const PAIRS = [
  {
    name: 'light on heavy',
    red: { x: 0, y: 200, vx: 250, vy: 0, mass: 1, radius: 15 },
    blue: { x: 300, y: 200, vx: 50, vy: 0, mass: 125, radius: 75 },
  },
  {
    name: 'equal, oblique',
    red: { x: 100, y: 220, vx: 100, vy: -30, mass: 1, radius: 20 },
    blue: { x: 300, y: 200, vx: -50, vy: -30, mass: 1, radius: 20 },
  },
  {
    name: 'equal, one at rest',
    red: { x: 50, y: 218, vx: 120, vy: 0, mass: 1, radius: 20 },
    blue: { x: 250, y: 200, vx: 0, vy: 0, mass: 1, radius: 20 },
  },
] as const;

type Ball = (typeof PAIRS)[number]['red' | 'blue'];

export default defineExample({
  id: 'ch11-2d-two-balls',
  title: 'Two balls collide',
  chapter: 11,
  tags: ['collision', 'momentum', 'energy', 'restitution'],
  about:
    'Two balls push each other along the line between their centres, equally hard and in opposite directions: together they keep their momentum. If the collision is elastic they keep their energy too, and that fixes both velocities. A light ball is thrown back from a heavy one, equal ones exchange what points along the line.',
  duration: 3,
  ends: true,
  parameters: {
    pair: choiceOf(
      'Balls',
      PAIRS.map(({ name }) => name),
    ),
    restitution: { label: 'Restitution e', initial: 1, min: 0, max: 1 },
  },
  presets: [
    { label: 'Equal balls, oblique', values: { pair: 1 } },
    { label: 'One at rest', values: { pair: 2 } },
    { label: 'They stay together', values: { restitution: 0 } },
    { label: 'Half elastic', values: { restitution: 0.5 } },
  ],
  build({ pair, restitution }, options) {
    const world = createPhysicsWorld({ preset: particleContacts, capacity: 8, ...options });
    const add = ({ x, y, vx, vy, mass, radius }: Ball, color: number) =>
      spawn(world, {
        position: { x, y },
        velocity: { x: vx, y: vy },
        mass,
        collider: { radius, restitution },
        appearance: color,
      });
    const red = add(PAIRS[pair].red, rgba(0.95, 0.35, 0.35));
    const blue = add(PAIRS[pair].blue, rgba(0.35, 0.6, 1));
    const vx = (id: number) => velocityOf(world, id).x;
    return { world, dt: 1 / 60, red, blue, vx, lost: energy(world).kinetic };
  },
  picture({ world, red, blue }) {
    return {
      yDown: true,
      view: { minX: -40, maxX: 560, minY: 40, maxY: 360 },
      trails: [
        { body: red, length: 300 },
        { body: blue, length: 300 },
      ],
      arrows: [velocityArrow(world, red, 0.4), velocityArrow(world, blue, 0.4)],
    };
  },
  plots: (plot) => [
    plot(
      'Momentum along x',
      'p, kg px/s',
      { label: 'red', value: ({ world, red, vx }) => world.components.Mass.value[red] * vx(red) },
      { label: 'blue', value: ({ world, blue, vx }) => world.components.Mass.value[blue] * vx(blue) },
      { label: 'sum', value: ({ world }) => momentum(world).x },
    ),
    plot('Energy of motion', 'E, kg px²/s²', { label: 'both', value: ({ world }) => energy(world).kinetic }),
  ],
  checks: ({ at }) => [
    at(
      2,
      'Velocity of the light ball afterwards',
      { exact: -9250 / 63, unit: 'px/s', relative: 1e-12 },
      ({ red, vx }) => vx(red),
    ),
    at(
      2,
      'Velocity of the heavy ball afterwards',
      { exact: 3350 / 63, unit: 'px/s', relative: 1e-12 },
      ({ blue, vx }) => vx(blue),
    ),
    at(
      2,
      'Time of the collision',
      { exact: 1.05, unit: 's', absolute: 1e-9 },
      ({ world, red, vx }) => world.time - (positionOf(world, red).x - 262.5) / vx(red),
    ),
    at(
      2,
      'Common velocity if they stay together',
      { exact: 6500 / 126, unit: 'px/s', relative: 1e-6, preset: 'They stay together' },
      ({ red, vx }) => vx(red),
    ),
    at(
      2,
      'Energy lost, ½ μ (1 − e²) 200²',
      { exact: 0.5 * (125 / 126) * 0.75 * 40_000, unit: 'kg px²/s²', relative: 1e-9, preset: 'Half elastic' },
      ({ world, lost }) => lost - energy(world).kinetic,
    ),
    at(
      2.5,
      'Cosine of the angle between the two ways, if one was at rest',
      { exact: 0, absolute: 1e-12, preset: 'One at rest' },
      ({ world, red, blue }) => {
        const [a, b] = [velocityOf(world, red), velocityOf(world, blue)];
        return (a.x * b.x + a.y * b.y) / Math.sqrt((a.x * a.x + a.y * a.y) * (b.x * b.x + b.y * b.y));
      },
    ),
    at(
      2,
      'Energy after the oblique collision',
      { exact: (10_000 + 900 + 2500 + 900) / 2, unit: 'kg px²/s²', relative: 1e-12, preset: 'Equal balls, oblique' },
      ({ world }) => energy(world).kinetic,
    ),
  ],
  tryThis: [
    'Choose “One at rest”, as in billiards: the balls leave at a right angle.',
    'Choose “They stay together”: the momentum is as before, the energy is not.',
  ],
});
