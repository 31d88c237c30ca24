/** All words of the game, in every language. The type of the English ones makes a missing translation an error. */
import { chooseWords, type Language } from '@principia/shell';

const en = {
  title: 'A cloth to tear',
  settings: {
    gravity: 'Gravity',
    wind: 'Wind',
    strength: ['Strength', 'Tension at which a thread breaks'],
    sound: ['Sound', 'Threads are heard as they tear'],
  },
  help: {
    drag: ['Drag the cloth', 'pull and tear it; every finger can grab it'],
    swipe: ['Swipe from beside it', 'cut it'],
    blow: [
      'Hold A, Blow',
      'A blows air at the cloth where the mouse is; while the button is on, a press does',
      'Blow',
      'while this button is on, one or two fingers blow air at the cloth',
    ],
    print: [
      'Print your picture',
      'choose a file or drop one on the page; it stays on your device',
      'Print your picture',
      'choose a file; it stays on your device',
    ],
    film: ['Watch the tear slowly', 'the button appears after a tear'],
    view: ['Right button, two fingers', 'turn the view in 3D, move it in 2D', 'Two fingers'],
  },
  hint: 'Drag the cloth to tear it. Swipe from beside it to cut it.',
  blow: 'Blow',
  blowHint: 'Press the cloth to blow air at it, instead of pulling or cutting; or hold A',
  print: 'Print your picture',
  printHint: 'Choose a picture, or drop one here. It stays on this device.',
  pictureFile: 'Picture file',
  takeOff: 'Take it off',
  film: '↺ Watch the tear slowly',
  filmRuns: 'Slow motion – press anywhere to return',
  noPicture: (name: string) =>
    `“${name}” is not a picture that this browser can show. Choose a PNG, JPEG or WebP file.`,
  noMemory: 'The browser has no memory left for the picture. Close other pages.',
};

export type Words = typeof en;

const de: Words = {
  title: 'Ein Tuch zum Zerreißen',
  settings: {
    gravity: 'Schwerkraft',
    wind: 'Wind',
    strength: ['Reißkraft', 'Spannung, bei der ein Faden reißt'],
    sound: ['Ton', 'Man hört die Fäden reißen'],
  },
  help: {
    drag: ['Am Tuch ziehen', 'spannt und zerreißt es; jeder Finger kann es fassen'],
    swipe: ['Von außen wischen', 'schneidet es durch'],
    blow: [
      'A halten, Pusten',
      'A bläst Luft gegen das Tuch, wo die Maus ist; solange der Knopf an ist, tut es ein Druck',
      'Pusten',
      'solange der Knopf an ist, blasen ein oder zwei Finger Luft gegen das Tuch',
    ],
    print: [
      'Bild aufdrucken',
      'wähle eine Datei oder zieh sie auf die Seite; sie bleibt auf deinem Gerät',
      'Bild aufdrucken',
      'wähle eine Datei; sie bleibt auf deinem Gerät',
    ],
    film: ['Riss langsam ansehen', 'der Knopf erscheint nach einem Riss'],
    view: ['Rechte Taste, zwei Finger', 'dreht die Ansicht in 3D, verschiebt sie in 2D', 'Zwei Finger'],
  },
  hint: 'Zieh am Tuch, bis es reißt. Wisch von außen hindurch, um es zu schneiden.',
  blow: 'Pusten',
  blowHint: 'Ein Druck auf das Tuch bläst Luft dagegen, statt zu ziehen oder zu schneiden; oder halte A',
  print: 'Bild aufdrucken',
  printHint: 'Wähle ein Bild oder zieh eines hierher. Es bleibt auf diesem Gerät.',
  pictureFile: 'Bilddatei',
  takeOff: 'Abnehmen',
  film: '↺ Riss langsam ansehen',
  filmRuns: 'Zeitlupe – drücke irgendwo, um zurückzukehren',
  noPicture: (name) =>
    `„${name}“ ist kein Bild, das dieser Browser zeigen kann. Wähle eine Datei in PNG, JPEG oder WebP.`,
  noMemory: 'Dem Browser fehlt der Speicher für das Bild. Schließe andere Seiten.',
};

export const WORDS_BY_LANGUAGE: Readonly<Record<Language, Words>> = { en, de };

export const WORDS = chooseWords(WORDS_BY_LANGUAGE);
