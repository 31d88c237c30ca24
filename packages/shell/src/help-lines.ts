import type { HelpLine } from './game.ts';

/**
 * The lines of a game's help from its words, by name: keys or gestures, what they do, and how a touch screen names them, where
 * that differs.
 * @param keyboardOnly names of lines that a touch screen does not need
 */
export function helpLines<Name extends string>(
  lines: Readonly<Record<Name, readonly string[]>>,
  keyboardOnly: readonly NoInfer<Name>[] = [],
): HelpLine[] {
  return Object.entries<readonly string[]>(lines).map(([name, [input, description, onTouch = input]]) => [
    input,
    description,
    (keyboardOnly as readonly string[]).includes(name) ? '' : onTouch,
  ]);
}
