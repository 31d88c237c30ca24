/** Buttons to choose the picture on the cloth and to take it off; a file may also be dropped on the page. */
import { element } from '@principia/shell';
import type { ClothPrint } from './cloth-print.ts';
import { WORDS } from './words.ts';

/**
 * @param row of buttons that gets these
 * @returns a function that takes the buttons away
 */
export function createPrintButtons(
  row: HTMLElement,
  print: ClothPrint,
  showMessage: (sentence: string) => void,
): () => void {
  const input = element('input', '', { type: 'file', accept: 'image/*', hidden: '', 'aria-label': WORDS.pictureFile });
  const choose = element('button', 'cloth-button', { type: 'button' }, WORDS.print);
  choose.title = WORDS.printHint;
  const remove = element('button', 'cloth-button', { type: 'button' }, WORDS.takeOff);
  row.append(choose, remove, input);
  const show = () => {
    remove.hidden = print.canvas === undefined;
  };
  const load = async (file: File | undefined) => {
    if (file === undefined) return;
    try {
      await print.load(file);
    } catch (error) {
      showMessage((error as Error).message);
    }
    show();
  };
  choose.addEventListener('click', () => input.click());
  input.addEventListener('change', () => {
    void load(input.files?.[0]);
    // The same file may be chosen again.
    input.value = '';
  });
  remove.addEventListener('click', () => {
    print.clear();
    show();
    choose.focus();
  });
  const stop = new AbortController();
  const { signal } = stop;
  document.addEventListener('dragover', (event) => event.preventDefault(), { signal });
  document.addEventListener(
    'drop',
    (event) => {
      event.preventDefault();
      void load(event.dataTransfer?.files[0]);
    },
    { signal },
  );
  show();
  return () => {
    stop.abort();
    for (const each of [choose, remove, input]) each.remove();
  };
}
