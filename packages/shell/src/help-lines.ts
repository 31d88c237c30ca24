import type { HelpLine } from './game.ts';

/**
 * The lines of a game's help from its words: pairs of keys or gestures and what they do, by name.
 * @param keyboardOnly names of lines that a touch screen does not need
 */
export function helpLines<Name extends string>(
  lines: Readonly<Record<Name, readonly string[]>>,
  keyboardOnly: readonly NoInfer<Name>[] = [],
): HelpLine[] {
  return Object.entries<readonly string[]>(lines).map(([name, [input, description]]) =>
    (keyboardOnly as readonly string[]).includes(name) ? [input, description, 'keyboard'] : [input, description],
  );
}
