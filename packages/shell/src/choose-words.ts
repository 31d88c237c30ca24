import { preferredLanguage, speak } from './language.ts';
import { type ShellWords, supplyWords } from './words.ts';

/**
 * Chooses the words of a game, and with them the language of its page: of the buttons around it, of `<html lang>` and of
 * numbers. Call it once, where the words stand.
 * @param texts the game's words by language, such as `{ en, de, fr }`
 * @param shell the shell's own words in languages other than English and German: `{ fr: { settings: 'Réglages', … } }`
 */
export function chooseWords<Words>(
  texts: Readonly<Record<string, Words>> & { readonly en: Words },
  shell: Readonly<Record<string, ShellWords>> = {},
): Words {
  for (const [name, supplied] of Object.entries(shell)) supplyWords(name, supplied);
  const wishes = globalThis.navigator?.languages ?? [];
  // Outside a page and a worker there is no address, and no reader.
  const wanted =
    typeof location === 'undefined' ? 'en' : preferredLanguage(location.search, wishes, Object.keys(texts));
  speak(wanted);
  return texts[wanted];
}
