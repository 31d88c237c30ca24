import { describe, expect, it } from 'vitest';
import { play, win } from './game-lab.ts';
import { ReachedLevel } from './reached.ts';

function memoryStore(text: string | null = null) {
  let kept = text;
  return {
    getItem: () => kept,
    setItem: (_: string, value: string) => {
      kept = value;
    },
  };
}

/** A game whose player has just crossed the goal line, which opens the second level. */
function wonGame(values: Parameters<typeof play>[1] = {}) {
  const game = play(1, values);
  game.press('up');
  win(game);
  expect(game.rules.dodged).toBe(values.level ?? 1);
  return game;
}

describe('the levels at which a game may begin', () => {
  it('are those that the player reached, also after a reload', () => {
    const store = memoryStore();
    const reached = new ReachedLevel('', store);
    expect(reached.highest).toBe(1);
    reached.note(wonGame());
    expect(reached.highest).toBe(2);
    reached.note(wonGame({ level: 6 }));
    reached.note(wonGame());
    expect(reached.highest).toBe(7);
    expect(new ReachedLevel('?seed=3', store).highest).toBe(7);
  });

  it('are not taken back by another tab', () => {
    const store = memoryStore();
    const [one, other] = [new ReachedLevel('', store), new ReachedLevel('', store)];
    one.note(wonGame({ level: 6 }));
    other.note(wonGame());
    expect(other.highest).toBe(7);
    expect(new ReachedLevel('', store).highest).toBe(7);
  });

  it('are not those that the autopilot or a replay reached', () => {
    const reached = new ReachedLevel('', memoryStore());
    const game = wonGame();
    for (const flag of ['autopilot', 'isDemo', 'isReplay']) {
      const { rules } = game;
      reached.note({ rules, autopilot: false, isDemo: false, isReplay: false, [flag]: true } as never);
    }
    expect(reached.highest).toBe(1);
  });

  it('go up to that of a link, which is not kept', () => {
    const store = memoryStore();
    expect(new ReachedLevel('?level=5&seed=2', store).highest).toBe(5);
    expect(new ReachedLevel('', store).highest).toBe(1);
    for (const odd of ['?level=99', '?level=-3', '?level=x', '?level=2.5', '?level']) {
      expect(new ReachedLevel(odd, store).highest, odd).toBe(1);
    }
  });

  it.each(['{"a":1}', '"7"', '[[', '-2', '0', '3.5', '41'])(
    'begin with the first where the storage holds %s',
    (text) => {
      expect(new ReachedLevel('', memoryStore(text)).highest).toBe(1);
    },
  );
});
