import { element } from './element.ts';

/** Controls around the game: a press on one of them is not yet play, so that the hint stays. */
const NO_PLAY = '.game-bar, .game-banner, .game-help';

/**
 * A sentence at the foot of the stage that says what to do; it leaves when the player has pressed a key or let go of a pointer.
 * @returns a function that removes it; a view calls it in its `destroy`
 */
export function showHint(parent: HTMLElement, text: string): () => void {
  const hint = element('p', 'game-hint', { role: 'status' }, text);
  parent.append(hint);
  const stop = new AbortController();
  const remove = () => {
    hint.remove();
    stop.abort();
  };
  const isPlay = ({ target }: Event) => !(target instanceof Element && target.closest(NO_PLAY));
  for (const type of ['keydown', 'pointerup'])
    document.addEventListener(type, (event) => isPlay(event) && remove(), { signal: stop.signal });
  return remove;
}
