import type { HelpLine } from './game.ts';

/**
 * The lines of a game's help from its words, by name: keys or gestures, what they do, and the same two for a touch screen, where
 * they differ.
 * @param keyboardOnly names of lines that a touch screen does not need
 */
export function helpLines<Name extends string>(
  lines: Readonly<Record<Name, readonly string[]>>,
  keyboardOnly: readonly NoInfer<Name>[] = [],
): HelpLine[] {
  return Object.entries<readonly string[]>(lines).map(([name, [input, description, ...onTouch]]) => {
    const gesture = (keyboardOnly as readonly string[]).includes(name) ? '' : (onTouch[0] ?? input);
    return [input, description, gesture, onTouch[1] ?? description];
  });
}
