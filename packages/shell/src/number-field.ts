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
  if (last < 0) return text;
  return `${text.slice(0, last).replace(/[.,]/g, '')}.${text.slice(last + 1)}`;
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
