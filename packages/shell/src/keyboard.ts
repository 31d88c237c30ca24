/** What keys do: a name as in `KeyboardEvent.key`, in lower case, and its action. */
export type Keys = Readonly<Record<string, () => void>>;

/** Listens to the whole page, except where somebody types or works a button with the same key. Returns how to stop. */
export function listenToKeys(keys: Keys): () => void {
  const press = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    const target = event.target as Element | null;
    if (target?.closest?.('input, select, textarea, [contenteditable], dialog')) return;
    const key = event.key.toLowerCase();
    if (key === ' ' && target?.closest?.('button')) return;
    const action = keys[key];
    if (action === undefined) return;
    event.preventDefault();
    action();
  };
  document.addEventListener('keydown', press);
  return () => document.removeEventListener('keydown', press);
}
