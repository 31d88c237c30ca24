import { readAddress } from './address.ts';
import type { GameDefinition, Simulation } from './game.ts';
import { GameApp } from './game-app.ts';
import type { Settings } from './settings.ts';

/**
 * Runs a game on this page: builds the toolbar, the panel, the plot and the help around its picture, and sets
 * `globalThis.__game` for tests. Errors appear as sentences on the page.
 * @param query the part of the address with settings and seed; a page that reads names of its own leaves them out
 * @param problems sentences about the address, for a page that reads names of its own
 */
export async function startGame<S extends Settings, Sim extends Simulation>(
  game: GameDefinition<S, Sim>,
  query: string = location.search,
  problems: readonly string[] = [],
): Promise<void> {
  const address = readAddress(query, game.settings, Object.keys(game.renderers));
  const varies = game.variesSeed === true && !address.manual && !new URLSearchParams(query).has('seed');
  const seed = varies ? 1 + (Date.now() % 999_983) : address.seed;
  await new GameApp(game, { ...address, seed, problems: [...problems, ...address.problems] }).start();
}
