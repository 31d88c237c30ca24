/** Which ghosts an example has: the choices of the panel. */
import { INTEGRATORS } from '@principia/physics';
import type { Example, ExampleOptions } from '@principia/scenes/examples';
import type { ChoiceSetting } from '@principia/shell';
import { Ghost, Ghosts } from './ghosts.ts';

/** One scheme of each kind: energy grows, stays about right, and is right to many digits. */
const SCHEMES = ['explicitEuler', 'semiImplicitEuler', 'velocityVerlet', 'rungeKutta4'] as const;
const COLORS = [0xff7b72, 0xffe08a, 0x5fd6a2, 0xb79cff];
/** Deviations of the parameters of neighbours, as fractions of their values. */
const DEVIATIONS = [-0.02, -0.01, 0.01, 0.02];

export const ghostsSetting: ChoiceSetting = {
  kind: 'choice',
  label: 'Ghosts',
  initial: 'none',
  choices: { None: 'none', 'Other integrators': 'integrators', 'Values ± 1 and 2 %': 'neighbours' },
  about: 'The same example run beside this one: rings in the picture, thin lines in the plots',
};

/** @param own name of the integrator of the run on display */
export function makeGhosts(kind: string, example: Example, options: ExampleOptions, own: string): Ghosts {
  if (kind === 'integrators') return new Ghosts(otherIntegrators(example, options, own));
  if (kind === 'neighbours') return new Ghosts(neighbours(example, options));
  return new Ghosts([]);
}

function otherIntegrators(example: Example, options: ExampleOptions, own: string): Ghost[] {
  const records = SCHEMES.map((name) => INTEGRATORS[name]).filter(({ name }) => name !== own);
  return records.map((record, i) => {
    const run = example.start({ ...options, integrator: record.create() });
    return new Ghost(record.name, COLORS[i], run);
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
