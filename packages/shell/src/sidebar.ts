/** The cards beside the picture. They are not needed at the start, so they are loaded after the first frame. */
import type { ClipControl } from './clip-button.ts';
import type { Actions } from './commands.ts';
import type { GameDefinition, Simulation } from './game.ts';
import { ownQuantities } from './own-quantities.ts';
import { createPanel, type Panel } from './panel.ts';
import { PlotCard } from './plot-card.ts';
import { createProfileCard, type ProfileCard } from './profile-card.ts';
import type { Settings } from './settings.ts';
import type { Statistics } from './statistics.ts';
import { createStats } from './stats.ts';
import { createToolsCard, type ToolsCard } from './tools-card.ts';

/** The cards, from top to bottom. */
export interface Sidebar<Sim extends Simulation> {
  readonly panel: Panel;
  readonly plot: PlotCard;
  readonly profile: ProfileCard;
  readonly tools: ToolsCard;
  /** Records the values of plots and cards; call it after the steps of a frame, and `plot.record` after each of them. */
  record(sim: Sim, isPast: boolean): void;
  /** Shows the values; call it a few times a second. */
  show(sim: Sim, statistics: Statistics): void;
  destroy(): void;
}

export interface SidebarOptions<S extends Settings, Sim extends Simulation> {
  readonly game: GameDefinition<S, Sim>;
  /** Read for display; written only through `set`. */
  readonly values: Readonly<Record<string, unknown>>;
  readonly set: (name: string, value: unknown) => void;
  /** What is on display. */
  readonly sim: () => Sim | undefined;
  readonly actions: Actions;
  readonly clip: ClipControl;
  /** The plot that the address names, and what takes a sentence about it. */
  readonly plot: string | undefined;
  readonly report: (sentence: string) => void;
}

export async function createSidebar<S extends Settings, Sim extends Simulation>(
  parent: HTMLElement,
  options: SidebarOptions<S, Sim>,
): Promise<Sidebar<Sim>> {
  const { game, values, set, sim, actions, clip } = options;
  const panel = createPanel(parent, game.settings, values, set);
  const cards = (await game.cards?.(parent)) ?? [];
  const plot = new PlotCard(parent, sim, {
    units: game.units,
    own: ownQuantities(game.quantities, sim),
    interval() {
      const shown = sim();
      return shown && game.plotInterval?.(shown);
    },
  });
  const problem = options.plot === undefined ? '' : plot.choose(options.plot);
  if (problem !== '') options.report(problem);
  const stats = createStats(parent);
  const profile = createProfileCard(parent);
  const tools = createToolsCard(parent, actions, clip, game.replay !== undefined);
  return {
    panel,
    plot,
    profile,
    tools,
    // Called in every frame, so without a closure.
    record(sim, isPast) {
      plot.record(sim.world, isPast);
      for (let i = 0; i < cards.length; i++) cards[i].record?.(sim, isPast);
    },
    show(sim, statistics) {
      panel.showLimits();
      plot.draw();
      for (const card of cards) card.show(sim);
      profile.show(sim.world);
      stats.show(statistics);
    },
    destroy() {
      panel.destroy();
      plot.destroy();
      for (const card of cards) card.destroy?.();
    },
  };
}
