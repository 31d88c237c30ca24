import { checkValue, initialValues, type NumberSetting, parseValue, type Settings, type ValuesOf } from './settings.ts';
import { words } from './words.ts';

/** The settings that a game's page reads from its URL. */
export interface Address<S extends Settings> {
  /** The settings: those of the URL, and the defaults of others. */
  readonly values: ValuesOf<S>;
  /** Seed of the first world, 0 to 2³² − 1; default 1. */
  readonly seed: number;
  /** Name of one of the game's renderers. */
  readonly renderer: string;
  /** What the reader's plot shows, if the address says so; read when there is a plot. */
  readonly plot: string | undefined;
  /** Turns the clock off: only `__game.step(n)` advances the world. */
  readonly manual: boolean;
  /** One sentence for each value that was rejected, and one for all unknown names. */
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

/** Parameters that mail programs, search engines and social networks append to links; they mean nothing to a game. */
const TRACKING =
  /^(utm_.*|fbclid|gclid|gbraid|wbraid|dclid|msclkid|mc_[ce]id|igshid?|twclid|ttclid|yclid|si|ref|source)$/i;

/**
 * Reads `?seed=7&count=2000&renderer=three&manual`. A rejected value keeps its default and adds a sentence to
 * `problems`.
 * @param query as in `location.search`
 * @param renderers names of the game's renderers; the first is the default
 */
export function readAddress<S extends Settings>(query: string, settings: S, renderers: readonly string[]): Address<S> {
  const values: Record<string, unknown> = initialValues(settings);
  const problems: string[] = [];
  const unknown = new Set<string>();
  const attempt = <T>(read: () => T, fallback: T): T => {
    try {
      return read();
    } catch (error) {
      problems.push(words().address.instead((error as Error).message, fallbackName(fallback)));
      return fallback;
    }
  };
  let seed = SEED.initial;
  let renderer = renderers[0];
  let plot: string | undefined;
  let manual = false;
  for (const [name, text] of new URLSearchParams(query)) {
    if (name === 'seed') seed = attempt(() => parseValue(name, SEED, text) as number, seed);
    else if (name === 'renderer') renderer = attempt(() => checkRenderer(text, renderers), renderer);
    else if (name === 'manual') manual = true;
    else if (name === 'plot') plot = text;
    else if (name === 'lang' || name === 'preview')
      continue; // of `chooseWords` and `isPreview`
    else if (Object.hasOwn(settings, name)) {
      values[name] = attempt(() => parseValue(name, settings[name], text), values[name] as never);
    } else if (!TRACKING.test(name)) unknown.add(words().address.quoted(name));
  }
  if (unknown.size > 0) {
    const known = [...Object.keys(settings), 'seed', 'renderer', 'plot', 'manual'].join(', ');
    problems.push(words().address.unknown([...unknown].join(', '), known));
  }
  return { values: values as ValuesOf<S>, seed, renderer, plot, manual, problems };
}

/** The plot of a page whose address names none. */
export const FIRST_PLOT = 'Energy';

/** The address that starts this game again: its settings and its plot where they differ from the defaults, renderer and seed. */
export function writeAddress<S extends Settings>(
  page: string,
  settings: S,
  { values, seed, renderer, plot = FIRST_PLOT }: Pick<Address<S>, 'values' | 'seed' | 'renderer' | 'plot'>,
): string {
  const url = new URL(page);
  const query = new URLSearchParams({ seed: String(seed), renderer });
  for (const [name, { initial }] of Object.entries(settings)) {
    if (values[name] !== initial) query.set(name, String(values[name]));
  }
  if (plot !== FIRST_PLOT) query.set('plot', plot);
  url.search = query.toString();
  return url.href;
}

/** An address with the present settings in place of those that it has; whatever else it says stays. */
export function withSettings<S extends Settings>(page: string, settings: S, values: ValuesOf<S>): string {
  const url = new URL(page);
  for (const [name, { initial }] of Object.entries(settings)) {
    if (values[name] === initial) url.searchParams.delete(name);
    else url.searchParams.set(name, String(values[name]));
  }
  return url.href;
}

function fallbackName(fallback: unknown): string {
  const rendererName = { pixi: '2D', three: '3D' }[String(fallback)];
  const { on, off } = words().address;
  return typeof fallback === 'boolean' ? (fallback ? on : off) : (rendererName ?? String(fallback));
}

function checkRenderer(name: string, renderers: readonly string[]): string {
  const choices = Object.fromEntries(renderers.map((renderer) => [renderer, renderer]));
  return checkValue('renderer', { kind: 'choice', label: 'renderer', initial: '', choices }, name) as string;
}
