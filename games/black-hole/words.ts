/** All words of the game, in every language. The type of the English ones makes a missing translation an error. */
import { chooseWords, decimal, hasCoarsePointer, type Language } from '@principia/shell';

const isTouch = hasCoarsePointer();

/** A date that stays on one line. */
const unbroken = (day: string) => `${day}`.replaceAll('-', '\u2011');

const en = {
  title: 'Black hole',
  settings: {
    level: ['First level', 'Up to the highest that you have reached; a game that begins higher is not ranked'],
    fuel: ['Fuel', 'A limited tank for every flight; unused fuel gives bonus points'],
    moving: ['Moving holes', 'From level 5 on, some holes move on circles'],
    steep: [
      'Relativistic gravity',
      'Paczyński–Wiita potential: infinite at the horizon, and no stable circular orbit within three radii',
    ],
    path: ['Predicted path', 'The flight of the next two seconds'],
    trail: ['Trail', 'The recent path of the ship'],
    ghost: ['Ghost', 'Your fastest flight past the same holes flies beside you as a pale ship'],
    lens: ['Light bending', 'Holes bend the light of the stars behind them'],
    glow: ['Hawking glow', 'Holes glow: smaller ones are hotter and brighter'],
    sound: 'Sound',
    autopilot: ['Autopilot', 'The game plays itself'],
  },
  help: {
    keys: ['Arrow keys', 'thrust up, left, down or right. The last key counts. Releasing a key stops the engine'],
    pointer: [
      'Mouse, touch',
      'thrust towards the pointer, the harder the farther it is from the ship',
      'Touch',
      'thrust towards the finger, the harder the farther it is from the ship',
    ],
    stick: [
      'Stick',
      'thrust as far as you push it, on the screen or on a gamepad; its d-pad gives full thrust',
      'Stick',
      'thrust as far as you push it',
    ],
    goal: ['Goal', 'cross the line at the top. A level has one more hole than the last and is worth as many points'],
    danger: ['Danger', 'falling into a hole costs one of three lives'],
    redraw: ['N, New layout', 'other holes, as often as you like; the level then gives no bonus', 'New layout'],
    daily: ['Daily challenge', 'the same holes for everybody on the same date, with a result to share'],
    ghost: ['Ghost', 'your fastest flight past the same holes flies beside you; it is kept in this browser'],
    bonus: ['Bonus', 'for unused fuel, and for every slingshot around a hole'],
  },
  daily: 'Daily challenge',
  redraw: 'New layout',
  redrawHint: 'New layout (N) – no bonus this level',
  level: (level: number) => `Level ${level}`,
  rewards: (points: number, bonus: number) => `worth ${points} · bonus ${bonus}`,
  fuel: (speed: number) => `fuel ${speed} m/s`,
  speed: (spent: number, speed: number) => `Δv ${spent} m/s · speed ${speed} m/s`,
  dodged: (holes: number) => (holes === 1 ? '1 hole dodged' : `${holes} holes dodged`),
  lives: (lives: number) => `lives left: ${lives}`,
  replay: `Replay – ${isTouch ? 'tap' : 'press any arrow key'} to take over`,
  demo: `Demo – ${isTouch ? 'tap' : 'press any arrow key'} to play`,
  autopilot: `Autopilot on – ${isTouch ? 'switch it off in the settings' : 'press A'} to take over`,
  launch: isTouch ? 'Tap or use the stick to launch' : 'Press an arrow key or tap to launch',
  goal: { green: 'Reach the green line.', blue: 'Reach the blue line.' },
  won: (points: number) => `Dodged! +${points}`,
  nowMoving: 'now some holes move',
  sooner: (seconds: number) => `${decimal(seconds, 2)} s before your ghost`,
  later: (seconds: number) => `${decimal(seconds, 2)} s behind your ghost`,
  swallowed: 'Swallowed',
  left: 'Out of bounds – back to the start',
  redrawn: 'New layout – no bonus this level',
  slingshot: 'Slingshot! +1 bonus at the goal',
  empty: 'Out of fuel',
  over: 'Game over',
  dailyTitle: (day: string) => `Daily challenge ${unbroken(day)}`,
  cleared: (levels: number) => `${levels} ${levels === 1 ? 'level' : 'levels'} cleared`,
  slingshots: (count: number) => (count === 1 ? '1 slingshot' : `${count} slingshots`),
  points: (score: number, bonus: number) => `${score} ${score === 1 ? 'point' : 'points'} + ${bonus} bonus`,
  notRanked: (level: number) => `Not ranked: it began at level ${level}.`,
  share: (level: number, slingshots: string, points: string) => `Black hole: level ${level}, ${slingshots}, ${points}`,
  shareDaily: (day: string, level: number, slingshots: string, points: string) =>
    `Black hole, daily ${day}: level ${level}, ${slingshots}, ${points}`,
};

export type Words = typeof en;

const de: Words = {
  title: 'Schwarzes Loch',
  settings: {
    level: [
      'Erste Stufe',
      'Bis zur höchsten, die du erreicht hast; wer höher beginnt, kommt nicht auf die Bestenliste',
    ],
    fuel: ['Treibstoff', 'Ein begrenzter Tank für jeden Flug; was übrig bleibt, gibt Bonuspunkte'],
    moving: ['Bewegte Löcher', 'Ab Stufe 5 kreisen einige Löcher'],
    steep: [
      'Relativistische Schwerkraft',
      'Paczyński-Wiita-Potenzial: unendlich am Horizont, und innerhalb von drei Radien keine stabile Kreisbahn',
    ],
    path: ['Vorhergesagte Bahn', 'Der Flug der nächsten zwei Sekunden'],
    trail: ['Spur', 'Die letzte Bahn des Schiffs'],
    ghost: ['Geist', 'Dein schnellster Flug an denselben Löchern vorbei fliegt als blasses Schiff neben dir'],
    lens: ['Lichtablenkung', 'Löcher lenken das Licht der Sterne hinter ihnen ab'],
    glow: ['Hawking-Leuchten', 'Löcher leuchten: Kleinere sind heißer und heller'],
    sound: 'Ton',
    autopilot: ['Autopilot', 'Das Spiel spielt sich selbst'],
  },
  help: {
    keys: [
      'Pfeiltasten',
      'Schub nach oben, links, unten oder rechts. Die letzte Taste zählt; loslassen stellt das Triebwerk ab',
    ],
    pointer: [
      'Maus, Finger',
      'Schub zum Zeiger hin, umso stärker, je weiter er vom Schiff entfernt ist',
      'Finger',
      'Schub zum Finger hin, umso stärker, je weiter er vom Schiff entfernt ist',
    ],
    stick: [
      'Stick',
      'Schub, so weit du ihn drückst, auf dem Bildschirm oder am Gamepad; das Steuerkreuz gibt vollen',
      'Stick',
      'Schub, so weit du ihn drückst',
    ],
    goal: [
      'Ziel',
      'überquere die Linie oben. Jede Stufe hat ein Loch mehr als die letzte und bringt so viele Punkte, wie sie Löcher hat',
    ],
    danger: ['Gefahr', 'ein Sturz in ein Loch kostet eines von drei Leben'],
    redraw: ['N, Andere Löcher', 'so oft du willst; die Stufe gibt dann keinen Bonus', 'Andere Löcher'],
    daily: ['Tagesaufgabe', 'am selben Tag für alle dieselben Löcher, mit einem Ergebnis zum Teilen'],
    ghost: [
      'Geist',
      'dein schnellster Flug an denselben Löchern vorbei fliegt neben dir; er bleibt in diesem Browser gespeichert',
    ],
    bonus: ['Bonus', 'für übrigen Treibstoff und für jeden Swing-by um ein Loch'],
  },
  daily: 'Tagesaufgabe',
  redraw: 'Andere Löcher',
  redrawHint: 'Andere Löcher (N) – kein Bonus auf dieser Stufe',
  level: (level) => `Stufe ${level}`,
  rewards: (points, bonus) => `zählt ${points} · Bonus ${bonus}`,
  fuel: (speed) => `Treibstoff ${speed} m/s`,
  speed: (spent, speed) => `Δv ${spent} m/s · Tempo ${speed} m/s`,
  dodged: (holes) => (holes === 1 ? '1 Loch umflogen' : `${holes} Löcher umflogen`),
  lives: (lives) => `Leben übrig: ${lives}`,
  replay: `Wiederholung – ${isTouch ? 'tippe' : 'drücke eine Pfeiltaste'}, um zu übernehmen`,
  demo: `Vorführung – ${isTouch ? 'tippe' : 'drücke eine Pfeiltaste'}, um zu spielen`,
  autopilot: `Autopilot an – ${isTouch ? 'in den Einstellungen abschaltbar' : 'mit A übernimmst du'}`,
  launch: isTouch ? 'Tippe oder nimm den Stick, um zu starten' : 'Drücke eine Pfeiltaste oder tippe, um zu starten',
  goal: { green: 'Erreiche die grüne Linie.', blue: 'Erreiche die blaue Linie.' },
  won: (points) => `Geschafft! +${points}`,
  nowMoving: 'jetzt bewegen sich einige Löcher',
  sooner: (seconds) => `${decimal(seconds, 2)} s vor deinem Geist`,
  later: (seconds) => `${decimal(seconds, 2)} s hinter deinem Geist`,
  swallowed: 'Verschluckt',
  left: 'Aus dem Feld geflogen – zurück zum Start',
  redrawn: 'Andere Löcher – kein Bonus auf dieser Stufe',
  slingshot: 'Swing-by! +1 Bonus im Ziel',
  empty: 'Kein Treibstoff mehr',
  over: 'Spiel vorbei',
  dailyTitle: (day) => `Tagesaufgabe ${unbroken(day)}`,
  cleared: (levels) => `${levels} ${levels === 1 ? 'Stufe' : 'Stufen'} geschafft`,
  slingshots: (count) => (count === 1 ? '1 Swing-by' : `${count} Swing-bys`),
  points: (score, bonus) => `${score} ${score === 1 ? 'Punkt' : 'Punkte'} + ${bonus} Bonus`,
  notRanked: (level) => `Ohne Wertung: Es begann auf Stufe ${level}.`,
  share: (level, slingshots, points) => `Schwarzes Loch: Stufe ${level}, ${slingshots}, ${points}`,
  shareDaily: (day, level, slingshots, points) =>
    `Schwarzes Loch, Tagesaufgabe ${day}: Stufe ${level}, ${slingshots}, ${points}`,
};

export const WORDS_BY_LANGUAGE: Readonly<Record<Language, Words>> = { en, de };

export const WORDS = chooseWords(WORDS_BY_LANGUAGE);
