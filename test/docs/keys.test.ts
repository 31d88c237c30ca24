import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { type Actions, gameCommands } from '../../packages/shell/src/commands.ts';
import { FOUR_WAYS } from '../../packages/shell/src/controls.ts';
import type { GameDefinition, Simulation } from '../../packages/shell/src/game.ts';
import { withMarkedPart } from './marked-table.ts';

type Game = GameDefinition<Record<string, never>, Simulation>;

const renderer = (dimensions: 2 | 3) => ({ label: `${dimensions}D`, dimensions, open: () => Promise.reject() });

/** A game with everything that the shell gives a key to. */
const game = {
  title: 'A game',
  settings: {},
  renderers: { pixi: renderer(2), three: renderer(3) },
  replay: () => undefined,
} as unknown as Game;

const page = readFileSync('docs/keys.md', 'utf8');
const { help, pressed } = gameCommands(game, {} as Actions);

test('docs/keys.md lists the keys of the shell; `npx vitest run test/docs/keys.test.ts -u` writes it', async () => {
  const rows = help.map(([keys, what]) => `| ${keys} | ${what} |`);
  const names = Object.keys(pressed).map((name) => (name === ' ' ? '`space`' : `\`${name}\``));
  const taken = `Taken, by the names of \`KeyboardEvent.key\`: ${names.join(' ')}`;
  const part = ['| key | what it does |', '|---|---|', ...rows, '', taken].join('\n');
  await expect(withMarkedPart(page, part)).toMatchFileSnapshot('../../docs/keys.md');
});

test('the page names the places of the touch pad', () => {
  for (const name of Object.keys(FOUR_WAYS)) expect(page).toContain(`\`${name}\``);
});
