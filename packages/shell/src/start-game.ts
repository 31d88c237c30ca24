import { readAddress } from './address.ts';
import type { GameDefinition, Simulation } from './game.ts';
import { GameApp } from './game-app.ts';
import type { Settings } from './settings.ts';

/**
 * Runs a game on this page: builds the toolbar, the panel, the plot and the help around its picture, and sets
 * `globalThis.__game` for tests. Errors appear as sentences on the page.
 */
export async function startGame<S extends Settings, Sim extends Simulation>(
  game: GameDefinition<S, Sim>,
): Promise<void> {
  const address = readAddress(location.search, game.settings, Object.keys(game.renderers));
  const varies = game.variesSeed === true && !address.manual && !new URLSearchParams(location.search).has('seed');
  const seed = varies ? 1 + (Date.now() % 999_983) : address.seed;
  await new GameApp(game, { ...address, seed }).start();
}
