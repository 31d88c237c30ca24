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

const [BUOYANCY, DRAG] = [5, 0.005];
/** Speed at which smoke rises when drag balances its buoyancy. */
const RISE = Math.sqrt(BUOYANCY / DRAG);
/** A hundredth of the opacity goes thirty times a second. */
const LIFE = 100 / 30;
/** A hundredth larger with each of a hundred ticks. */
const GROWTH = integerPower(1.01, 100);

export default defineExample({
  id: 'ch12-smoke',
  title: 'Smoke',
  chapter: 12,
  tags: ['particles', 'drag', 'buoyancy'],
  about:
    'Each puff is lighter than the air, so that gravity seems to pull it upwards. Drag soon brings it to the speed at which smoke rises. It grows as it mixes with air, and fades: after three seconds it is gone. Drag the grip to move the fire below it.',
  duration: 15,
  parameters: {
    rate: { label: 'Puffs a second', unit: '1/s', initial: 30, min: 5, max: 120 },
    buoyancy: { label: 'Pulled upwards by', unit: 'px/s²', initial: BUOYANCY, min: 0, max: 30 },
    wind: { label: 'Wind', unit: 'px/s', initial: 0, min: -60, max: 60 },
  },
  presets: [{ label: 'In the wind', values: { wind: 40 } }],
  build({ rate, buoyancy, wind }, { seed, ...options }) {
    const forces = [uniformGravity({ y: -buoyancy }), quadraticDrag({ x: wind })];
    const world = createPhysicsWorld({ capacity: 520, seed, forces, ...options });
    const handle = addHandle(world, { x: 350, y: 430 });
    const emitter = createEmitter(world, {
      capacity: Math.ceil(rate * LIFE) + 2,
      entity: handle,
      rate,
      lifetime: LIFE,
      speed: 80,
      direction: { y: -1 },
      spread: 0,
      velocitySpread: { x: 30, y: 40 },
      mass: 1,
      quadraticDrag: DRAG,
      size: [3, 3 * GROWTH],
      sizeFactor: [0.5, 2],
      color: [rgba(0.9, 0.9, 0.95, 0.7), rgba(0.9, 0.9, 0.95, 0)],
    });
    // A speck of ash that one can follow.
    const ash = { position: { x: 600, y: 480 }, velocity: { y: -120 }, mass: 1, quadraticDrag: DRAG, collider: 4 };
    const speck = spawn(world, { ...ash, appearance: rgba(1, 0.7, 0.35) });
    return { world, dt: 1 / 60, emitter, speck };
  },
  picture({ speck }) {
    return {
      yDown: true,
      view: { minX: 0, maxX: 700, minY: 0, maxY: 500 },
      fills: [{ shape: { minX: -2000, maxX: 3000, minY: -2000, maxY: 3000 }, color: 0x05070f }],
      trails: [{ body: speck, length: 600 }],
    };
  },
  plots: (plot) => [
    plot('Speed of the speck of ash', 'v upwards, px/s', {
      label: 'ash',
      value: ({ world, speck }) => -velocityOf(world, speck).y,
    }),
    plot('Puffs', 'number', { label: 'visible', value: ({ emitter }) => emitterCounts(emitter).alive }),
  ],
  checks: ({ at }) => [
    at(
      10,
      'Puffs that are visible, the rate times 3.33 s',
      { exact: ({ rate }) => rate * LIFE, absolute: 1 },
      ({ emitter }) => emitterCounts(emitter).alive,
    ),
    // From above, v = v_T coth(a t/v_T + artanh(v_T/v₀)).
    at(
      10,
      'Speed after 10 s; the limit is 31.62',
      { exact: RISE / tanh((BUOYANCY / RISE) * 10 + atanh(RISE / 120)), unit: 'px/s', relative: 1e-3 },
      ({ world, speck }) => -velocityOf(world, speck).y,
    ),
    at(
      0,
      'How much a puff grows in its life, 1.01 to the power of 100',
      { exact: 1.01 ** 100, unit: '×', absolute: 5e-4 },
      () => GROWTH,
    ),
  ],
  tryThis: [
    'Choose “In the wind”: the plume bends over, and its far end moves nearly as fast as the wind.',
    'Set the upward pull to zero: the puffs are only thrown, and stop in the air.',
  ],
});
