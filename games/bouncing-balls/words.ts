/** All words of the game, in every language. The type of the English ones makes a missing translation an error. */
import { chooseWords, hasCoarsePointer, type Language } from '@principia/shell';

const isTouch = hasCoarsePointer();

const en = {
  title: 'Bouncing balls',
  settings: {
    count: 'Balls',
    gravity: 'Gravity',
    restitution: 'Restitution',
    friction: 'Friction',
    drag: 'Air density',
    collisions: ['Collisions', 'Whether balls collide or pass through each other'],
    wrap: ['Wrap around', 'Balls that leave at one side come back at the other'],
    magnet: ['Magnet', 'Press and hold attracts balls; otherwise it stops time'],
    sound: ['Sound', 'Impacts sound, the louder the faster'],
    trails: ['Trails', 'Shows the recent path of each ball'],
  },
  planets: { space: 'Space', moon: 'Moon', mars: 'Mars', earth: 'Earth', saturn: 'Saturn', jupiter: 'Jupiter' },
  help: {
    tap: ['Tap, click', 'blow up what is there', 'Tap'],
    hold: ['Press and hold', 'time stands still; in 3D, drag on to look around'],
    magnet: [
      'G, Magnet',
      'press and hold is a magnet: balls fly there, and follow the pointer',
      'Magnet',
      'press and hold is a magnet: balls fly there, and follow the finger',
    ],
    pour: ['Hold V, Pour', 'pour balls from the ceiling', 'Pour'],
    drag: ['Drag a ball', 'grab it, release to throw it; every finger can grab one'],
    tilt: [
      'Tilt',
      'on phones and tablets: gravity follows the way the device is held',
      'Tilt',
      'gravity follows the way the device is held',
    ],
    rotate: ['Drag elsewhere', 'in 3D: rotate the view'],
    zoom: [
      'Wheel, two fingers',
      'zoom and move the view; so does a drag with the right button',
      'Two fingers',
      'zoom and move the view',
    ],
  },
  hint: isTouch
    ? 'Tap to blow balls up, hold to stop time, drag to throw them'
    : 'Click to blow balls up, hold to stop time, drag to throw them, V to pour',
  pour: 'Pour',
  tilt: 'Tilt',
  tiltHint: 'Gravity follows the way the device is held',
  noTilt: 'The device does not let this page read how it is held. Allow motion and orientation in its settings.',
};

export type Words = typeof en;

const de: Words = {
  title: 'Hüpfende Bälle',
  settings: {
    count: 'Bälle',
    gravity: 'Schwerkraft',
    restitution: 'Stoßzahl',
    friction: 'Reibung',
    drag: 'Luftdichte',
    collisions: ['Stöße', 'Ob Bälle zusammenstoßen oder einander durchdringen'],
    wrap: ['Ohne Wände', 'Bälle, die auf einer Seite hinausfliegen, kommen auf der anderen wieder herein'],
    magnet: ['Magnet', 'Gedrückt halten zieht Bälle an; sonst hält es die Zeit an'],
    sound: ['Ton', 'Aufpralle sind zu hören, je schneller, desto lauter'],
    trails: ['Spuren', 'Zeigt die letzte Bahn jedes Balls'],
  },
  planets: { space: 'Weltraum', moon: 'Mond', mars: 'Mars', earth: 'Erde', saturn: 'Saturn', jupiter: 'Jupiter' },
  help: {
    tap: ['Tippen, klicken', 'sprengt auseinander, was dort ist', 'Tippen'],
    hold: ['Gedrückt halten', 'die Zeit steht still; in 3D siehst du dich um, wenn du weiterziehst'],
    magnet: [
      'G, Magnet',
      'gedrückt halten ist ein Magnet: Bälle fliegen dorthin und folgen dem Zeiger',
      'Magnet',
      'gedrückt halten ist ein Magnet: Bälle fliegen dorthin und folgen dem Finger',
    ],
    pour: ['V halten, Gießen', 'gießt Bälle von der Decke', 'Gießen'],
    drag: ['Einen Ball ziehen', 'fasst ihn, und loslassen wirft ihn; jeder Finger kann einen fassen'],
    tilt: [
      'Neigen',
      'auf Telefonen und Tablets: Die Schwerkraft folgt der Haltung des Geräts',
      'Neigen',
      'die Schwerkraft folgt der Haltung des Geräts',
    ],
    rotate: ['Daneben ziehen', 'dreht in 3D die Ansicht'],
    zoom: [
      'Mausrad, zwei Finger',
      'zoomt und verschiebt die Ansicht; ebenso Ziehen mit der rechten Maustaste',
      'Zwei Finger',
      'zoomen und verschieben die Ansicht',
    ],
  },
  hint: isTouch
    ? 'Tippen sprengt Bälle, Halten stoppt die Zeit, Ziehen wirft sie'
    : 'Ein Klick sprengt die Bälle auseinander, Halten stoppt die Zeit, Ziehen wirft sie, V gießt neue',
  pour: 'Gießen',
  tilt: 'Neigen',
  tiltHint: 'Die Schwerkraft folgt der Haltung des Geräts',
  noTilt:
    'Das Gerät verrät dieser Seite nicht, wie es gehalten wird. Erlaube Bewegung und Ausrichtung in seinen Einstellungen.',
};

export const WORDS_BY_LANGUAGE: Readonly<Record<Language, Words>> = { en, de };

export const WORDS = chooseWords(WORDS_BY_LANGUAGE);
