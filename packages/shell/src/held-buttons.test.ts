import { expect, it } from 'vitest';
import { HeldButtons } from './held-buttons.ts';

function recorded(exclusive?: string[][]) {
  const seen: string[] = [];
  const held = new HeldButtons(
    { press: (name) => seen.push(`+${name}`), release: (name) => seen.push(`-${name}`) },
    exclusive,
  );
  return { seen, held };
}

it('presses a button once, however many inputs hold it', () => {
  const { seen, held } = recorded();
  held.set('up', 'key', true);
  held.set('up', 'pad', true);
  held.set('up', 'key', false);
  held.set('up', 'pad', false);
  held.set('up', 'pad', false);
  expect(seen).toEqual(['+up', '-up']);
});

it('goes back to a direction that is still held when a later one is let go', () => {
  const { seen, held } = recorded([['up', 'right']]);
  held.set('up', 'key', true);
  held.set('right', 'key', true);
  held.set('right', 'key', false);
  held.set('up', 'key', false);
  expect(seen).toEqual(['+up', '+right', '+up', '-up']);
});

it('keeps the later direction when the earlier one is let go first', () => {
  const { seen, held } = recorded([['left', 'right']]);
  held.set('left', 'key', true);
  held.set('right', 'key', true);
  held.set('left', 'key', false);
  held.set('right', 'key', false);
  expect(seen).toEqual(['+left', '+right', '-right']);
});

it('tells another simulation what is held: of directions the one that counts', () => {
  const { seen, held } = recorded([['left', 'right']]);
  held.pressAgain();
  expect(seen).toEqual([]);
  held.set('left', 'key', true);
  held.set('right', 'key', true);
  held.set('fire', 'key', true);
  held.set('fire', 'pad', true);
  held.set('horn', 'key', true);
  held.set('horn', 'key', false);
  held.pressAgain();
  expect(seen.slice(5)).toEqual(['+right', '+fire']);
  held.set('fire', 'key', false);
  held.set('fire', 'pad', false);
  expect(seen.slice(7)).toEqual(['-fire']);
});

it('lets go of what an input held that is gone, and of everything at once', () => {
  const { seen, held } = recorded([['left', 'right']]);
  held.set('left', 'pad 0', true);
  held.set('fire', 'pad 0', true);
  held.set('fire', 'key', true);
  held.drop('pad 0');
  expect(seen).toEqual(['+left', '+fire', '-left']);
  held.set('left', 'key', true);
  held.set('right', 'key', true);
  held.clear();
  held.clear();
  expect(seen.slice(3)).toEqual(['+left', '+right', '-right', '-fire']);
});
