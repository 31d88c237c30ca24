/** The cards beside the picture. They are not needed at the start, so they are loaded after the first frame. */
import type { PhysicsWorld } from '@principia/physics';
import type { Actions } from './commands.ts';
import { createPanel, type Panel } from './panel.ts';
import { createPlotCard, type PlotCard } from './plot-card.ts';
import { createProfileCard, type ProfileCard } from './profile-card.ts';
import type { Settings } from './settings.ts';
import { createStats, type Stats } from './stats.ts';
import { createToolsCard, type ToolsCard } from './tools-card.ts';

/** The cards, from top to bottom. */
export interface Sidebar {
  readonly panel: Panel;
  readonly plot: PlotCard;
  readonly stats: Stats;
  readonly profile: ProfileCard;
  readonly tools: ToolsCard;
}

export interface SidebarOptions {
  readonly settings: Settings;
  /** Read for display; written only through `set`. */
  readonly values: Readonly<Record<string, unknown>>;
  readonly set: (name: string, value: unknown) => void;
  /** The world on display. */
  readonly world: () => PhysicsWorld | undefined;
  readonly actions: Actions;
  /** Whether games can be replayed. */
  readonly canReplay: boolean;
  /** Creates the game's own cards. */
  readonly cards: (parent: HTMLElement) => void;
}

export function createSidebar(parent: HTMLElement, options: SidebarOptions): Sidebar {
  const { settings, values, set, world, actions, canReplay, cards } = options;
  const panel = createPanel(parent, settings, values, set);
  cards(parent);
  return {
    panel,
    plot: createPlotCard(parent, world),
    stats: createStats(parent),
    profile: createProfileCard(parent),
    tools: createToolsCard(parent, actions, canReplay),
  };
}
