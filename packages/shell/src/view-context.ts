import type { Simulation, ViewContext } from './game.ts';
import type { Layout } from './layout.ts';
import type { Preferences } from './preferences.ts';
import type { Session } from './session.ts';
import type { Settings } from './settings.ts';

/** The services of the shell that a view uses; they always refer to the present world. */
export function createViewContext<S extends Settings, Sim extends Simulation>(
  layout: Layout,
  session: Session<S, Sim>,
  preferences: Preferences,
  own: Pick<ViewContext<S, Sim>, 'isSpaceHeld' | 'toggle' | 'showMessage' | 'clip'>,
): ViewContext<S, Sim> {
  return {
    ...own,
    element: layout.stage,
    insets: () => layout.insets(),
    sim: () => session.sim,
    values: () => session.values,
    alpha: () => session.alpha,
    dragging: () => session.dragging,
    get reducedMotion() {
      return preferences.reducedMotion;
    },
    get safeColors() {
      return preferences.safeColors;
    },
  };
}
