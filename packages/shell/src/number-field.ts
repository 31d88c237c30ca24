import { inLanguage } from './language.ts';

/**
 * The text of a number with a decimal point, from one that people typed: with comma or point, in whichever language.
 * @param isWhole whether commas and points can only separate thousands
 */
export function plainNumber(typed: string, isWhole = false): string {
  const text = typed.trim().replace('−', '-');
  if (isWhole) return text.replace(/[.,\s](?=\d{3}(\D|$))/g, '').replace(',', '.');
  // Of two signs the last is the decimal one, and the others separate thousands.
  const last = Math.max(text.lastIndexOf(','), text.lastIndexOf('.'));
  if (last < 0) return withoutSpaces(text);
  return `${withoutSpaces(text.slice(0, last)).replace(/[.,]/g, '')}.${text.slice(last + 1)}`;
}

/** Without the spaces between groups of three digits. */
function withoutSpaces(text: string): string {
  return text.replace(/\s(?=\d{3}(\D|$))/g, '');
}

const { get, set } = (typeof HTMLInputElement === 'undefined'
  ? undefined
  : Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, 'value')) ?? { get: undefined, set: undefined };

/**
 * Makes a field show numbers in the language of the page, and take them with comma or point. Scripts go on reading and
 * writing `value` with a point. Fields of type `number` would follow the language of the browser, in some browsers that
 * of the page, and refuse the other sign.
 */
export function speakNumbers(input: HTMLInputElement, { isWhole = false, min = 0 } = {}): void {
  input.type = 'text';
  // The keyboards for decimals of some phones have no minus sign.
  input.inputMode = min < 0 ? 'text' : isWhole ? 'numeric' : 'decimal';
  Object.defineProperty(input, 'value', {
    get: () => plainNumber(get?.call(input) ?? '', isWhole),
    set: (value: unknown) => set?.call(input, inLanguage(String(value))),
  });
}

/** What a field of a slider reads and writes. */
export interface FieldTarget {
  read(): number;
  /** Takes what somebody typed. */
  write(value: number): void;
  /** The value some steps further: one for an arrow key or a notch of the wheel, ten with Shift, negative downwards. */
  moved(value: number, steps: number): number;
}

/**
 * Reads the field of a slider of lil-gui: in the capture phase, before lil-gui's listeners, which would round what is typed to
 * the steps of the slider.
 */
export function readField(controller: HTMLElement, { read, write, moved }: FieldTarget): void {
  const input = controller.querySelector('input') as HTMLInputElement;
  const move = (event: Event, steps: number) => {
    event.stopPropagation();
    event.preventDefault();
    write(moved(read(), steps));
    input.value = String(read());
  };
  const type = (event: Event) => {
    event.stopPropagation();
    const typed = Number.parseFloat(input.value);
    if (Number.isFinite(typed)) write(typed);
  };
  const press = (event: KeyboardEvent) => {
    const size = event.shiftKey ? 10 : 1;
    if (event.code === 'ArrowUp') move(event, size);
    else if (event.code === 'ArrowDown') move(event, -size);
  };
  const turn = (event: WheelEvent) => {
    if (document.activeElement === input) move(event, event.deltaY < 0 ? 1 : -1);
  };
  controller.addEventListener('input', type, true);
  controller.addEventListener('keydown', press, true);
  controller.addEventListener('wheel', turn, { capture: true, passive: false });
}

/** Significant digits that a field shows at most. */
const DIGITS = 7;

/** Decimals that show a number in full, up to seven digits. @param least shown even where they are zero */
export function decimalsOf(value: number, least: number): number {
  const wanted = Number(value.toPrecision(DIGITS));
  let decimals = least;
  while (decimals < 12 && Number(value.toFixed(decimals)) !== wanted) decimals++;
  return decimals;
}
