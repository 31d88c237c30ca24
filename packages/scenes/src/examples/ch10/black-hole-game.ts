import { keepState, rgba } from '@principia/physics';
import { blackHole } from '../../black-hole.ts';
import { BLACK_HOLE } from '../../black-hole-layout.ts';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { held } from '../support/held.ts';
import { distanceBetween, positionOf, speedOf } from '../support/read.ts';

/** Errors of the energy are judged outside this many radii of the holes. */
const CLEARANCE = 2;

interface Steered {
  readonly steer: (x: number, y: number) => void;
}

const steerUp = ({ steer }: Steered, up: number) => steer(0, up);
const steerRight = ({ steer }: Steered, right: number) => steer(right, 0);

export default defineExample({
  id: 'ch10-black-hole-game',
  title: 'A ship among black holes',
  chapter: 10,
  tags: ['gravity', 'escape speed', 'energy', 'control'],
  about:
    'Steer the ship past the black holes to the line at the top. Each hole is so heavy that light, which has 200 px/s here, just cannot escape from its rim; the ship is far slower. Let go of the keys and it falls, and keeps its energy, until it is swallowed or leaves. The whole game has rounds, lives and fuel.',
  duration: 20,
  parameters: {
    count: { label: 'Black holes', initial: 3, min: 1, max: 12, integer: true },
    push: { label: 'Push of an engine', unit: 'px/s²', initial: BLACK_HOLE.thrust, min: 1, max: 40 },
    start: { label: 'Speed upwards at the start', unit: 'px/s', initial: 60, min: 0, max: 150 },
  },
  presets: [{ label: 'Eight holes', values: { count: 8 } }],
  build({ count, push, start }: ValuesOf<'count' | 'push' | 'start'>, { seed }: BuildOptions) {
    const scene = blackHole.create({ seed, count });
    const { world, ship, holeIds, dt } = scene;
    const { Attractor, Collider, Velocity, Thrust, Appearance } = world.components;
    for (const id of holeIds) Appearance.color[id] = rgba(0.02, 0.02, 0.05);
    Velocity.y[ship] = start;
    const nearest = () =>
      holeIds.reduce(
        (least, id) =>
          Math.min(least, distanceBetween(positionOf(world, ship), positionOf(world, id)) / Collider.radius[id]),
        Infinity,
      );
    const energyOf = () =>
      holeIds.reduce(
        (sum, id) => sum - Attractor.mu[id] / distanceBetween(positionOf(world, ship), positionOf(world, id)),
        (speedOf(world, ship) * speedOf(world, ship)) / 2,
      );
    const flight = { energy: energyOf(), isFree: true, worst: 0, crossed: 0 };
    keepState(world, flight);
    const restart = () => {
      scene.placeShip(BLACK_HOLE.start.x, BLACK_HOLE.start.y);
      Velocity.y[ship] = start;
      flight.isFree = false;
    };
    world.phases.input.push(() => {
      const { x, y } = positionOf(world, ship);
      if (y > BLACK_HOLE.goal) flight.crossed++;
      if (nearest() < 1 || y > BLACK_HOLE.goal || y < 0 || x < 0 || x > BLACK_HOLE.width) restart();
      flight.isFree = flight.isFree && nearest() > CLEARANCE && Thrust.x[ship] === 0 && Thrust.y[ship] === 0;
      const scale = Math.max(Math.abs(flight.energy), (speedOf(world, ship) * speedOf(world, ship)) / 2);
      if (flight.isFree) flight.worst = Math.max(flight.worst, Math.abs(energyOf() - flight.energy) / scale);
    });
    const escapes = () => holeIds.map((id) => Math.sqrt((2 * Attractor.mu[id]) / Collider.radius[id]));
    const steer = (x: number, y: number) => {
      Thrust.x[ship] = push * x;
      Thrust.y[ship] = push * y;
    };
    return { world, dt, ship, holeIds, flight, escapes, steer };
  },
  picture({ world, ship, holeIds, flight }) {
    const { x, y } = world.components.Position;
    const { radius } = world.components.Collider;
    return {
      view: { minX: 0, maxX: BLACK_HOLE.width, minY: 0, maxY: BLACK_HOLE.height },
      fills: holeIds.map((id) => ({
        shape: { centre: { x: x[id], y: y[id] }, radius: 1.4 * radius[id] },
        color: COLORS.violet,
        opacity: 0.35,
      })),
      lines: [
        { from: { x: 0, y: BLACK_HOLE.goal }, to: { x: BLACK_HOLE.width, y: BLACK_HOLE.goal }, color: COLORS.green },
      ],
      trails: [{ body: ship, length: 900, interval: 2 }],
      arrows: [velocityArrow(world, ship, 0.6)],
      labels: [{ at: { x: 20, y: BLACK_HOLE.goal + 20 }, text: () => `crossed ${flight.crossed} times` }],
    };
  },
  actions: {
    up: held('▲', 'arrowup', 'push upwards', steerUp),
    down: held('▼', 'arrowdown', 'push downwards', steerUp, -1),
    left: held('◀', 'arrowleft', 'push to the left', steerRight, -1),
    right: held('▶', 'arrowright', 'push to the right', steerRight),
  },
  plots: (plot) => [plot('Speed', 'v, px/s', { label: 'ship', value: ({ world, ship }) => speedOf(world, ship) })],
  checks: ({ at }) => [
    at(
      0,
      'Largest escape speed from a rim, √(2GM/r)',
      { exact: () => BLACK_HOLE.lightSpeed, unit: 'px/s', relative: 1e-9 },
      ({ escapes }) => escapes().reduce((a, b) => Math.max(a, b)),
    ),
    at(
      0,
      'Smallest escape speed from a rim',
      { exact: () => BLACK_HOLE.lightSpeed, unit: 'px/s', relative: 1e-9 },
      ({ escapes }) => escapes().reduce((a, b) => Math.min(a, b)),
    ),
    at(
      10,
      'Largest error of the energy of the first flight, outside two radii',
      { exact: 0, absolute: 1e-3 },
      ({ flight }) => flight.worst,
    ),
  ],
  tryThis: [
    'Fly close past a hole without falling in: it flings you to the other side.',
    'Set the push to 1: now gravity decides, and you can only aim.',
  ],
});
