import type { Settings, Value } from '@principia/shell';

/** Writes example, settings and seed into the address, so that a copied address opens the same run. */
export function writeAddress(
  id: string,
  settings: Settings,
  values: Readonly<Record<string, Value>>,
  seed: number,
): void {
  const query = new URLSearchParams(location.search);
  for (const name of ['example', 'seed', 'step', 'camera', ...Object.keys(settings)]) query.delete(name);
  const changed = Object.entries(values).filter(([name, value]) => settings[name]?.initial !== value);
  const own = new URLSearchParams({
    example: id,
    ...Object.fromEntries(
      changed.map(([name, value]) => [name, value === true ? 'on' : value === false ? 'off' : String(value)]),
    ),
    ...(seed === 1 ? {} : { seed: String(seed) }),
  });
  for (const [name, value] of query) own.set(name, value);
  // What follows the # is code that a link brings, which a reload shall find.
  history.replaceState(null, '', `?${own}`.replaceAll('%2C', ',') + location.hash);
}
