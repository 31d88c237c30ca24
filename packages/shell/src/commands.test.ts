import { expect, it } from 'vitest';
import { type Actions, gameCommands } from './commands.ts';
import { FOUR_WAYS } from './controls.ts';
import type { GameDefinition, Simulation } from './game.ts';
import { switchSetting } from './settings.ts';

/** Actions that write down what was done. */
function recorded() {
  const done: string[] = [];
  const actions = new Proxy({} as Actions, {
    get: (_, name) => (given?: unknown) => done.push(given === undefined ? String(name) : `${String(name)} ${given}`),
  });
  return { done, actions };
}

type Game = GameDefinition<Record<string, never>, Simulation>;
const renderer = (dimensions: 2 | 3) => ({ label: `${dimensions}D`, dimensions, open: () => Promise.reject() });
const plain = { title: 'Stones', settings: {}, renderers: { pixi: renderer(2) } } as unknown as Game;

it('gives every key a line of the help, and every line a key', () => {
  const { done, actions } = recorded();
  const { pressed, released, help } = gameCommands(plain, actions);
  for (const key of ['s', '-', 'b']) pressed[key]();
  released.b(false);
  expect(done).toEqual(['slow s', 'zoom 0.8', 'rewind true', 'rewind false']);
  expect(help).toContainEqual(['.', 'one step']);
  // Arrow keys steer or do nothing: who presses one expects no pause.
  expect(pressed.arrowright).toBeUndefined();
  expect(new Set(help.map(([, what]) => what)).size).toBe(help.length);
  expect(help.map(([keys]) => keys).join()).not.toContain('2');
});

it('numbers renderers of equal dimensions', () => {
  const { done, actions } = recorded();
  const renderers = { pixi: { ...renderer(2), label: 'pixi.js' }, three: { ...renderer(2), label: 'three.js' } };
  const { pressed, help } = gameCommands({ ...plain, renderers } as unknown as Game, actions);
  pressed['1']();
  pressed['2']();
  expect(done).toEqual(['renderer pixi', 'renderer three']);
  expect(help).toContainEqual(['1 2', 'draw in pixi.js or three.js']);
});

it('leaves the keys that a game takes to the game, in the help too', () => {
  const { done, actions } = recorded();
  const game = {
    ...plain,
    settings: { mute: switchSetting('Sound', true, { key: 'm' }) },
    controls: { buttons: FOUR_WAYS, press() {}, release() {} },
    renderers: { pixi: renderer(2), three: renderer(3) },
    help: [
      ['Drag, click', 'throw', 'Drag'],
      ['Arrow keys', 'steer', ''],
      ['Wheel, pinch', 'zoom; the right button turns', 'Pinch', 'zoom'],
    ],
  } as unknown as Game;
  const { pressed, help, gestures } = gameCommands(game, actions);
  expect(gestures).toEqual([
    ['Drag', 'throw'],
    ['Pinch', 'zoom'],
  ]);
  pressed.m();
  pressed['3']();
  expect(done).toEqual(['toggle mute', 'renderer three']);
  expect(help.slice(0, 5)).toEqual([
    ['Drag, click', 'throw'],
    ['Arrow keys', 'steer'],
    ['Wheel, pinch', 'zoom; the right button turns'],
    ['M', 'Sound on or off'],
    ['2 3', 'draw in 2D or 3D'],
  ]);
  expect(help.map(([keys]) => keys).filter((keys) => keys === 'M')).toHaveLength(1);
});

it('names the gestures of the views and the buttons on the screen where a game has no help for touch', () => {
  const { actions } = recorded();
  const controls = {
    buttons: { ...FOUR_WAYS, action: { label: '●', keys: [' '] }, mute: { label: 'M', keys: ['m'], touch: false } },
    press() {},
    release() {},
  };
  const inputs = (game: object) => gameCommands({ ...plain, ...game } as unknown as Game, actions).gestures;
  const bar = ['❚❚ ▶', '◀◀', '↻', 'Sliders', '?'];
  expect(inputs({}).map(([input]) => input)).toEqual(['Drag a body', 'Two fingers', ...bar]);
  const renderers = { three: renderer(3) };
  const lines = inputs({ controls, renderers, help: [['Arrow keys', 'steer', '']] });
  const pad = ['▲', '◀', '▶', '▼', '●'];
  expect(lines.map(([input]) => input)).toEqual(['Drag a body', 'Drag beside bodies', 'Two fingers', ...pad, ...bar]);
  expect(lines).toContainEqual(['●', 'action']);
});
