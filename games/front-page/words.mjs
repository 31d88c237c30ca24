/**
 * All words of the front page, in every language; those of a game stand in its own page. The type of the English ones makes
 * a missing translation an error. Some are HTML.
 */

const en = {
  title: 'Principia games',
  lead: 'Real physics to play with: nearly every world can be stopped, slowed, run backwards and measured.',
  about: 'Principia is a physics framework for games. These are made with it.',
  search: 'Search games',
  surprise: 'Surprise me',
  game: 'Games',
  toy: 'Things to play with',
  lab: 'Experiments',
  none: 'There is no game yet.',
  nothing: 'No game is like that. <a href="./laboratory/index.html">Search the laboratory</a>',
  keys: 'Most games list their keys when you press <kbd>H</kbd>: <kbd>Space</kbd> pauses, <kbd>B</kbd> runs time backwards, <kbd>S</kbd> slows it down.',
  touch: 'Most games explain themselves behind the button <kbd>?</kbd>.',
  privacy:
    'Everything happens in your browser, and nothing is sent anywhere. After the first visit the site works without the internet.',
  /** Shown on every page that is opened from a folder. */
  fromDisk:
    'Browsers do not run games straight from a folder. Serve the folder of this site, as with “npx serve” or “python3 -m http.server”, and open the address it prints.',
};

/** @type {typeof en} */
const de = {
  title: 'Principia-Spiele',
  lead: 'Echte Physik zum Spielen: Fast jede Welt lässt sich anhalten, verlangsamen, zurückspulen und vermessen.',
  about: 'Principia ist ein Physik-Framework für Spiele. Diese sind damit gebaut.',
  search: 'Spiele suchen',
  surprise: 'Überrasch mich',
  game: 'Spiele',
  toy: 'Zum Herumspielen',
  lab: 'Experimente',
  none: 'Es gibt noch kein Spiel.',
  nothing: 'So ein Spiel gibt es nicht. <a href="./laboratory/index.html">Im Labor suchen</a>',
  keys: 'Die meisten Spiele zeigen mit <kbd>H</kbd> ihre Tasten: Die <kbd>Leertaste</kbd> hält an, <kbd>B</kbd> spult zurück, <kbd>S</kbd> verlangsamt.',
  touch: 'Die meisten Spiele erklären sich hinter dem Knopf <kbd>?</kbd>.',
  privacy:
    'Alles geschieht in deinem Browser, und nichts wird irgendwohin geschickt. Nach dem ersten Besuch geht es auch ohne Internet.',
  fromDisk:
    'Browser führen Spiele nicht direkt aus einem Ordner aus. Stelle den Ordner dieser Seiten bereit, etwa mit „npx serve“ oder „python3 -m http.server“, und öffne die Adresse, die dort erscheint.',
};

export const WORDS_BY_LANGUAGE = { en, de };
