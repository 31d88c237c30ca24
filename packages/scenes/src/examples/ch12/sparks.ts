import {
  createEmitter,
  createPhysicsWorld,
  emitterCounts,
  quadraticDrag,
  rgba,
  uniformGravity,
} from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { addHandle } from '../support/handle.ts';

export default defineExample({
  id: 'ch12-sparks',
  title: 'A sparkler',
  chapter: 12,
  tags: ['particles', 'drag', 'random'],
  about:
    'Sixty sparks a second fly out in all directions, and each lives for six to eight seconds. After seven seconds or so as many die as are born, and their number stays near the rate times the mean life: 420. That law holds for sparks, for customers in a shop and for stars.',
  duration: 30,
  parameters: {
    rate: { label: 'Sparks a second', unit: '1/s', initial: 60, min: 5, max: 200 },
    life: { label: 'Mean life', unit: 's', initial: 7, min: 1, max: 10 },
    drag: { label: 'Drag coefficient', unit: 'kg/px', initial: 0.005, min: 0, max: 0.05 },
  },
  presets: [{ label: 'Many that die soon', values: { rate: 200, life: 2.1 } }],
  build({ rate, life, drag }, { seed, ...options }) {
    const forces = [uniformGravity({ y: 10 }), quadraticDrag()];
    const world = createPhysicsWorld({ capacity: 2600, seed, forces, ...options });
    const handle = addHandle(world, { x: 350, y: 180 });
    const yellow = rgba(1, 1, 0.35);
    const emitter = createEmitter(world, {
      capacity: 2500,
      entity: handle,
      rate,
      lifetime: [(life * 6) / 7, (life * 8) / 7],
      speed: 0,
      velocitySpread: { x: 50, y: 50 },
      mass: 1,
      quadraticDrag: drag,
      size: 2.5,
      color: [yellow, rgba(1, 0.6, 0.2, 0.6), rgba(1, 0.3, 0.1, 0.1)],
    });
    return { world, dt: 1 / 60, emitter };
  },
  picture({ emitter }) {
    return {
      yDown: true,
      view: { minX: 0, maxX: 700, minY: 0, maxY: 500 },
      fills: [{ shape: { minX: -2000, maxX: 3000, minY: -2000, maxY: 3000 }, color: 0x05070f }],
      labels: [{ at: { x: 20, y: 480 }, text: () => `${emitterCounts(emitter).alive} sparks` }],
    };
  },
  plots: (plot) => [
    plot('Sparks', 'number', {
      label: 'alive',
      value: ({ emitter }) => emitterCounts(emitter).alive,
      exact: (t, { rate, life }) => rate * Math.min(t, life),
    }),
  ],
  checks: ({ at }) => [
    at(
      5,
      'Sparks after 5 s: none has died',
      { exact: 300, absolute: 1 },
      ({ emitter }) => emitterCounts(emitter).alive,
    ),
    at(
      25,
      'Sparks after 25 s, the rate times the mean life',
      // N sparks scatter by about √N/5, since 2/7 of them are of an age at which some have died: by 2 % of 170.
      { exact: ({ rate, life }) => rate * life, holds: ({ rate, life }) => rate * life > 170, relative: 0.05 },
      ({ emitter }) => emitterCounts(emitter).alive,
    ),
    at(
      25,
      'The same for many that die soon: 200 · 2.1',
      { exact: 420, relative: 0.05, preset: 'Many that die soon' },
      ({ emitter }) => emitterCounts(emitter).alive,
    ),
  ],
  tryThis: [
    'Choose “Many that die soon”: the number is the same, but it is reached after two seconds.',
    'Set the drag to zero: the sparks fly on parabolas instead of slowing down.',
  ],
});
