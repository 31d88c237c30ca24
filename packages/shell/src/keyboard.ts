/** What keys do: a name as in `KeyboardEvent.key`, in lower case, and its action. */
export type Keys = Readonly<Record<string, () => void>>;

/**
 * Listens to the whole page, except where somebody types or works a button with the same key. A key held down acts once
 * where letting go of it acts too. Returns how to stop.
 */
export function listenToKeys(pressed: Keys, released: Keys = {}): () => void {
  const held = new Set<string>();
  const press = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    const target = event.target as Element | null;
    if (target?.closest?.('input, select, textarea, [contenteditable], dialog')) return;
    const key = event.key.toLowerCase();
    if (key === ' ' && target?.closest?.('button')) return;
    const action = Object.hasOwn(pressed, key) ? pressed[key] : undefined;
    if (action === undefined) return;
    event.preventDefault();
    if (Object.hasOwn(released, key)) {
      if (held.has(key)) return;
      held.add(key);
    }
    action();
  };
  const letGo = (key: string) => {
    if (held.delete(key)) released[key]();
  };
  const release = (event: KeyboardEvent) => letGo(event.key.toLowerCase());
  const releaseAll = () => {
    for (const key of [...held]) letGo(key);
  };
  document.addEventListener('keydown', press);
  document.addEventListener('keyup', release);
  globalThis.addEventListener('blur', releaseAll);
  return () => {
    document.removeEventListener('keydown', press);
    document.removeEventListener('keyup', release);
    globalThis.removeEventListener('blur', releaseAll);
    releaseAll();
  };
}
