/** The page, or an element of it. */
export type KeyTarget = Pick<HTMLElement, 'addEventListener' | 'removeEventListener'>;

/** Actions by key: the value of `KeyboardEvent.key` in lower case. */
export type Keys = Readonly<Record<string, () => void>>;

/** What follows when a key is let go; `isLost` where the page lost the focus and will not hear of it. */
export type ReleasedKeys = Readonly<Record<string, (isLost: boolean) => void>>;

/**
 * Listens to keys on the whole page, except in input fields and on focused buttons that use the same key. A held key
 * acts once if its release has an action too. Returns a function that stops listening.
 *
 * @param within hears the keys, while it or an element in it has the focus; default the whole page
 */
export function listenToKeys(pressed: Keys, released: ReleasedKeys = {}, within: KeyTarget = document): () => void {
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
  const releaseKey = (key: string, isLost: boolean) => {
    if (held.delete(key)) released[key](isLost);
  };
  const release = (event: KeyboardEvent) => releaseKey(event.key.toLowerCase(), false);
  const releaseAll = () => {
    for (const key of [...held]) releaseKey(key, true);
  };
  within.addEventListener('keydown', press);
  document.addEventListener('keyup', release);
  globalThis.addEventListener('blur', releaseAll);
  return () => {
    within.removeEventListener('keydown', press);
    document.removeEventListener('keyup', release);
    globalThis.removeEventListener('blur', releaseAll);
    releaseAll();
  };
}
