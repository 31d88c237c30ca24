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
import { tanh } from '../support/hyperbolic.ts';
import { velocityOf } from '../support/read.ts';

const GRAVITY = 20;
const DRAG = 0.003;
/** Terminal speed √(g/k). */
const TERMINAL = Math.sqrt(GRAVITY / DRAG);

export default defineExample({
  id: 'ch12-emitter',
  title: 'A spring of particles',
  chapter: 12,
  tags: ['particles', 'drag', 'terminal speed'],
  about:
    'Thirty times a second a particle is thrown up, and falls. There are never more than 120: when all are in use, the oldest is taken from the air and thrown again. So the stream goes on for ever with the same few, and each is four seconds old when it is used again. Drag the grip to move the spring.',
  duration: 12,
  parameters: {
    rate: { label: 'Particles a second', unit: '1/s', initial: 30, min: 5, max: 200 },
    most: { label: 'At most', initial: 120, min: 10, max: 1000, integer: true },
    drag: { label: 'Drag coefficient', unit: 'kg/px', initial: DRAG, min: 0, max: 0.02 },
  },
  presets: [{ label: 'A cloud', values: { rate: 200, most: 1000, drag: 0.02 } }],
  build({ rate, most, drag }, { seed, ...options }) {
    const forces = [uniformGravity({ y: GRAVITY }), quadraticDrag()];
    const world = createPhysicsWorld({ capacity: 1100, seed, forces, ...options });
    const handle = addHandle(world, { x: 350, y: 250 });
    const emitter = createEmitter(world, {
      capacity: most,
      entity: handle,
      rate,
      whenFull: 'oldest',
      lifetime: 1000,
      speed: 80,
      direction: { y: -1 },
      spread: 0,
      velocitySpread: { x: 30, y: 40 },
      mass: 1,
      quadraticDrag: drag,
      size: 3,
      color: [rgba(0.5, 0.8, 1), rgba(0.5, 0.8, 1)],
    });
    // A ball that is only dropped shows the terminal speed of the particles.
    const ball = spawn(world, { position: { x: 650, y: 20 }, mass: 1, quadraticDrag: drag, collider: 4 });
    return { world, dt: 1 / 60, emitter, ball };
  },
  picture({ emitter }) {
    return {
      yDown: true,
      view: { minX: 0, maxX: 700, minY: 0, maxY: 600 },
      labels: [{ at: { x: 20, y: 580 }, text: () => `${emitterCounts(emitter).alive} particles` }],
    };
  },
  plots: (plot) => [
    plot('Particles', 'number', { label: 'alive', value: ({ emitter }) => emitterCounts(emitter).alive }),
    plot('Speed of the ball that falls', 'v, px/s', {
      label: 'ball',
      value: ({ world, ball }) => velocityOf(world, ball).y,
    }),
  ],
  checks: ({ at }) => [
    at(2, 'Particles after 2 s', { exact: 60, absolute: 1 }, ({ emitter }) => emitterCounts(emitter).alive),
    at(10, 'Particles after 10 s', { exact: 120, absolute: 0 }, ({ emitter }) => emitterCounts(emitter).alive),
    at(
      10,
      'Age at which they are used again: that of all by the number of births a second',
      { exact: 4, unit: 's', absolute: 1 / 30 },
      ({ emitter }) => 10 - emitterCounts(emitter).ended / 30,
    ),
    at(
      10,
      'Speed after a fall of 10 s; the terminal speed is 81.65',
      { exact: TERMINAL * tanh((GRAVITY / TERMINAL) * 10), unit: 'px/s', relative: 1e-3 },
      ({ world, ball }) => velocityOf(world, ball).y,
    ),
  ],
  tryThis: [
    'Make 300 the most: the stream reaches further down before it is used again.',
    'Choose “A cloud”: strong drag makes smoke of the spray.',
  ],
});
