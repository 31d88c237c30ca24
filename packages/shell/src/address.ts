import { checkValue, initialValues, type NumberSetting, parseValue, type Settings, type ValuesOf } from './settings.ts';

/** What the address of a game's page asks for. */
export interface Address<S extends Settings> {
  readonly values: ValuesOf<S>;
  readonly seed: number;
  /** One of the game's renderers. */
  readonly renderer: string;
  /** No clock: only `__game.step(n)` moves the world. */
  readonly manual: boolean;
  /** A sentence for everything in the address that could not be taken. */
  readonly problems: readonly string[];
}

const SEED: NumberSetting = {
  kind: 'number',
  label: 'Seed',
  unit: '',
  initial: 1,
  min: 0,
  max: 2 ** 32 - 1,
  integer: true,
};

/**
 * Reads `?seed=7&count=2000&renderer=three&manual`. A value that cannot be taken leaves the initial one and a sentence.
 * @param query as in `location.search`
 * @param renderers names of the game's renderers, the first being the default
 */
export function readAddress<S extends Settings>(query: string, settings: S, renderers: readonly string[]): Address<S> {
  const values: Record<string, unknown> = initialValues(settings);
  const problems: string[] = [];
  const attempt = <T>(read: () => T, fallback: T): T => {
    try {
      return read();
    } catch (error) {
      problems.push(
        `In the address, ${(error as Error).message} It stays ${typeof fallback === 'boolean' ? (fallback ? 'on' : 'off') : fallback}.`,
      );
      return fallback;
    }
  };
  let seed = SEED.initial;
  let renderer = renderers[0];
  let manual = false;
  for (const [name, text] of new URLSearchParams(query)) {
    if (name === 'seed') seed = attempt(() => parseValue(name, SEED, text) as number, seed);
    else if (name === 'renderer') renderer = attempt(() => checkRenderer(text, renderers), renderer);
    else if (name === 'manual') manual = true;
    else if (Object.hasOwn(settings, name)) {
      values[name] = attempt(() => parseValue(name, settings[name], text), values[name] as never);
    } else {
      const known = [...Object.keys(settings), 'seed', 'renderer', 'manual'].join(', ');
      problems.push(`The address names “${name}”, which this game does not have. It has ${known}.`);
    }
  }
  return { values: values as ValuesOf<S>, seed, renderer, manual, problems };
}

function checkRenderer(name: string, renderers: readonly string[]): string {
  const choices = Object.fromEntries(renderers.map((renderer) => [renderer, renderer]));
  return checkValue('renderer', { kind: 'choice', label: 'renderer', initial: '', choices }, name) as string;
}
