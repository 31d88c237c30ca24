/** Which ghosts an example has: the choices of the panel. */
import { INTEGRATORS } from '@principia/physics';
import type { Example, ExampleOptions } from '@principia/scenes/examples';
import type { ChoiceSetting } from '@principia/shell';
import { Ghost, Ghosts } from './ghosts.ts';
import { WORDS } from './words.ts';

/** One scheme of each kind: energy grows, stays about right, and is right to many digits. */
const SCHEMES = ['explicitEuler', 'semiImplicitEuler', 'velocityVerlet', 'rungeKutta4'] as const;
const COLORS = [0xff7b72, 0xffe08a, 0x5fd6a2, 0xb79cff];
/** Deviations of the parameters of neighbours, as fractions of their values. */
const DEVIATIONS = [-0.02, -0.01, 0.01, 0.02];

export const ghostsSetting: ChoiceSetting = {
  kind: 'choice',
  label: WORDS.settings.ghosts[0],
  initial: 'none',
  choices: Object.fromEntries(Object.entries(WORDS.ghosts).map(([kind, label]) => [label, kind])),
  about: WORDS.settings.ghosts[1],
};

/** @param own name of the integrator of the run on display */
export function makeGhosts(kind: string, example: Example, options: ExampleOptions, own: string): Ghosts {
  if (kind === 'integrators') return new Ghosts(otherIntegrators(example, options, own));
  if (kind === 'neighbours') return new Ghosts(neighbours(example, options));
  return new Ghosts([]);
}

function otherIntegrators(example: Example, options: ExampleOptions, own: string): Ghost[] {
  const names = SCHEMES.filter((name) => INTEGRATORS[name].name !== own);
  return names.map((name, i) => {
    const run = example.start({ ...options, integrator: INTEGRATORS[name].create() });
    return new Ghost(WORDS.integrators[name], COLORS[i], run);
  });
}

/** All parameters that are no choices deviate together; limits of their ranges hold. */
function neighbours(example: Example, options: ExampleOptions): Ghost[] {
  return DEVIATIONS.map((deviation, i) => {
    const values = Object.entries(options.values ?? {}).map(([name, value]) => {
      const { min, max, integer } = example.parameters[name];
      return [name, integer ? value : Math.min(max, Math.max(min, value * (1 + deviation)))];
    });
    const run = example.start({ ...options, values: Object.fromEntries(values) });
    return new Ghost(`${deviation > 0 ? '+' : '−'}${Math.abs(100 * deviation)} %`, COLORS[i], run);
  });
}
