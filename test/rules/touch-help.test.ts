/** The help of touch screens: it names gestures and buttons on the screen, neither keys nor a mouse. */
import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { WORDS_BY_LANGUAGE as BLACK_HOLE } from '../../games/black-hole/words.ts';
import { WORDS_BY_LANGUAGE as BOUNCING_BALLS } from '../../games/bouncing-balls/words.ts';
import { WORDS_BY_LANGUAGE as CLOTH } from '../../games/cloth/words.ts';
import { WORDS_BY_LANGUAGE as FIREWORKS } from '../../games/fireworks/words.ts';
import { WORDS_BY_LANGUAGE as FLIGHT_SIMULATOR } from '../../games/flight-simulator/words.ts';
import { WORDS_BY_LANGUAGE as SOLAR_SYSTEM } from '../../games/solar-system/words.ts';
import { WORDS_BY_LANGUAGE as STACKING } from '../../games/stacking/words.ts';
import { WORDS_BY_LANGUAGE as SUBMARINE } from '../../games/submarine/words.ts';

const GAMES = {
  'black-hole': BLACK_HOLE,
  'bouncing-balls': BOUNCING_BALLS,
  cloth: CLOTH,
  fireworks: FIREWORKS,
  'flight-simulator': FLIGHT_SIMULATOR,
  'solar-system': SOLAR_SYSTEM,
  stacking: STACKING,
  submarine: SUBMARINE,
};

/** Words of other inputs, arrows of a keyboard, and single capitals (but for the article) and digits, which are keys. */
const FOREIGN = [
  /mouse|wheel|right button|\bkeys?\b|\bclick|backspace|delete|gamepad|pointer/i,
  /maus|rechte|tasten?\b|zeiger|klick|entf\b/i,
  /[←↑→↓]|(?<![\p{L}\d])(?!A \p{Ll})[A-Z](?!\p{L})|\b\d(?!D)/u,
];

/** Names of the lines that `main.ts` keeps from touch screens. */
function keyboardOnly(game: string): readonly string[] {
  const [, names = ''] =
    /helpLines\(WORDS\.help, \[([^\]]*)\]/.exec(readFileSync(`games/${game}/main.ts`, 'utf8')) ?? [];
  return [...names.matchAll(/'(\w+)'/g)].map(([, name]) => name);
}

it.each(Object.entries(GAMES))('%s names no key and no mouse in its help for touch', (game, words) => {
  const hidden = keyboardOnly(game);
  const lines = Object.values(words).flatMap(({ help }) => Object.entries<readonly string[]>(help));
  const wrong = lines.flatMap(([name, [input, text, gesture = input, onTouch = text]]) => {
    const said = `${gesture}: ${onTouch}`;
    return !hidden.includes(name) && FOREIGN.some((foreign) => foreign.test(said)) ? [said] : [];
  });
  expect(wrong).toEqual([]);
});
