/** All words of the game, in every language. The type of the English ones makes a missing translation an error. */
import { chooseWords, decimal, hasCoarsePointer, type Language } from '@principia/shell';

const isTouch = hasCoarsePointer();

const en = {
  title: 'Submarine',
  settings: {
    level: ['Level', 'A deeper sea, stronger currents, and more crates'],
    floodlight: ['Floodlight', 'Shows the bed near the boat'],
    sound: 'Sound',
  },
  help: {
    tank: [
      '↓, ↑',
      'flood the tank, or blow it out with compressed air, which takes more of it the deeper you are',
      '▼, ▲',
    ],
    engine: [
      '←, →',
      'full speed to the left or right; planes then turn the nose with ↓ and ↑, and the propeller pushes where it points',
      '◀, ▶',
      'full speed to the left or right; planes then turn the nose with ▼ and ▲, and the propeller pushes where it points',
    ],
    pointer: ['Hold mouse or finger', 'the boat goes there', 'Hold a finger'],
    sonar: ['X, Enter, ●, click', 'sonar: the echo shows bed and crates for a while', '●, tap'],
    goal: ['Goal', 'touch every crate, and come up beside the ship before the air to breathe is gone'],
    danger: ['Danger', 'the depth crushes the hull, and rocks dent it'],
    depth: ['Depth', 'presses the hull together: it carries less, so that the tank hovers with less water'],
    surface: ['At the surface', 'the compressor fills the bottles, and the air to breathe lasts'],
  },
  start: isTouch
    ? 'Hold ▼ to flood the tank, ▲ to blow it out; ◀ ▶ drive; a tap shows the crates'
    : 'Hold ↓ to flood the tank, ↑ to blow it out; ← → drive; X shows the crates. Or hold the mouse button where the boat should go.',
  goal: (taken: number, count: number) =>
    `Bring ${count} crates up to the ship before your air is gone: ${taken} aboard`,
  allAboard: 'All aboard – come up beside the ship',
  tooDeep: 'Too deep – the hull gives way!',
  lowAir: 'Little compressed air is left: come up for more',
  lowBreath: 'The air to breathe runs out',
  depth: (depth: number, pressure: number) => `${decimal(Math.max(0, depth), 0)} m, ${decimal(pressure, 1)} atm`,
  density: (ratio: number) => `density ${decimal(ratio, 3)} × water’s`,
  speed: (speed: number) => `${decimal(speed, 1)} m/s`,
  gauges: { tank: 'tank', hull: 'hull', air: 'compressed air', breath: 'air to breathe' },
  endings: {
    won: 'All brought up',
    crushed: 'Crushed by the depth',
    wrecked: 'Wrecked on the rocks',
    suffocated: 'No air left to breathe',
  },
  result: (level: number, taken: number, count: number) => `Level ${level}: ${taken} of ${count} crates`,
  points: (score: number) => `${score} points`,
  share: (level: number, score: number) => `Submarine, level ${level}: ${score} points`,
};

export type Words = typeof en;

const de: Words = {
  title: 'U-Boot',
  settings: {
    level: ['Stufe', 'Ein tieferes Meer, stärkere Strömungen und mehr Kisten'],
    floodlight: ['Scheinwerfer', 'Zeigt den Grund in der Nähe des Boots'],
    sound: 'Ton',
  },
  help: {
    tank: ['↓, ↑', 'Tank fluten oder mit Druckluft ausblasen; je tiefer du bist, desto mehr braucht es davon', '▼, ▲'],
    engine: [
      '←, →',
      'volle Fahrt nach links oder rechts; Tiefenruder neigen dann mit ↓ und ↑ den Bug, und der Propeller schiebt, wohin er zeigt',
      '◀, ▶',
      'volle Fahrt nach links oder rechts; Tiefenruder neigen dann mit ▼ und ▲ den Bug, und der Propeller schiebt, wohin er zeigt',
    ],
    pointer: ['Maus oder Finger halten', 'das Boot fährt dorthin', 'Finger halten'],
    sonar: ['X, Enter, ●, Klick', 'Sonar: Das Echo zeigt Grund und Kisten für eine Weile', '●, tippen'],
    goal: ['Ziel', 'berühre jede Kiste und tauche neben dem Schiff auf, bevor die Atemluft zu Ende ist'],
    danger: ['Gefahr', 'die Tiefe zerdrückt den Rumpf, und Felsen beulen ihn ein'],
    depth: ['Tiefe', 'presst den Rumpf zusammen: Er trägt weniger, und der Tank schwebt mit weniger Wasser'],
    surface: ['Aufgetaucht', 'füllt der Kompressor die Flaschen, und die Atemluft hält'],
  },
  start: isTouch
    ? 'Halte ▼, um den Tank zu fluten, ▲, um ihn auszublasen; ◀ ▶ fahren; Tippen zeigt die Kisten'
    : 'Halte ↓, um den Tank zu fluten, ↑, um ihn auszublasen; ← → fahren; X zeigt die Kisten. Oder halte die Maus dorthin, wohin du willst.',
  goal: (taken, count) => `Hol ${count} Kisten herauf zum Schiff, bevor die Luft zu Ende ist: ${taken} an Bord`,
  allAboard: 'Alle an Bord – tauche neben dem Schiff auf',
  tooDeep: 'Zu tief – der Rumpf gibt nach!',
  lowAir: 'Kaum noch Druckluft: Tauche auf und hol neue',
  lowBreath: 'Die Atemluft geht zu Ende',
  depth: (depth, pressure) => `${decimal(Math.max(0, depth), 0)} m, ${decimal(pressure, 1)} atm`,
  density: (ratio) => `Dichte ${decimal(ratio, 3)} × Wasser`,
  speed: (speed) => `${decimal(speed, 1)} m/s`,
  gauges: { tank: 'Wasser', hull: 'Rumpf', air: 'Druckluft', breath: 'Atemluft' },
  endings: {
    won: 'Alles geborgen',
    crushed: 'Von der Tiefe zerdrückt',
    wrecked: 'An den Felsen zerschellt',
    suffocated: 'Keine Luft mehr',
  },
  result: (level, taken, count) => `Stufe ${level}: ${taken} von ${count} Kisten`,
  points: (score) => `${score} Punkte`,
  share: (level, score) => `U-Boot, Stufe ${level}: ${score} Punkte`,
};

export const WORDS_BY_LANGUAGE: Readonly<Record<Language, Words>> = { en, de };

export const WORDS = chooseWords(WORDS_BY_LANGUAGE);
