/** All words of the game, in every language. The type of the English ones makes a missing translation an error. */
import { chooseWords, decimal, hasCoarsePointer, type Language } from '@principia/shell';

const isTouch = hasCoarsePointer();

const en = {
  title: 'Flight simulator',
  settings: {
    mission: 'Mission',
    assist: ['Assistant', 'Holds the attitude that you fly; without it the stick moves the control surfaces'],
    inverted: ['↑ raises the nose', 'In an aeroplane one pulls the stick back to raise the nose, so ↓ does'],
    crosswind: ['Crosswind', 'From the left where positive'],
    turbulence: ['Gusts', 'Turbulence by Dryden, whose vertical gusts have this deviation'],
    hold: ['Hold altitude', 'An autopilot that keeps the altitude by the pitch; ↑ and ↓ select another'],
    unsteady: ['Stall lags', 'The flow separates and comes back with a delay, as Goman and Khrabrov model it'],
    propwash: ['Propeller’s wash', 'The air that the propeller blows backwards meets the tail'],
    cockpit: 'Cockpit',
    sound: 'Sound',
  },
  missions: { circuit: 'A circuit', landing: 'A landing', free: 'Free flight' },
  help: {
    stick: [
      'Arrow keys, stick',
      '← and → bank; ↓ pulls the stick and raises the nose, ↑ lowers it',
      'Stick',
      'left and right bank; pulled down it raises the nose, pushed up it lowers it',
    ],
    throttle: ['T and G, ⇧ and ⇩', 'more and less throttle', '⇧ and ⇩'],
    brake: ['N, ■', 'brake on the ground', '■'],
    rudder: [
      'A and D, slider',
      'rudder, which also steers on the ground; the slider stays where a mouse leaves it',
      'Slider',
      'rudder, which also steers on the ground; let go, and it centres itself',
    ],
    mouse: ['Mouse', 'drag it like the stick; the wheel is the throttle, and below idle the brake'],
    look: ['Right button, one finger', 'look around', 'One finger'],
  },
  /** What to do next. */
  tasks: {
    stall: 'Stall! Push the nose down, and give thrust',
    throttle: isTouch ? 'Hold ⇧ for full throttle' : 'Hold T for full throttle, or turn the mouse wheel up',
    gather: 'Gathering speed…',
    rotate: `Fast enough: ${isTouch ? 'pull the stick back' : 'hold ↓, or drag down,'} gently to raise the nose`,
    ring: (ring: number, count: number) => `Fly through ring ${ring} of ${count}`,
    brake: isTouch ? 'Hold ■ to stop on the runway' : 'Hold N, or turn the wheel down, to stop on the runway',
    flare: `Throttle back, and ${isTouch ? 'pull the stick back' : 'hold ↓, or drag down,'} to touch down softly`,
    slow: 'Too slow: more throttle, nose down',
    approach: 'Land on the runway: line up with it, and slow down',
  },
  instruments: 'Instruments: throttle, airspeed, horizon, heading, altitude, vertical speed',
  rudder: 'Rudder',
  rudderHint: 'Rudder: drag it, and click twice to centre it',
  holds: (metres: number) => `holds ${metres} m`,
  throttle: 'PWR',
  brake: 'BRAKE',
  compass: ['N', 'NE', 'E', 'SE', 'S', 'SW', 'W', 'NW'],
  kilometres: (distance: number) => `${decimal(distance, 1)} km`,
  landed: 'Landed!',
  offRunway: 'Down, but not on the runway',
  crashed: 'Crashed',
  points: (score: number) => `${score} points`,
  share: (mission: string, score: number) => `Flight simulator, ${mission}: ${score} points`,
  /** Parts that strike the ground, at the beginning of a sentence and within one. */
  parts: {
    gear: ['The landing gear', 'the landing gear'],
    propeller: ['The propeller', 'the propeller'],
    belly: ['The belly', 'the belly'],
    tail: ['The tail', 'the tail'],
    leftWing: ['The left wing', 'the left wing'],
    rightWing: ['The right wing', 'the right wing'],
    cabin: ['The cabin', 'the cabin'],
  },
  offMap: 'You flew off the map and out of fuel.',
  gearBroke: (sink: number, most: number) =>
    `The landing gear broke: you sank at ${decimal(sink, 1)} m/s, and it takes ${decimal(most, 1)}. Raise the nose just above the runway.`,
  stalled: (degrees: number, sink: number) =>
    `The wing had stalled: at ${degrees}° of attack it carries less, and you fell at ${decimal(sink, 0)} m/s. Push the nose down to stay fast.`,
  dived: (sink: number) => `You dived into the ground at ${decimal(sink, 0)} m/s. Raise the nose in time.`,
  hill: (part: string) => `You flew into a hill: ${part} struck it.`,
  wingStruck: (part: string, degrees: number) =>
    `${part} struck the ground: you banked by ${degrees}°. Level the wings to land.`,
  tailStruck: (degrees: number) => `The tail struck the ground: the nose was ${degrees}° up.`,
  propellerStruck: (degrees: number) =>
    `The propeller struck the ground: the nose was ${degrees}° down. Touch down with the nose up.`,
  struck: (part: string) => `${part} struck the ground.`,
  soft: 'As soft as a feather',
  good: 'A good landing',
  firm: 'A firm landing',
  fromLine: (metres: number) => `${decimal(metres, 0)} m from the centre line`,
  onGrass: 'on the grass',
  bounces: (bounces: number) => `with ${bounces} ${bounces === 1 ? 'bounce' : 'bounces'}`,
  landing: (how: string, sink: number, details: string, points: number) =>
    `${how}: ${decimal(sink, 1)} m/s down, ${details}. ${points} points for it.`,
};

export type Words = typeof en;

const de: Words = {
  title: 'Flugsimulator',
  settings: {
    mission: 'Aufgabe',
    assist: ['Assistent', 'Hält die Lage, die du fliegst; ohne ihn bewegt der Knüppel die Ruder'],
    inverted: ['↑ hebt die Nase', 'Im Flugzeug zieht man den Knüppel, um die Nase zu heben, also tut es ↓'],
    crosswind: ['Seitenwind', 'Von links, wenn positiv'],
    turbulence: ['Böen', 'Turbulenz nach Dryden; die senkrechten Böen haben diese Streuung'],
    hold: ['Höhe halten', 'Ein Autopilot, der mit der Längsneigung die Höhe hält; ↑ und ↓ wählen eine andere'],
    unsteady: [
      'Abriss mit Verzug',
      'Die Strömung reißt verzögert ab und legt sich verzögert an, nach Goman und Khrabrov',
    ],
    propwash: ['Propellerstrahl', 'Die Luft, die der Propeller nach hinten bläst, trifft das Leitwerk'],
    cockpit: 'Cockpit',
    sound: 'Ton',
  },
  missions: { circuit: 'Eine Platzrunde', landing: 'Eine Landung', free: 'Freier Flug' },
  help: {
    stick: [
      'Pfeiltasten, Stick',
      '← und → legen in die Kurve; ↓ zieht den Knüppel und hebt die Nase, ↑ senkt sie',
      'Stick',
      'links und rechts legen in die Kurve; nach unten gezogen hebt er die Nase, nach oben gedrückt senkt er sie',
    ],
    throttle: ['T und G, ⇧ und ⇩', 'mehr und weniger Gas', '⇧ und ⇩'],
    brake: ['N, ■', 'Bremse am Boden', '■'],
    rudder: [
      'A und D, Schieber',
      'Seitenruder, das auch am Boden lenkt; der Schieber bleibt, wo die Maus ihn lässt',
      'Schieber',
      'Seitenruder, das auch am Boden lenkt; losgelassen stellt es sich gerade',
    ],
    mouse: ['Maus', 'zieh sie wie den Knüppel; das Rad gibt Gas und bremst unter dem Leerlauf'],
    look: ['Rechte Taste, ein Finger', 'umsehen', 'Ein Finger'],
  },
  tasks: {
    stall: 'Strömungsabriss! Nase runter und Gas geben',
    throttle: isTouch ? 'Halte ⇧ für Vollgas' : 'Halte T für Vollgas oder dreh das Mausrad hoch',
    gather: 'Nimmt Fahrt auf …',
    rotate: `Schnell genug: ${isTouch ? 'zieh den Stick sanft zurück' : 'halte sanft ↓ oder zieh nach unten'}, um die Nase zu heben`,
    ring: (ring, count) => `Flieg durch Ring ${ring} von ${count}`,
    brake: isTouch
      ? 'Halte ■, um auf der Bahn anzuhalten'
      : 'Halte N oder dreh das Rad herunter, um auf der Bahn anzuhalten',
    flare: `Gas weg und ${isTouch ? 'Stick zurück' : '↓ halten oder nach unten ziehen'}, um weich aufzusetzen`,
    slow: 'Zu langsam: mehr Gas, Nase runter',
    approach: 'Lande auf der Bahn: richte dich auf sie aus und werde langsamer',
  },
  instruments: 'Instrumente: Gas, Fahrt, Horizont, Kurs, Höhe, Steigen',
  rudder: 'Seitenruder',
  rudderHint: 'Seitenruder: ziehen, und zweimal klicken für die Mitte',
  holds: (metres) => `hält ${metres} m`,
  throttle: 'GAS',
  brake: 'BREMSE',
  compass: ['N', 'NO', 'O', 'SO', 'S', 'SW', 'W', 'NW'],
  kilometres: (distance) => `${decimal(distance, 1)} km`,
  landed: 'Gelandet!',
  offRunway: 'Unten, aber nicht auf der Bahn',
  crashed: 'Abgestürzt',
  points: (score) => `${score} Punkte`,
  share: (mission, score) => `Flugsimulator, ${mission}: ${score} Punkte`,
  parts: {
    gear: ['Das Fahrwerk', 'das Fahrwerk'],
    propeller: ['Der Propeller', 'der Propeller'],
    belly: ['Der Bauch', 'der Bauch'],
    tail: ['Das Heck', 'das Heck'],
    leftWing: ['Der linke Flügel', 'der linke Flügel'],
    rightWing: ['Der rechte Flügel', 'der rechte Flügel'],
    cabin: ['Die Kabine', 'die Kabine'],
  },
  offMap: 'Du bist von der Karte geflogen, und der Sprit ist alle.',
  gearBroke: (sink, most) =>
    `Das Fahrwerk ist gebrochen: Du sankst mit ${decimal(sink, 1)} m/s, und es hält ${decimal(most, 1)} aus. Heb die Nase kurz über der Bahn.`,
  stalled: (degrees, sink) =>
    `Die Strömung war abgerissen: Bei ${degrees}° Anstellwinkel trägt der Flügel weniger, und du fielst mit ${decimal(sink, 0)} m/s. Drück die Nase hinunter, um schnell zu bleiben.`,
  dived: (sink) => `Du bist mit ${decimal(sink, 0)} m/s in den Boden geflogen. Heb die Nase rechtzeitig.`,
  hill: (part) => `Du bist gegen einen Hügel geflogen: Getroffen hat ihn ${part}.`,
  wingStruck: (part, degrees) =>
    `${part} hat den Boden berührt: Du lagst ${degrees}° schräg. Landen musst du mit waagrechten Flügeln.`,
  tailStruck: (degrees) => `Das Heck hat den Boden berührt: Die Nase war ${degrees}° oben.`,
  propellerStruck: (degrees) =>
    `Der Propeller hat den Boden berührt: Die Nase war ${degrees}° unten. Setz mit der Nase oben auf.`,
  struck: (part) => `${part} hat den Boden berührt.`,
  soft: 'Federweich',
  good: 'Eine gute Landung',
  firm: 'Eine harte Landung',
  fromLine: (metres) => `${decimal(metres, 0)} m neben der Mittellinie`,
  onGrass: 'im Gras',
  bounces: (bounces) => `mit ${bounces} ${bounces === 1 ? 'Hüpfer' : 'Hüpfern'}`,
  landing: (how, sink, details, points) =>
    `${how}: ${decimal(sink, 1)} m/s abwärts, ${details}. Das bringt ${points} Punkte.`,
};

export const WORDS_BY_LANGUAGE: Readonly<Record<Language, Words>> = { en, de };

export const WORDS = chooseWords(WORDS_BY_LANGUAGE);
