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
