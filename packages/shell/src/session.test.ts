import {
  createPhysicsWorld,
  keepState,
  type PhysicsWorld,
  replaceForce,
  spawn,
  stateHash,
  uniformGravity,
} from '@principia/physics';
import { expect, it } from 'vitest';
import type { GameDefinition, Simulation } from './game.ts';
import { Session } from './session.ts';
import { initialValues, numberSetting } from './settings.ts';

const settings = {
  count: numberSetting({ unit: '', initial: 3, min: 1, max: 9, integer: true }, { label: 'Stones' }),
  gravity: numberSetting({ unit: 'm/s²', initial: 10, min: 0, max: 30 }, { label: 'Gravity' }),
};

/** A clock that goes on by `milliseconds` whenever it is read. */
function ticking(milliseconds: number): () => number {
  let now = 0;
  return () => {
    now += milliseconds;
    return now;
  };
}

/** Stones that fall; the seed is how fast they start. */
const game: GameDefinition<typeof settings, Simulation> = {
  title: 'Stones',
  settings,
  renderers: {},
  create({ values, seed, dimensions }) {
    const world = createPhysicsWorld({ dimensions, capacity: 9, forces: [uniformGravity({ y: -values.gravity })] });
    for (let i = 0; i < values.count; i++) spawn(world, { position: { x: i }, velocity: { y: seed }, mass: 1 });
    return { world, dt: 0.01 };
  },
  apply(sim, name, values) {
    if (name !== 'gravity') return false;
    replaceForce(sim.world, uniformGravity({ y: -values.gravity }));
    return true;
  },
};

function started(clock = ticking(1)): { session: Session<typeof settings, Simulation>; world: () => PhysicsWorld } {
  const session = new Session(game, initialValues(settings), 4, clock);
  session.reset();
  return { session, world: () => session.sim.world };
}

it('turns time into steps, slower in slow motion, and into none while paused', () => {
  const { session, world } = started();
  session.advance(0.025);
  expect([world().tick, session.steps]).toEqual([2, 2]);
  expect(session.alpha).toBeCloseTo(0.5, 9);
  session.speed = 0.1;
  session.advance(0.03);
  expect(world().tick).toBe(2);
  expect(session.alpha).toBeCloseTo(0.8, 9);
  session.paused = true;
  const hash = stateHash(world());
  session.advance(10);
  expect([stateHash(world()), session.steps]).toEqual([hash, 0]);
  session.step(3);
  expect([world().tick, session.alpha]).toEqual([5, 1]);
});

it('does not try to make up for a frame that took too long', () => {
  const { session, world } = started();
  session.advance(3);
  expect(world().tick).toBe(6); // a fifteenth of a second
});

it('takes one step a frame where steps are slow', () => {
  const { session, world } = started(ticking(120));
  session.advance(0.04);
  expect([world().tick, session.stepTime]).toEqual([4, 30]);
  session.advance(0.04);
  expect([world().tick, session.stepTime]).toEqual([5, 120]);
});

it('measures a step', () => {
  const { session } = started();
  session.advance(0.02);
  expect(session.stepTime).toBe(0.5); // one tick of the clock for two steps
});

it('starts again at the same bits, and at others with another seed', () => {
  const { session, world } = started();
  session.step(10);
  const hash = stateHash(world());
  session.reset();
  expect(world().tick).toBe(0);
  session.step(10);
  expect(stateHash(world())).toBe(hash);
  session.reset(5);
  session.step(10);
  expect(session.seed).toBe(5);
  expect(stateHash(world())).not.toBe(hash);
});

it('gives the running world what it can take, and asks for a new one else', () => {
  const { session, world } = started();
  expect(session.set('gravity', 2)).toBe(false);
  session.step();
  expect(world().components.Velocity.y[1]).toBeCloseTo(4 - 0.02, 12);
  expect(session.set('count', 9)).toBe(true);
  session.reset();
  expect(world().components.Position.x[9]).toBe(8);
  expect(world().forces[0].parameters?.accelerationY.value).toBe(-2);
});

it('refuses what is no setting or does not fit, and stays as it was', () => {
  const { session } = started();
  expect(() => session.set('toString', 1)).toThrow('There is no setting “toString”. The settings are count, gravity.');
  expect(() => session.set('count', 10)).toThrow('count must be a whole number from 1 to 9');
  expect(session.values).toEqual({ count: 3, gravity: 10 });
});

it('goes back in time: world, values and what the game keeps beside them, and on from there', () => {
  const kept = { points: 0 };
  const remembering: typeof game = {
    ...game,
    create(options) {
      const sim = game.create(options);
      keepState(sim.world, kept);
      return sim;
    },
  };
  const session = new Session(remembering, initialValues(settings), 4, () => 0);
  session.reset();
  const { world } = session.sim;
  session.step(50);
  const hash = stateHash(world);
  kept.points = 3;
  session.set('gravity', 2);
  session.step(50);
  expect(session.rewound).toBe(false);
  // In small pieces, as frames come: a moment is kept every 5 steps.
  for (let i = 0; i < 50; i++) session.rewind(0.01);
  expect([world.tick, stateHash(world), session.rewound]).toEqual([50, hash, true]);
  expect([session.values.gravity, kept.points]).toEqual([10, 0]);
  session.step();
  expect(world.components.Velocity.y[1]).toBeCloseTo(4 - 10 * 0.51, 12);
  expect(session.stepBack()).toBe(true);
  expect(session.stepBack()).toBe(true);
  expect(world.tick).toBe(49);
  session.rewind(100);
  expect([world.tick, session.historySeconds, session.rewind(1)]).toEqual([0, 0, false]);
  session.reset();
  expect(session.rewound).toBe(false);
});

it('counts a rewind against the attempt in which it happened, where a world has several', () => {
  let attempts = 1;
  const session = new Session({ ...game, attempt: () => attempts }, initialValues(settings), 4, () => 0);
  session.reset();
  session.step(20);
  session.rewind(0.1);
  expect(session.rewound).toBe(true);
  attempts++;
  expect(session.rewound).toBe(false);
  session.step(20);
  expect(session.rewound).toBe(false);
  // Back before the attempt began: what is flown from there is no fair attempt either.
  session.rewind(0.3);
  expect(session.rewound).toBe(true);
});

it('gives a body that was held then its mass back', () => {
  const { session, world } = started();
  session.dragging.grab(1, 2, 1, 0);
  session.step(20);
  session.dragging.release(1, 0, 0);
  session.step(20);
  session.rewind(0.3);
  expect(world().tick).toBe(10);
  expect([world().components.Mass.value[2], session.dragging.dragged]).toEqual([1, []]);
});

it('goes back by single steps also while bodies that were held then are let go', () => {
  const { session, world } = started(() => 0);
  session.dragging.grab(1, 2, 1, 0);
  session.step(64);
  const ticks = [63, 62, 61, 60, 59, 58].map(() => session.stepBack() && world().tick);
  expect(ticks).toEqual([63, 62, 61, 60, 59, 58]);
  expect([world().components.Mass.value[2], session.dragging.dragged]).toEqual([1, []]);
});
