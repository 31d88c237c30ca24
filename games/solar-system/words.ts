/** All words of the game, in every language. The type of the English ones makes a missing translation an error. */
import { chooseWords, decimal, grouped, inLanguage, type Language } from '@principia/shell';

const plural = (count: number, one: string, more: string) => `${count} ${count === 1 ? one : more}`;

const en = {
  title: 'Solar system',
  settings: {
    enlarged: ['Enlarged bodies', 'Off, Sun and planets have their true size, which is less than a pixel from afar'],
    orbits: ['Orbits', 'The ellipse on which each body is at this moment'],
    trails: ['Trails', 'The paths that the bodies have taken'],
    names: 'Names',
    moon: ['Moon', 'Off, Earth and Moon are one body, and time may run up to 100 years a second'],
    sound: 'Sound',
  },
  help: {
    follow: ['Tap a body, 0–9', 'follow it: 0 is the Sun, 3 the Earth, 9 Neptune', 'Tap a body', 'follow it'],
    view: ['Drag, wheel, pinch', 'turn the view and zoom', 'Drag, pinch'],
    time: ['Arrow keys', 'time runs twice as fast, or half as fast'],
    missions: ['Missions', 'launch a probe: set its change of velocity, and let planets pull it'],
    forward: ['Forward', 'along the orbit: more of it leads farther from the Sun on the other side'],
    outward: ['Outward, north', 'away from the Sun, and out of the plane'],
    score: ['Score', 'less fuel and fewer days give more points'],
  },
  /** Names of bodies: by themselves, and within a sentence. */
  bodies: {
    sun: ['Sun', 'the Sun'],
    mercury: ['Mercury', 'Mercury'],
    venus: ['Venus', 'Venus'],
    earth: ['Earth', 'Earth'],
    moon: ['Moon', 'the Moon'],
    mars: ['Mars', 'Mars'],
    jupiter: ['Jupiter', 'Jupiter'],
    saturn: ['Saturn', 'Saturn'],
    uranus: ['Uranus', 'Uranus'],
    neptune: ['Neptune', 'Neptune'],
    pluto: ['Pluto', 'Pluto'],
  },
  largeMoons: { io: 'Io', europa: 'Europa', ganymede: 'Ganymede', callisto: 'Callisto', titan: 'Titan' },
  probe: 'Probe',
  date: 'Date',
  goToDate: 'Go to a date',
  today: 'Today',
  timeSpeed: 'Speed of time',
  slowest: '1 s/s',
  fastest: '100 years/s',
  standsStill: 'time stands still',
  rate: (count: string, unit: string) => `${count} ${unit} a second`,
  years: ['year', 'years'],
  days: ['day', 'days'],
  hours: ['hour', 'hours'],
  minutes: ['minute', 'minutes'],
  seconds: ['second', 'seconds'],
  travelling: (years: number) => `Computing ${plural(years, 'year', 'years')} of all orbits…`,
  /** Why time runs slower than wanted. */
  limits: {
    none: '',
    moon: 'limited: the Moon needs short steps. Switch it off in the settings for up to 100 years a second',
    scheme: 'limited by the steps of the planets',
    encounter: 'slowed down: the probe passes a planet',
  },
  accuracy: 'Against JPL’s ephemeris DE421',
  sky: {
    title: 'In the sky of the Earth',
    groups: {
      transits: 'Transits',
      oppositions: 'Oppositions',
      meetings: 'Planets that meet',
      conjunctions: 'Conjunctions with the Sun',
    },
    note: 'TDB, from the centre of the Earth',
    searching: (year: string) => `Searching, ${year}…`,
    minutes: (angle: number) => `${decimal(angle, 1)}′`,
    degrees: (angle: number) => `${decimal(angle, 1)}°`,
    transit: (body: string, angle: string) => `${body} before the Sun, ${angle} from its centre`,
    inferior: (body: string) => `${body} in inferior conjunction`,
    superior: (body: string, isInner: boolean) => `${body} in ${isInner ? 'superior ' : ''}conjunction`,
    opposition: (body: string, distance: string) => `${body} in opposition, ${distance}`,
    meeting: (body: string, other: string, angle: string) => `${body} near ${other}, ${angle}`,
  },
  errorsOn: (day: string) => `on ${day}, also by distance from the Sun (Moon: Earth); – where none is stored`,
  noReference:
    'JPL’s positions are stored for 2012, and for dates of 2000, 2001, 2010 and 2050: let time pass one of them.',
  welcome: 'Tap a planet to follow it, slide time faster – or fly a mission:',
  missions: {
    mars: {
      title: 'To Mars',
      goal: 'Come within 1 million km of Mars.',
      hint: 'Slide until the dashed path meets ◎, where Mars will be; “Reach Mars” does the last bit.',
    },
    mercury: {
      title: 'Fall to Mercury',
      goal: 'Come within 2 million km of Mercury. Venus must brake you: the tank is too small without it.',
      hint: 'Slide until the path meets Venus. Pass before it, and its gravity takes speed from you; then reach for Mercury.',
    },
    saturn: {
      title: 'Jupiter slingshot',
      goal: 'Swing by Jupiter to Saturn, within 5 million km, in the autumn of the Voyagers.',
      hint: 'Slide until the path meets Jupiter. Pass behind it, and it drags you along; then reach for Saturn.',
    },
  },
  endMission: 'End mission',
  tryIt: 'Fly it yourself',
  flyAgain: 'Fly again',
  forward: 'Forward',
  outward: 'Outward',
  north: 'North',
  launch: 'Launch',
  burn: 'Burn',
  wait: (days: number) => `+${plural(days, 'day', 'days')}`,
  aiming: 'Aiming…',
  passBehind: (name: string) => `Pass behind ${name}`,
  passBefore: (name: string) => `Pass before ${name}`,
  reach: (name: string) => `Reach ${name}`,
  helpFrom: (name: string, millions: number) => `Help with aiming begins within ${millions} million km of ${name}.`,
  pass: (name: string, distance: string, day: number) => `${name} at ${distance} on day ${day}`,
  both: (first: string, second: string) => `${first}, ${second}`,
  willPass: (what: string) => `Passes ${what}.`,
  flying: (day: number, most: number, distance: string, target: string) =>
    `Day ${day} of ${most}, ${distance} from ${target}.`,
  passed: (name: string, distance: string) => `Passed ${name} at ${distance}.`,
  laterPasses: (what: string) => `Will pass ${what}.`,
  spent: (speed: string, budget: string) => `Δv ${speed} of ${budget} km/s`,
  overBudget: (budget: string) => `More than the ${budget} km/s of this mission`,
  aimFailed: 'No way found from here. Change the sliders a little, or wait some days.',
  arrived: (name: string) => `${name} reached`,
  lost: (name: string) => `${name} missed`,
  hit: (name: string) => `Crashed into ${name}`,
  points: (points: number) => `${points} points`,
  result: (spent: string, days: number) => `${spent}, ${days} days`,
  closest: (name: string, distance: string) => `Closest to ${name}: ${distance}`,
  share: (mission: string, points: number, speed: string, days: number) =>
    `Solar system, ${mission}: ${points} points with ${speed} in ${days} days. Watch my flight:`,
  millions: (count: string) => `${count} million km`,
  /** What may be wrong with the address. */
  link: {
    wrong: (name: string, wanted: string, was: string) =>
      `In the address, ${name} must be ${wanted}, but it was “${was}”.`,
    mission: 'mars, mercury or saturn',
    date: (first: string, last: string) => `a day from ${first} to ${last}, such as 2012-07-04`,
    speed: (least: number, most: number) => `a number of seconds from ${least} to ${most}`,
    flight: 'a list of burns, each of four numbers',
    follow: (names: string) => `one of ${names}`,
  },
};

export type Words = typeof en;

const de: Words = {
  title: 'Sonnensystem',
  settings: {
    enlarged: ['Vergrößerte Körper', 'Aus: Sonne und Planeten in wahrer Größe, von fern weniger als ein Pixel'],
    orbits: ['Bahnen', 'Die Ellipse, auf der jeder Körper in diesem Augenblick ist'],
    trails: ['Spuren', 'Die Wege, die die Körper genommen haben'],
    names: 'Namen',
    moon: ['Mond', 'Aus: Erde und Mond sind ein Körper, und die Zeit darf bis zu 100 Jahre pro Sekunde laufen'],
    sound: 'Ton',
  },
  help: {
    follow: [
      'Tippen, 0–9',
      'folgt einem Körper: 0 ist die Sonne, 3 die Erde, 9 Neptun',
      'Tippen',
      'folgt einem Körper',
    ],
    view: ['Ziehen, Mausrad', 'dreht und zoomt die Ansicht', 'Ziehen, zwei Finger'],
    time: ['Pfeiltasten', 'die Zeit läuft doppelt oder halb so schnell'],
    missions: [
      'Missionen',
      'starte eine Sonde: Stelle ein, wie sich ihre Geschwindigkeit ändert, und lass Planeten sie ziehen',
    ],
    forward: ['Vorwärts', 'entlang der Bahn: Mehr davon führt auf der anderen Seite weiter von der Sonne weg'],
    outward: ['Auswärts, Norden', 'weg von der Sonne und aus der Bahnebene hinaus'],
    score: ['Wertung', 'weniger Treibstoff und weniger Tage geben mehr Punkte'],
  },
  bodies: {
    sun: ['Sonne', 'die Sonne'],
    mercury: ['Merkur', 'den Merkur'],
    venus: ['Venus', 'die Venus'],
    earth: ['Erde', 'die Erde'],
    moon: ['Mond', 'den Mond'],
    mars: ['Mars', 'den Mars'],
    jupiter: ['Jupiter', 'den Jupiter'],
    saturn: ['Saturn', 'den Saturn'],
    uranus: ['Uranus', 'den Uranus'],
    neptune: ['Neptun', 'den Neptun'],
    pluto: ['Pluto', 'den Pluto'],
  },
  largeMoons: { io: 'Io', europa: 'Europa', ganymede: 'Ganymed', callisto: 'Kallisto', titan: 'Titan' },
  probe: 'Sonde',
  date: 'Datum',
  goToDate: 'Zu einem Datum gehen',
  today: 'Heute',
  timeSpeed: 'Tempo der Zeit',
  slowest: '1 s/s',
  fastest: '100 Jahre/s',
  standsStill: 'die Zeit steht still',
  rate: (count, unit) => `${count} ${unit} pro Sekunde`,
  years: ['Jahr', 'Jahre'],
  days: ['Tag', 'Tage'],
  hours: ['Stunde', 'Stunden'],
  minutes: ['Minute', 'Minuten'],
  seconds: ['Sekunde', 'Sekunden'],
  travelling: (years) => `Berechnet ${plural(years, 'Jahr', 'Jahre')} aller Bahnen …`,
  limits: {
    none: '',
    moon: 'gebremst: Der Mond braucht kurze Schritte. Ohne ihn (Einstellungen) gehen bis zu 100 Jahre pro Sekunde',
    scheme: 'begrenzt durch die Schritte der Planeten',
    encounter: 'gebremst: Die Sonde fliegt an einem Planeten vorbei',
  },
  accuracy: 'Verglichen mit DE421 vom JPL',
  sky: {
    title: 'Am Himmel der Erde',
    groups: {
      transits: 'Transite',
      oppositions: 'Oppositionen',
      meetings: 'Begegnungen von Planeten',
      conjunctions: 'Konjunktionen mit der Sonne',
    },
    note: 'TDB, vom Mittelpunkt der Erde aus',
    searching: (year) => `Sucht, ${year} …`,
    minutes: (angle) => `${decimal(angle, 1)}′`,
    degrees: (angle) => `${decimal(angle, 1)}°`,
    transit: (body, angle) => `${body} vor der Sonne, ${angle} von ihrer Mitte`,
    inferior: (body) => `${body} in unterer Konjunktion`,
    superior: (body, isInner) => `${body} in ${isInner ? 'oberer ' : ''}Konjunktion`,
    opposition: (body, distance) => `${body} in Opposition, ${distance}`,
    meeting: (body, other, angle) => `${body} bei ${other}, ${angle}`,
  },
  errorsOn: (day) => `am ${day}, auch je Abstand von der Sonne (Mond: Erde); – wo keine gespeichert ist`,
  noReference:
    'Positionen des JPL sind für 2012 gespeichert und für Tage in 2000, 2001, 2010 und 2050: Lass die Zeit über einen davon laufen.',
  welcome: 'Tippe auf einen Planeten, um ihm zu folgen, lass die Zeit schneller laufen – oder flieg eine Mission:',
  missions: {
    mars: {
      title: 'Zum Mars',
      goal: 'Komm dem Mars auf 1 Million km nahe.',
      hint: 'Schiebe, bis die gestrichelte Bahn ◎ trifft, wo der Mars dann ist; „Ziel: Mars“ tut den Rest.',
    },
    mercury: {
      title: 'Sturz zum Merkur',
      goal: 'Komm dem Merkur auf 2 Millionen km nahe. Die Venus muss dich bremsen: Ohne sie reicht der Tank nicht.',
      hint: 'Schiebe, bis die Bahn die Venus trifft. Flieg vor ihr vorbei, und ihre Schwerkraft nimmt dir Fahrt; ziele dann auf den Merkur.',
    },
    saturn: {
      title: 'Schwung am Jupiter',
      goal: 'Hol Schwung am Jupiter und komm dem Saturn auf 5 Millionen km nahe, im Herbst der Voyager-Sonden.',
      hint: 'Schiebe, bis die Bahn den Jupiter trifft. Flieg hinter ihm vorbei, und er zieht dich mit; ziele dann auf den Saturn.',
    },
  },
  endMission: 'Mission beenden',
  tryIt: 'Selbst fliegen',
  flyAgain: 'Noch einmal fliegen',
  forward: 'Vorwärts',
  outward: 'Auswärts',
  north: 'Norden',
  launch: 'Starten',
  burn: 'Zünden',
  wait: (days) => `+${plural(days, 'Tag', 'Tage')}`,
  aiming: 'Zielt …',
  passBehind: (name) => `Hinter ${name} vorbei`,
  passBefore: (name) => `Vor ${name} vorbei`,
  reach: (name) => `Ziel: ${name}`,
  helpFrom: (name, millions) => `Zielhilfe ab ${millions} Mio. km (${name}).`,
  pass: (name, distance, day) => `${name} in ${distance} Abstand an Tag ${day}`,
  both: (first, second) => `${first} und ${second}`,
  willPass: (what) => `Passiert ${what}.`,
  flying: (day, most, distance, target) => `Tag ${day} von ${most}, ${distance} bis ${target}.`,
  passed: (name, distance) => `${name} in ${distance} Abstand passiert.`,
  laterPasses: (what) => `Passiert dann ${what}.`,
  spent: (speed, budget) => `Δv ${speed} von ${budget} km/s`,
  overBudget: (budget) => `Mehr als die ${budget} km/s dieser Mission`,
  aimFailed: 'Von hier aus kein Weg gefunden. Ändere die Regler ein wenig oder warte ein paar Tage.',
  arrived: (name) => `${name} erreicht`,
  lost: (name) => `${name} verfehlt`,
  hit: (name) => `Gegen ${name} geprallt`,
  points: (points) => `${points} Punkte`,
  result: (spent, days) => `${spent}, ${days} Tage`,
  closest: (name, distance) => `Kleinster Abstand von ${name}: ${distance}`,
  share: (mission, points, speed, days) =>
    `Sonnensystem, ${mission}: ${points} Punkte mit ${speed} in ${days} Tagen. Sieh dir meinen Flug an:`,
  millions: (count) => `${count} Mio. km`,
  link: {
    wrong: (name, wanted, was) => `In der Adresse muss ${name} ${wanted} sein, war aber „${was}“.`,
    mission: 'mars, mercury oder saturn',
    date: (first, last) => `ein Tag von ${first} bis ${last}, etwa 2012-07-04,`,
    speed: (least, most) => `eine Zahl von Sekunden von ${least} bis ${most}`,
    flight: 'eine Liste von Zündungen mit je vier Zahlen',
    follow: (names) => `eines von ${names}`,
  },
};

export const WORDS_BY_LANGUAGE: Readonly<Record<Language, Words>> = { en, de };

export const WORDS = chooseWords(WORDS_BY_LANGUAGE);

const UNITS = [
  [365.25 * 86400, 'years'],
  [86400, 'days'],
  [3600, 'hours'],
  [60, 'minutes'],
  [1, 'seconds'],
] as const;

/** A rate of time, such as `5 days a second`. */
export function rateText(rate: number): string {
  if (rate === 0) return WORDS.standsStill;
  const [length, unit] = UNITS.find(([seconds]) => rate >= 0.95 * seconds) ?? UNITS[4];
  const count = rate / length;
  const number = count < 10 ? Number(count.toPrecision(2)) : Math.round(count);
  return WORDS.rate(inLanguage(String(number)), WORDS[unit][number === 1 ? 0 : 1]);
}

/** A distance, such as `320 m`, `384,000 km` or `2.31 million km`. */
export function distanceText(km: number): string {
  if (!Number.isFinite(km)) return '–';
  if (km < 0.995) return `${Math.round(1000 * km)} m`;
  if (km < 10) return `${decimal(km, 1)} km`;
  if (km < 9.95e5) return `${grouped(Number(km.toPrecision(3)))} km`;
  const millions = km / 1e6;
  return WORDS.millions(millions < 100 ? inLanguage(millions.toPrecision(3)) : grouped(Math.round(millions)));
}

/** A part of a distance, such as `2·10⁻⁹`. */
export function shareText(share: number): string {
  if (!(share > 0)) return '0';
  const [digit, power10] = share.toExponential(0).split('e');
  const exponent = Number(power10);
  const digits = '⁰¹²³⁴⁵⁶⁷⁸⁹';
  const power = `${exponent < 0 ? '⁻' : ''}${[...String(Math.abs(exponent))].map((digit) => digits[Number(digit)]).join('')}`;
  return `${digit}·10${power}`;
}

export const speedText = (kmPerSecond: number): string => `${decimal(kmPerSecond, 2)} km/s`;
