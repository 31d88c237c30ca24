import { element } from './element.ts';

/** A sentence at the foot of the stage that says what to do; it leaves when the player has done something. */
export function showHint(parent: HTMLElement, text: string): () => void {
  const hint = element('p', 'game-hint', { role: 'status' }, text);
  parent.append(hint);
  const stop = new AbortController();
  const remove = () => {
    hint.remove();
    stop.abort();
  };
  for (const type of ['keydown', 'pointerup']) document.addEventListener(type, remove, { signal: stop.signal });
  return remove;
}
