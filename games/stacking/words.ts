/** All words of the game, in every language. The type of the English ones makes a missing translation an error. */
import { chooseWords, hasCoarsePointer, type Language } from '@principia/shell';

const isTouch = hasCoarsePointer();

const en = {
  title: 'Stack and smash',
  settings: {
    build: 'Build',
    count: ['Bodies', 'How many bodies the build has, roughly'],
    gravity: 'Gravity',
    friction: 'Friction',
    restitution: 'Restitution',
    layer: ['Show', 'What the engine knows, drawn over the bodies'],
  },
  builds: {
    tower: 'Tower',
    pyramid: 'Pyramid',
    dominoes: 'Dominoes',
    bridge: 'Bridge',
    cradles: 'Newton’s cradles',
    mixed: 'Mixed',
  },
  layers: {
    none: 'Bodies only',
    contacts: 'Contacts',
    colors: 'Contacts by colour',
    boxes: 'Boxes and sleep',
    islands: 'Islands',
  },
  help: {
    ball: ['C, ●', 'throw a heavy ball', '●'],
    block: ['N, ■', 'drop a block', '■'],
    blast: ['T, ✶', 'blow up the middle', '✶'],
    drag: ['Drag a body', 'move it, stack it, release to throw it'],
    joints: [
      'Hinge, Motor, Weld',
      'tap where two bodies touch, or a body that is to be joined to the background',
      '○ Hinge, ↻ Motor, ✚ Weld',
    ],
    cut: ['Cut', 'swipe through bodies', '✂ Cut'],
    link: ['Link', 'saves the scene to a link, with its joints', '⇗ Share'],
  },
  hint: isTouch
    ? 'Drag bodies, or take a tool. ●\u00a0throws a ball, ■\u00a0drops a block, ✶\u00a0blows up the middle.'
    : 'Drag bodies, or take a tool. C throws a ball, N drops a block, T blows up the middle.',
  tools: 'Tools',
  tool: {
    drag: ['Drag', 'Drag bodies to stack or throw them'],
    hinge: ['Hinge', 'Tap where two bodies touch to hinge them together, or a body to hang it up'],
    motor: ['Motor', 'Tap a body to make it turn, about another body or in its place'],
    weld: ['Weld', 'Tap where two bodies touch to fix them together'],
    cut: ['Cut', 'Swipe through bodies to cut them'],
  },
  link: isTouch ? 'Share' : 'Link',
  linkHint: 'Save the scene to a link',
  yourScene: 'your scene',
  nothingToJoin: 'There is no body to join. Tap on one, or where two touch.',
  tooMany: (most: number, count: number) =>
    `A link holds ${most} bodies at most, and there are ${count}. Choose fewer in the panel.`,
  /** What may be wrong with the text of a scene. */
  broken: {
    sentence: (why: string) => `The scene in the address cannot be read because ${why}. A tower stands instead.`,
    version: 'its version is unknown',
    incomplete: 'it is incomplete',
    impossible: 'it has a shape, a body or a joint that cannot be',
  },
};

export type Words = typeof en;

const de: Words = {
  title: 'Stapeln und umwerfen',
  settings: {
    build: 'Bauwerk',
    count: ['Körper', 'Wie viele Körper das Bauwerk ungefähr hat'],
    gravity: 'Schwerkraft',
    friction: 'Reibung',
    restitution: 'Stoßzahl',
    layer: ['Zeigen', 'Was die Physik weiß, über die Körper gezeichnet'],
  },
  builds: {
    tower: 'Turm',
    pyramid: 'Pyramide',
    dominoes: 'Dominosteine',
    bridge: 'Brücke',
    cradles: 'Kugelstoßpendel',
    mixed: 'Gemischt',
  },
  layers: {
    none: 'Nur Körper',
    contacts: 'Kontakte',
    colors: 'Kontakte nach Farbe',
    boxes: 'Hüllen und Schlaf',
    islands: 'Inseln',
  },
  help: {
    ball: ['C, ●', 'wirft eine schwere Kugel', '●'],
    block: ['N, ■', 'lässt einen Klotz fallen', '■'],
    blast: ['T, ✶', 'sprengt die Mitte', '✶'],
    drag: ['Einen Körper ziehen', 'bewegt und stapelt ihn, loslassen wirft ihn'],
    joints: [
      'Gelenk, Motor, Kleben',
      'tippe, wo zwei Körper sich berühren, oder auf einen Körper, der am Hintergrund hängen soll',
      '○ Gelenk, ↻ Motor, ✚ Kleben',
    ],
    cut: ['Schneiden', 'wische durch Körper', '✂ Schneiden'],
    link: ['Link', 'speichert die Szene mit ihren Gelenken in einen Link', '⇗ Teilen'],
  },
  hint: isTouch
    ? 'Zieh Körper oder nimm ein Werkzeug. ●\u00a0wirft eine Kugel, ■\u00a0lässt einen Klotz fallen, ✶\u00a0sprengt die Mitte.'
    : 'Zieh Körper oder nimm ein Werkzeug. C wirft eine Kugel, N lässt einen Klotz fallen, T sprengt die Mitte.',
  tools: 'Werkzeuge',
  tool: {
    drag: ['Ziehen', 'Zieh Körper, um sie zu stapeln oder zu werfen'],
    hinge: [
      'Gelenk',
      'Tippe, wo zwei Körper sich berühren, um sie gelenkig zu verbinden, oder auf einen, um ihn aufzuhängen',
    ],
    motor: ['Motor', 'Tippe auf einen Körper, damit er sich dreht, um einen anderen oder an seinem Platz'],
    weld: ['Kleben', 'Tippe, wo zwei Körper sich berühren, um sie fest zu verbinden'],
    cut: ['Schneiden', 'Wische durch Körper, um sie zu zerschneiden'],
  },
  link: isTouch ? 'Teilen' : 'Link',
  linkHint: 'Die Szene in einem Link speichern',
  yourScene: 'deiner Szene',
  nothingToJoin: 'Da ist kein Körper. Tippe auf einen oder dorthin, wo zwei sich berühren.',
  tooMany: (most, count) =>
    `In einen Link passen höchstens ${most} Körper, es sind aber ${count}. Wähle im Feld weniger.`,
  broken: {
    sentence: (why) => `Die Szene in der Adresse ist nicht lesbar: ${why}. Stattdessen steht hier ein Turm.`,
    version: 'Ihre Version ist unbekannt',
    incomplete: 'Sie ist unvollständig',
    impossible: 'Sie enthält eine Form, einen Körper oder ein Gelenk, die es nicht geben kann',
  },
};

export const WORDS_BY_LANGUAGE: Readonly<Record<Language, Words>> = { en, de };

export const WORDS = chooseWords(WORDS_BY_LANGUAGE);
