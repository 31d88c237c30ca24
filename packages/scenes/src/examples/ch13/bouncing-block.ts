import {
  angularDrag,
  box,
  createPhysicsWorld,
  energy,
  rgba,
  rigidBodies,
  sin,
  softStep,
  spawn,
  uniformGravity,
} from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf, velocityOf } from '../support/read.ts';

/** Twenty pixels of the book are a metre here, because contacts are made for lengths of about a metre. */
const [GRAVITY, FLOOR] = [1, 0];
const SIDE = Math.SQRT1_2;
/** Height of the centre above the lowest corner at 45°, and that corner’s distance to the side. */
const [UP, ASIDE] = [3.75 * SIDE, 1.25 * SIDE];
const START = 17.5;
const [TIME, SPEED] = [Math.sqrt((2 * (START - UP)) / GRAVITY), Math.sqrt(2 * GRAVITY * (START - UP))];

/** When the velocities after the first impact are measured. */
const AFTER = 5.5;

/** Impulse at the corner, (1 + e) v/(1/m + a²/I) for 1 kg. */
const impulse = (restitution: number, inertia: number) => ((1 + restitution) * SPEED) / (1 + (ASIDE * ASIDE) / inertia);

/** Whether the corner that hit is in the air still, which is thrown up at e v and falls at g. */
const isThrown = ({ restitution }: ValuesOf<'restitution' | 'inertia'>) =>
  2 * restitution * SPEED > GRAVITY * (AFTER - TIME);

export default defineExample({
  id: 'ch13-bouncing-block',
  title: 'A block falls on its corner',
  chapter: 13,
  tags: ['rigid bodies', 'collision', 'rotation', 'restitution'],
  about:
    'The block lands on a corner that is not below its centre. So the floor’s push does two things: it throws the block back, and it turns it. The next corner lands, and the next; each bounce loses energy, and in the end the block lies flat. At first its moment of inertia is larger than an even block of this size can have, so that it turns slowly enough to watch; a preset has the true one.',
  duration: 30,
  parameters: {
    restitution: { label: 'Restitution e', initial: 0.4, min: 0, max: 0.9 },
    inertia: { label: 'Moment of inertia', unit: 'kg m²', initial: 12.5, min: 2, max: 25 },
  },
  presets: [{ label: 'The true inertia, m (w² + h²)/12', values: { inertia: 31.25 / 12 } }],
  build({ restitution, inertia }) {
    const world = createPhysicsWorld({
      preset: rigidBodies,
      capacity: 8,
      forces: [uniformGravity({ y: -GRAVITY }), angularDrag()],
      integrator: softStep({ substeps: 8, restitutionThreshold: 0.05 }),
    });
    spawn(world, {
      position: { y: FLOOR - 2 },
      collider: { shape: box(60, 4), restitution },
      appearance: rgba(0.29, 0.33, 0.47),
    });
    const block = spawn(world, {
      position: { y: START },
      velocity: {},
      mass: 1,
      inertia,
      rotation: Math.PI / 4,
      angularVelocity: 0,
      angularDrag: 0.0025,
      collider: { shape: box(5, 2.5), restitution },
      appearance: rgba(0.3, 0.55, 1),
    });
    const start = energy(world).total;
    /** Energy gained since the start: never positive. */
    const gained = () => energy(world).total - start;
    const angle = () => world.components.Rotation.angle[block];
    const spin = () => world.components.AngularVelocity.z[block];
    return { world, dt: 1 / 240, block, gained, angle, spin };
  },
  picture({ world, block }) {
    return {
      view: { minX: -20, maxX: 20, minY: -4, maxY: 21 },
      trails: [{ body: block, length: 1500, interval: 6 }],
      arrows: [velocityArrow(world, block, 0.8)],
    };
  },
  plots: (plot) => [
    plot('Height of the centre', 'y, m', { label: 'block', value: ({ world, block }) => positionOf(world, block).y }),
    plot('Angular velocity', 'ω, rad/s', { label: 'block', value: ({ spin }) => spin() }),
  ],
  checks: ({ at, largest }) => [
    {
      label: 'Time of the first impact, √(2h/g)',
      unit: 's',
      exact: TIME,
      tolerance: { relative: 1e-3 },
      at: { event: ({ spin }) => Math.abs(spin()) - 0.01 },
    },
    at(
      AFTER,
      'Velocity upwards after it, (J − m v)/m',
      {
        exact: ({ restitution, inertia }) => impulse(restitution, inertia) - SPEED,
        holds: isThrown,
        unit: 'm/s',
        // The difference of two numbers as large as v.
        absolute: 3e-4 * SPEED,
      },
      ({ world, block }) => velocityOf(world, block).y + GRAVITY * (world.time - TIME),
    ),
    at(
      AFTER,
      'Angular velocity after it, J a/I',
      {
        exact: ({ restitution, inertia }) => (impulse(restitution, inertia) * ASIDE) / inertia,
        holds: isThrown,
        unit: 'rad/s',
        relative: 1e-3,
      },
      ({ spin }) => Math.abs(spin()),
    ),
    at(
      AFTER,
      'Impulse of the floor, (1 + e) v/(1/m + a²/I)',
      {
        exact: ({ restitution, inertia }) => impulse(restitution, inertia),
        holds: isThrown,
        unit: 'N s',
        relative: 1e-3,
      },
      ({ world, block }) => velocityOf(world, block).y + GRAVITY * (world.time - TIME) + SPEED,
    ),
    at(
      AFTER,
      'Speed of the corner after it, e times that before',
      { exact: ({ restitution }) => restitution * SPEED, holds: isThrown, unit: 'm/s', absolute: 3e-4 * SPEED },
      ({ world, block, spin }) => velocityOf(world, block).y + GRAVITY * (world.time - TIME) + Math.abs(spin()) * ASIDE,
    ),
    largest(30, 'Most energy gained at any time', { exact: 0, unit: 'J', absolute: 1e-3 }, ({ gained }) => gained()),
    at(
      30,
      'Sine of twice the angle at the end: it lies flat',
      { exact: 0, absolute: (2 * 0.1 * Math.PI) / 180 },
      ({ angle }) => sin(2 * angle()),
    ),
  ],
  tryThis: [
    'Make the inertia smaller: the block spins faster after the first impact, and is thrown up less.',
    'Set e to 0: it does not jump, but topples over its corner.',
  ],
});
