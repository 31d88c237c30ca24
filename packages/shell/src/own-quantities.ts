/** The quantities of a game's own as the plot reads them. */
import type { GameDefinition, Simulation } from './game.ts';
import type { OwnQuantities } from './plot-sources.ts';
import type { Settings } from './settings.ts';

/** Neither a total, which begins with a capital, nor a column, which has a point, nor a list of what the address says. */
const NAME = /^[a-z][A-Za-z0-9]*$/;
/** What stands in the address for a plot that is not shown. */
const TAKEN = 'off';

/**
 * @param sim returns what is on display; a value is not a number before there is anything
 * @throws Error where the address could not have a name
 */
export function ownQuantities<Sim extends Simulation>(
  quantities: GameDefinition<Settings, Sim>['quantities'] = {},
  sim: () => Sim | undefined,
): OwnQuantities {
  const own: Record<string, OwnQuantities[string]> = {};
  for (const [name, quantity] of Object.entries(quantities)) {
    if (!NAME.test(name) || name === TAKEN) {
      const rule = "letters and digits that begin with a small letter, and not 'off'";
      throw new Error(
        `the name of a quantity of a game must be ${rule}, as it stands in the address, but is '${name}'`,
      );
    }
    const { label, unit } = quantity;
    const value = () => {
      const shown = sim();
      return shown === undefined ? Number.NaN : quantity.value(shown);
    };
    own[name] = { label, unit, value };
  }
  return own;
}
