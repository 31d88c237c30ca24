import { readAddress } from './address.ts';
import type { GameDefinition, Simulation } from './game.ts';
import { GameApp } from './game-app.ts';
import type { Settings } from './settings.ts';

/**
 * Plays a game on this page: builds the bar, the panel, the plot and the help around its picture, and puts
 * `globalThis.__game` there for tests. Whatever goes wrong ends as a sentence on the screen.
 */
export async function startGame<S extends Settings, Sim extends Simulation>(
  game: GameDefinition<S, Sim>,
): Promise<void> {
  const address = readAddress(location.search, game.settings, Object.keys(game.renderers));
  await new GameApp(game, address).start();
}
