import type { Actions } from './commands.ts';
import type { Failures } from './failures.ts';
import { toggleFullScreen } from './full-screen.ts';
import type { Simulation, View } from './game.ts';
import type { HelpDialog } from './help-dialog.ts';
import { SLOW_MOTION } from './intervals.ts';
import type { Layout } from './layout.ts';
import type { AppearanceOptions } from './preferences.ts';
import type { Session } from './session.ts';
import type { Settings } from './settings.ts';
import type { Sharing } from './sharing.ts';
import type { Sidebar } from './sidebar.ts';
import type { SpaceBar } from './space-bar.ts';

/** The parts of a game on a page that the player's actions act on. */
export interface ActionTargets<S extends Settings, Sim extends Simulation> {
  readonly session: Session<S, Sim>;
  readonly address: { readonly manual: boolean };
  readonly views: { readonly view: View | undefined; show(renderer: string): Promise<void> };
  readonly failures: Failures;
  readonly layout: Layout;
  readonly help: HelpDialog;
  readonly space: SpaceBar;
  readonly sharing: Sharing;
  /** Undefined until it is loaded. */
  readonly sidebar: Sidebar<Sim> | undefined;
  readonly preferences: AppearanceOptions;
  /** The player holds the rewind button. */
  rewinding: boolean;
  /** Pauses or resumes; without an argument, toggles it. */
  pause(paused?: boolean): void;
  reset(): void;
  replaceWorld(make: () => void): void;
  restorePast(move: () => boolean): void;
  refresh(): void;
  change(changes: Partial<AppearanceOptions>): void;
  toggle(setting: string): void;
}

/** The actions of a player, by what they do to the parts of the game; they read the parts when they act. */
export function createActions<S extends Settings, Sim extends Simulation>(app: ActionTargets<S, Sim>): Actions {
  const { session, failures } = app;
  return {
    pause: () => app.pause(),
    step: () => {
      app.pause(true);
      failures.guard(() => session.step());
    },
    spaceBar: (down, isLost) => app.space.set(down, isLost),
    reset: () => {
      failures.guard(() => app.reset());
      app.views.view?.fit();
    },
    replay: () => {
      failures.guard(() => app.replaceWorld(() => session.replay()));
      if (!app.address.manual) app.pause(false);
      app.views.view?.canvas.focus();
    },
    slow: () => {
      session.speed = session.speed === 1 ? SLOW_MOTION : 1;
      app.refresh();
    },
    rewind: (on) => {
      app.rewinding = on;
      app.refresh();
    },
    stepBack: () => {
      app.pause(true);
      failures.guard(() => app.restorePast(() => session.stepBack()));
    },
    fit: () => app.views.view?.fit(),
    zoom: (factor) => app.views.view?.zoom(factor),
    help: () => app.help.toggle(),
    sidebar: () => app.layout.toggleSidebar(),
    plot: () => app.sidebar?.plot.next(),
    profile: () => app.sidebar?.profile.toggle(),
    copyLink: () => void app.sharing.share(),
    screenshot: () => app.sharing.saveScreenshot(),
    recordVideo: () => app.sharing.toggleVideo(),
    shareClip: () => app.sharing.toggle(),
    fullScreen: () => failures.attempt(() => toggleFullScreen(app.layout.root)),
    reducedMotion: () => app.change({ reducedMotion: !app.preferences.reducedMotion }),
    safeColors: () => app.change({ safeColors: !app.preferences.safeColors }),
    renderer: (name) => {
      failures.forget();
      void app.views.show(name);
    },
    toggle: (name) => app.toggle(name),
  };
}
