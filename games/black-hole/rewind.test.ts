import { restore, snapshot, step } from '@principia/physics';
import { expect, it } from 'vitest';
import { createGame, type Input } from './sim.ts';

const VALUES = { fuel: true, moving: true, steep: false, autopilot: true };

function run(game: ReturnType<typeof createGame>, seconds: number): void {
  for (let i = Math.round(seconds / game.dt); i > 0; i--) step(game.world, game.dt);
}

it.each([1, 5])('an autopilot repeats the same flight after a rewind, seed %i', { timeout: 60_000 }, (seed) => {
  const game = createGame({ values: VALUES, seed });
  run(game, 8);
  const taken = snapshot(game.world);
  run(game, 25);
  const hash = game.hash();
  const { eventCount } = game.rules;
  // The layout changed meanwhile.
  expect(eventCount).toBeGreaterThan(1);
  restore(game.world, taken);
  run(game, 25);
  expect(game.hash()).toBe(hash);
  expect(game.rules.eventCount).toBe(eventCount);
});

it('after a rewind the log contains only inputs that are still valid', () => {
  const game = createGame({ values: { ...VALUES, autopilot: false }, seed: 4 });
  const press = (input: Input, seconds: number) => {
    game.press(input);
    run(game, seconds);
  };
  press('up', 1);
  const taken = snapshot(game.world);
  press('left', 3);
  press('redraw', 2);
  restore(game.world, taken);
  press('right', 2);
  press('release', 1);
  const again = createGame({ values: { ...VALUES, autopilot: false }, seed: 4, log: game.log.entries });
  run(again, 4);
  expect(again.hash()).toBe(game.hash());
  expect(game.log.entries.map(({ input }) => input)).toEqual(['up', 'right', 'release']);
});

it('a player who holds nothing lets go of what a restored moment holds', () => {
  const game = createGame({ values: { ...VALUES, autopilot: false }, seed: 4 });
  game.press('up');
  run(game, 0.5);
  const taken = snapshot(game.world);
  game.press('release');
  run(game, 0.5);
  restore(game.world, taken);
  expect(game.rules.push).toBeDefined();
  game.letGo();
  run(game, 0.1);
  expect(game.rules.push).toBeUndefined();
});

it('a game in which the autopilot flew is not ranked, whoever flew last', () => {
  const game = createGame({ values: VALUES, seed: 1 });
  run(game, 3);
  game.press('no autopilot');
  run(game, 0.1);
  expect(game.rules.isAssisted).toBe(true);
  game.rules.restart();
  expect(game.rules.isAssisted).toBe(false);
});
