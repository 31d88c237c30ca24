import {
  createEmitter,
  createPhysicsWorld,
  emitterCounts,
  quadraticDrag,
  rgba,
  spawn,
  uniformGravity,
} from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { addHandle } from '../support/handle.ts';
import { atanh, tanh } from '../support/hyperbolic.ts';
import { integerPower } from '../support/oscillator.ts';
import { velocityOf } from '../support/read.ts';

const [BUOYANCY, DRAG] = [2, 0.003];
/** Speed at which the hot gas rises when drag balances its buoyancy. */
const RISE = Math.sqrt(BUOYANCY / DRAG);
/** A twenty-fifth of the opacity goes thirty times a second. */
const LIFE = 25 / 30;
/** A hundredth larger with each of twenty-five ticks. */
const GROWTH = integerPower(1.01, 25);

/** From red to yellow: flames flicker between them. */
const FLAMES = [0.4, 0.55, 0.7, 0.85, 0.97].map((green) => [rgba(1, green, 0.1, 0.9), rgba(1, green * 0.6, 0, 0)]);

export default defineExample({
  id: 'ch12-fire',
  title: 'Fire',
  chapter: 12,
  tags: ['particles', 'drag', 'buoyancy'],
  about:
    'The same as smoke with other numbers: larger, redder, and gone within a second. A flame is hot gas that rises; where it has cooled we see it no more. Only some twenty-five sparks at a time make the whole fire. Drag the grip to move it.',
  duration: 15,
  parameters: {
    rate: { label: 'Flames a second', unit: '1/s', initial: 30, min: 5, max: 300 },
    life: { label: 'Life of a flame', unit: 's', initial: LIFE, min: 0.2, max: 2 },
    spread: { label: 'Thrown sideways by', unit: 'px/s', initial: 30, min: 0, max: 100 },
  },
  presets: [{ label: 'A blaze', values: { rate: 300, life: 1.2 } }],
  build({ rate, life, spread }, { seed, ...options }) {
    const forces = [uniformGravity({ y: -BUOYANCY }), quadraticDrag()];
    const world = createPhysicsWorld({ capacity: 700, seed, forces, ...options });
    const handle = addHandle(world, { x: 350, y: 330 });
    const emitter = createEmitter(world, {
      capacity: Math.ceil(rate * life) + 2,
      entity: handle,
      rate,
      lifetime: life,
      speed: 80,
      direction: { y: -1 },
      spread: 0,
      velocitySpread: { x: spread, y: 40 },
      mass: 1,
      quadraticDrag: DRAG,
      size: [4.5, 4.5 * GROWTH],
      sizeFactor: [2 / 3, 4 / 3],
      color: FLAMES,
    });
    const ember = { position: { x: 480, y: 340 }, velocity: { y: -100 }, mass: 1, quadraticDrag: DRAG, collider: 3 };
    const speck = spawn(world, { ...ember, appearance: rgba(1, 0.85, 0.4) });
    return { world, dt: 1 / 60, emitter, speck };
  },
  picture({ speck }) {
    return {
      yDown: true,
      view: { minX: 150, maxX: 550, minY: 80, maxY: 380 },
      fills: [{ shape: { minX: -2000, maxX: 3000, minY: -2000, maxY: 3000 }, color: 0x05070f }],
      trails: [{ body: speck, length: 300 }],
    };
  },
  plots: (plot) => [
    plot('Speed of the ember', 'v upwards, px/s', {
      label: 'ember',
      value: ({ world, speck }) => -velocityOf(world, speck).y,
    }),
    plot('Flames', 'number', { label: 'visible', value: ({ emitter }) => emitterCounts(emitter).alive }),
  ],
  checks: ({ at }) => [
    at(
      10,
      'Flames that are visible, the rate times the life',
      { exact: ({ rate, life }) => rate * life, absolute: 1 },
      ({ emitter }) => emitterCounts(emitter).alive,
    ),
    at(
      10,
      'Speed of the ember after 10 s; the limit is 25.82',
      { exact: RISE / tanh((BUOYANCY / RISE) * 10 + atanh(RISE / 100)), unit: 'px/s', relative: 1e-3 },
      ({ world, speck }) => -velocityOf(world, speck).y,
    ),
    at(
      0,
      'How much a flame grows in its life, 1.01 to the power of 25',
      { exact: 1.01 ** 25, unit: '×', absolute: 5e-4 },
      () => GROWTH,
    ),
  ],
  tryThis: [
    'Choose “A blaze”: fourteen times as many flames, and taller ones, because they live longer.',
    'Let a flame live for two seconds: now you see that it slows down.',
  ],
});
