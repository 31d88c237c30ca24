import {
  cos,
  createEmitter,
  createPhysicsWorld,
  emitterCounts,
  linearDrag,
  rgba,
  sin,
  uniformGravity,
} from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';

const GRAVITY = 20;
const BASIN = { x: 350, y: 450 };
const ANGLES = [60, 70, 80, 90, 100, 110, 120];

export default defineExample({
  id: 'ch12-fountain',
  title: 'A fountain of seven jets',
  chapter: 12,
  tags: ['particles', 'projectile'],
  about:
    'Seven jets leave one nozzle at the same speed, from 60° to 120°. Every drop follows the parabola of its jet, and how high that goes depends only on the upward part of the velocity: (v sin θ)²/2g, 250 px for the middle one. The lines are these parabolas.',
  duration: 20,
  parameters: {
    speed: { label: 'Speed of the water', unit: 'px/s', initial: 100, min: 40, max: 120 },
    rate: { label: 'Drops a second and jet', unit: '1/s', initial: 25, min: 2, max: 100 },
    drag: { label: 'Drag coefficient', unit: '1/s', initial: 0, min: 0, max: 0.5 },
  },
  presets: [{ label: 'With drag', values: { drag: 0.2 } }],
  build({ speed, rate, drag }, { seed, ...options }) {
    const forces = [uniformGravity({ y: GRAVITY }), linearDrag()];
    const world = createPhysicsWorld({ capacity: 9000, seed, forces, ...options });
    const jets = ANGLES.map((degrees) => {
      const angle = (degrees * Math.PI) / 180;
      return createEmitter(world, {
        capacity: Math.ceil(rate * 12) + 2,
        position: BASIN,
        rate,
        // Until the drop is back at the height of the nozzle.
        lifetime: (2 * speed * sin(angle)) / GRAVITY,
        speed,
        direction: { x: cos(angle), y: -sin(angle) },
        spread: 0,
        mass: 1,
        linearDrag: drag,
        size: 2.5,
        color: [rgba(0.75, 0.9, 1), rgba(0.4, 0.65, 1)],
      });
    });
    const { Position, Appearance } = world.components;
    const drops = () => {
      const ids: number[] = [];
      for (let id = 1; id <= world.lastId; id++) if (Appearance.size[id] > 0) ids.push(id);
      return ids;
    };
    const highest = () => drops().reduce((top, id) => Math.max(top, BASIN.y - Position.y[id]), 0);
    const widest = () => drops().reduce((far, id) => Math.max(far, Math.abs(Position.x[id] - BASIN.x)), 0);
    const count = () => jets.reduce((sum, jet) => sum + emitterCounts(jet).alive, 0);
    return { world, dt: 1 / 60, highest, widest, count };
  },
  picture(_run, { speed }) {
    return {
      yDown: true,
      view: { minX: -110, maxX: 810, minY: 160, maxY: 490 },
      fills: [{ shape: { minX: 250, maxX: 450, minY: BASIN.y, maxY: BASIN.y + 12 }, color: COLORS.ground }],
      curves: ANGLES.map((degrees) => {
        const angle = (degrees * Math.PI) / 180;
        const path = (t: number) => ({
          x: BASIN.x + speed * cos(angle) * t,
          y: BASIN.y - speed * sin(angle) * t + (GRAVITY / 2) * t * t,
        });
        return { points: pointsOf(path, 0, (2 * speed * sin(angle)) / GRAVITY, 60), color: COLORS.ground };
      }),
    };
  },
  plots: (plot) => [plot('Drops in the air', 'number', { label: 'all', value: ({ count }) => count() })],
  checks: ({ at, largest }) => [
    // A drop that is born within a step moves on straight until its end: up to v dt too far.
    largest(15, 'Apex of the middle jet, v²/2g', { exact: 250, unit: 'px', absolute: 100 / 60 }, ({ highest }) =>
      highest(),
    ),
    largest(
      15,
      'Reach of the outer jets, v² sin 120°/g',
      { exact: 250 * Math.sqrt(3), unit: 'px', absolute: 100 / 60 },
      ({ widest }) => widest(),
    ),
    at(
      15,
      'Drops in the air, the rate times 2 v sin θ/g of all jets',
      {
        exact: ({ speed, rate }) =>
          ANGLES.reduce((sum, degrees) => sum + (rate * 2 * speed * sin((degrees * Math.PI) / 180)) / GRAVITY, 0),
        absolute: ANGLES.length,
      },
      ({ count }) => count(),
    ),
  ],
  tryThis: [
    'Double the speed from 50 to 100: the fountain becomes four times as high.',
    'Choose “With drag”: the drops fall short of the lines, and come down more steeply than they went up.',
  ],
});
