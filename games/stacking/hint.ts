/** One sentence at the foot of the stage that says what to do, until the player does something. */
const TEXT = 'Drag bodies to stack or throw them. C throws a ball, N drops a block, T blows up the middle.';
const TOUCH_TEXT = 'Drag bodies to stack or throw them. The buttons throw a ball, drop a block and blow up the middle.';
const STYLE = `position: absolute; left: 16px; right: 16px; bottom: 14px; margin: 0; pointer-events: none; text-align: center;
  font: 500 15px/1.4 system-ui, sans-serif; color: #eef1fb; text-shadow: 0 1px 3px #0d1226`;

/** @returns a function that removes the hint */
export function showHint(parent: HTMLElement): () => void {
  const hint = document.createElement('p');
  hint.textContent = globalThis.matchMedia('(pointer: coarse)').matches ? TOUCH_TEXT : TEXT;
  hint.style.cssText = STYLE;
  parent.append(hint);
  const stop = new AbortController();
  const remove = () => {
    hint.remove();
    stop.abort();
  };
  for (const type of ['keydown', 'pointerdown']) document.addEventListener(type, remove, { signal: stop.signal });
  return remove;
}
