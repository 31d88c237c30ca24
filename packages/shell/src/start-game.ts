import { checkOptions, type OptionNames } from '@principia/render-core';
import { readAddress } from './address.ts';
import type { GameDefinition, Simulation } from './game.ts';
import { GameApp } from './game-app.ts';
import { isPreview } from './preview.ts';
import type { Settings } from './settings.ts';

/** Where and with what a game starts. */
export interface StartOptions {
  /**
   * Element that the game fills; it needs a width and a height. The game then hears keys only while it has the focus, and
   * leaves the address and the errors of the page to the page. Default the whole page.
   */
  readonly parent?: HTMLElement;
  /**
   * The part of an address with settings and seed; a page that reads names of its own leaves them out, and keeps what changes
   * in its address itself. Default `location.search`, in which settings then follow the panel, and nothing for a game in an element.
   */
  readonly query?: string;
  /** Sentences about the address, for a page that reads names of its own. Default none. */
  readonly problems?: readonly string[];
}

/** A game that runs on this page. */
export interface RunningGame {
  /** Settles when the picture and the panel are there, or the game was stopped. */
  readonly ready: Promise<void>;
  /**
   * Ends the game: its loop, its listeners, its elements, its view and its world. A video that is being recorded is saved.
   * Further calls do nothing.
   */
  stop(): void;
}

const OPTION_NAMES: OptionNames<StartOptions> = { parent: true, query: true, problems: true };

/**
 * Runs a game on this page, or in an element of it: builds the toolbar, the panel, the plot and the help around its picture,
 * and sets `globalThis.__game` for tests. Errors appear as sentences on the page.
 *
 * @throws Error when `parent` is no element, or an option does not exist
 */
export function startGame<S extends Settings, Sim extends Simulation>(
  game: GameDefinition<S, Sim>,
  options: StartOptions = {},
): RunningGame {
  checkOptions(options, OPTION_NAMES, 'startGame');
  const { parent, query, problems = [] } = options;
  if (parent !== undefined && !(parent instanceof Element)) {
    throw new Error(`startGame needs an element as parent, or none for the whole page, got ${String(parent)}`);
  }
  const read = query ?? (parent === undefined ? location.search : '');
  const address = readAddress(read, game.settings, Object.keys(game.renderers));
  const varies = game.variesSeed === true && !address.manual && !new URLSearchParams(read).has('seed');
  const seed = varies ? 1 + (Date.now() % 999_983) : address.seed;
  // An address that the game does not read cannot name what it shows.
  const pageLink = parent !== undefined && query === undefined ? () => location.href : undefined;
  const ownsAddress = parent === undefined && query === undefined && game.link === undefined && !isPreview;
  const app = new GameApp(
    game,
    { ...address, seed, problems: [...problems, ...address.problems] },
    { parent, link: game.link?.bind(game) ?? pageLink, ownsAddress },
  );
  return { ready: app.start(), stop: () => app.stop() };
}
