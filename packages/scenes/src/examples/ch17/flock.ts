import {
  atan2,
  centreOfMass,
  createPhysicsWorld,
  createRandom,
  defineForce,
  defineLaw,
  exp,
  type Force,
  momentum,
  type PhysicsWorld,
  pairsWithin,
  polygon,
  rgba,
  scalar,
  select,
  semiImplicitEuler,
  spawn,
} from '@principia/physics';
import type { SceneRun } from '../../scene.ts';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { lengthOf, speedOf, velocityOf } from '../support/read.ts';

type Values = ValuesOf<'birds' | 'range' | 'alignment' | 'cohesion' | 'separation' | 'will'>;

/** Speed at which birds like to fly, m/s, and the distance that they keep, m. */
const [CRUISE, KEPT] = [5, 1.3];

/** Beyond this distance from the middle they turn back, m. */
const HOME = 11;

/** How near the hawk may come, m, and the acceleration that it causes there at once, m/s². */
const [FEAR, FRIGHT] = [5, 60];

interface Hawk {
  at: Point | undefined;
}

interface FlockRun extends SceneRun {
  readonly birds: readonly number[];
  readonly hawk: Hawk;
  /** How far all fly the same way: |Σv| / Σ|v|. */
  order(): number;
  /** Root of the mean square of the differences from the mean velocity, m/s. */
  spread(): number;
  /** The spread at the start, m/s, and the momentum, kg m/s. */
  readonly start: number;
  readonly drift: number;
}

/** What neighbours do to each other: Reynolds, Flocks, Herds, and Schools (SIGGRAPH 1987). */
function betweenBirds({ range, alignment, cohesion, separation }: Values): Force {
  return defineForce({
    name: 'flocking',
    equation: 'F = m Σ (k Δv + c Δr − s (1/r − 1/d) Δr)',
    reads: ['Position', 'Velocity', 'Mass'],
    readsOfOthers: [],
    local: false,
    accumulate(world) {
      const { Position: p, Velocity: v } = world.components;
      const { force } = world.scratch;
      const { count, a, b } = pairsWithin(world, range);
      for (let i = 0; i < count; i++) {
        const [one, other] = [a[i], b[i]];
        const [dx, dy] = [p.x[other] - p.x[one], p.y[other] - p.y[one]];
        const distance = Math.sqrt(dx * dx + dy * dy);
        const near = Math.max(distance, 0.1);
        const pull = cohesion - (near < KEPT ? separation * (1 / near - 1 / KEPT) : 0);
        const fx = alignment * (v.x[other] - v.x[one]) + pull * dx;
        const fy = alignment * (v.y[other] - v.y[one]) + pull * dy;
        force.x[one] += fx;
        force.y[one] += fy;
        force.x[other] -= fx;
        force.y[other] -= fy;
      }
    },
  });
}

/** Each bird likes to fly at its own speed, and not too far away. */
const ownWill = defineLaw({
  name: 'own will',
  formula: 'a = w (1 − v²/c²) v − (r − h) r̂ beyond h',
  parameters: { will: scalar('1/s', { min: 0 }) },
  acceleration({ position, velocity }, { will }) {
    const cruise = velocity.mul(
      will.mul(
        velocity
          .lengthSquared()
          .div(-CRUISE * CRUISE)
          .add(1),
      ),
    );
    const distance = position.length();
    const beyond = select(distance.greater(HOME), distance.sub(HOME).div(distance), 0);
    return cruise.sub(position.mul(beyond));
  },
});

/** Birds flee from the hawk, the faster the nearer it is. */
function fleeing(hawk: Hawk, birds: readonly number[]): Force {
  return defineForce({
    name: 'fleeing',
    equation: 'F = m f (1 − r/R) r̂',
    reads: ['Position', 'Mass'],
    local: false,
    readsOfOthers: [],
    accumulate({ components: { Position }, scratch: { force } }) {
      if (hawk.at === undefined) return;
      for (const id of birds) {
        const [dx, dy] = [Position.x[id] - hawk.at.x, Position.y[id] - hawk.at.y];
        const distance = Math.sqrt(dx * dx + dy * dy);
        if (distance >= FEAR || distance === 0) continue;
        const push = (FRIGHT * (1 - distance / FEAR)) / distance;
        force.x[id] += push * dx;
        force.y[id] += push * dy;
      }
    },
  });
}

/** Birds look where they fly. */
function turn({ components: { Rotation, Velocity } }: PhysicsWorld, birds: readonly number[]): void {
  for (const id of birds) Rotation.angle[id] = atan2(Velocity.y[id], Velocity.x[id]);
}

export default defineExample({
  id: 'ch17-flock',
  title: 'A flock',
  chapter: 17,
  tags: ['neighbours', 'self-organization', 'damping', 'interactive'],
  about:
    'No bird leads. Each looks at the few that are near: it flies as they fly, stays with them, and keeps its distance. That is all, and it is a flock, which wheels and divides like starlings in the evening. Press where a hawk should be, and drag it through them.',
  duration: 30,
  parameters: {
    birds: { label: 'Birds', initial: 200, min: 2, max: 400, integer: true },
    range: { label: 'How far they see', unit: 'm', initial: 2.5, min: 0.5, max: 60 },
    alignment: { label: 'Flying alike, per neighbour', unit: '1/s', initial: 0.3, min: 0, max: 0.5 },
    cohesion: { label: 'Staying together, per neighbour', unit: '1/s²', initial: 0.12, min: 0, max: 0.5 },
    separation: { label: 'Keeping distance', unit: 'm/s²', initial: 20, min: 0, max: 40 },
    will: { label: 'Urge to keep the cruising speed', unit: '1/s', initial: 1.5, min: 0, max: 5 },
  },
  presets: [
    { label: 'Blind', values: { alignment: 0, cohesion: 0 } },
    { label: 'All see all', values: { range: 60, alignment: 0.01, cohesion: 0, separation: 0, will: 0 } },
  ],
  build(values: Values, { seed, integrator = semiImplicitEuler }: BuildOptions): FlockRun {
    const hawk: Hawk = { at: undefined };
    const birds: number[] = [];
    const forces = [betweenBirds(values), fleeing(hawk, birds), ownWill({ will: values.will })];
    const world = createPhysicsWorld({ capacity: 420, forces, integrator });
    const random = createRandom(seed);
    const shape = polygon([{ x: 0.4 }, { x: -0.25, y: 0.2 }, { x: -0.25, y: -0.2 }]);
    for (let i = 0; i < values.birds; i++) {
      const position = random.onCircle(8 * Math.sqrt(random.uniform(0, 1)));
      const velocity = random.onCircle(CRUISE);
      const shade = random.uniform(0.7, 1);
      const appearance = rgba(0.55 * shade, 0.8 * shade, shade);
      birds.push(spawn(world, { position, velocity, mass: 1, rotation: {}, collider: { shape }, appearance }));
    }
    turn(world, birds);
    world.phases.finish.push(() => turn(world, birds));
    const mean = () => {
      const { x, y } = momentum(world);
      return { x: x / birds.length, y: y / birds.length };
    };
    const order = () => (lengthOf(mean()) * birds.length) / birds.reduce((sum, id) => sum + speedOf(world, id), 0);
    const spread = () => {
      const { x, y } = mean();
      const squares = birds.map((id) => {
        const v = velocityOf(world, id);
        return (v.x - x) * (v.x - x) + (v.y - y) * (v.y - y);
      });
      return Math.sqrt(squares.reduce((sum, square) => sum + square, 0) / birds.length);
    };
    return { world, dt: 1 / 120, birds, hawk, order, spread, start: spread(), drift: lengthOf(momentum(world)) };
  },
  actions: {
    hawk: {
      label: 'hawk',
      key: 'h',
      about: 'a hawk in the middle of the flock, as long as it is held',
      press: ({ world, hawk }) => {
        hawk.at = centreOfMass(world);
      },
      release: ({ hawk }) => {
        hawk.at = undefined;
      },
    },
  },
  pointer: {
    about: 'a hawk, which you drag through the flock',
    press: ({ hawk }, at) => {
      hawk.at = at;
    },
    move: ({ hawk }, at) => {
      hawk.at = at;
    },
    release: ({ hawk }) => {
      hawk.at = undefined;
    },
    cancel: ({ hawk }) => {
      hawk.at = undefined;
    },
  },
  picture: ({ hawk }) => ({
    view: { minX: -18, maxX: 18, minY: -14, maxY: 14 },
    // Where no hawk is, the dot is out of sight.
    dots: [{ at: () => hawk.at ?? { x: 1e4, y: 0 }, radius: 10, color: COLORS.red }],
  }),
  plots: (plot) => [plot('Order', '|Σv| / Σ|v|', { label: 'all fly the same way: 1', value: ({ order }) => order() })],
  checks: ({ at, largest }) => [
    largest(30, 'Greatest order within half a minute', { exact: 1, absolute: 0.05 }, ({ order }) => order()),
    at(
      1,
      'Difference of velocities after 1 s where all see all, by that at the start, e^(−k N t)',
      {
        exact: ({ alignment, birds }) => exp(-alignment * birds),
        relative: 0.02,
        preset: 'All see all',
      },
      ({ spread, start }) => spread() / start,
    ),
    at(
      1,
      'What they agree on there, by the mean velocity at the start',
      { exact: 1, relative: 1e-10, preset: 'All see all' },
      ({ world, drift }) => lengthOf(momentum(world)) / drift,
    ),
  ],
  tryThis: [
    'Choose “Blind”: they keep their distance, and nothing else. There is no flock.',
    'Set the urge to keep the cruising speed to 0: what they agree on is slower and slower, because each turn costs speed.',
    'Drag the hawk slowly, then quickly: which divides the flock?',
  ],
});
