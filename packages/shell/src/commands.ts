import type { GameDefinition, Simulation } from './game.ts';
import type { Keys } from './keyboard.ts';
import type { Settings } from './settings.ts';

/** What the player can do in every game. */
export interface Actions {
  pause(): void;
  step(): void;
  reset(): void;
  /** Plays the game again from its beginning. */
  replay(): void;
  slow(): void;
  /** Goes back in time as long as it is on. */
  rewind(on: boolean): void;
  /** Goes back to the moment kept before this one. */
  stepBack(): void;
  fit(): void;
  zoom(factor: number): void;
  help(): void;
  side(): void;
  plot(): void;
  profile(): void;
  picture(): void;
  film(): void;
  fullScreen(): void;
  calm(): void;
  safeColors(): void;
  renderer(name: string): void;
  toggle(setting: string): void;
}

/** Something a key does, and the line that says so. */
interface Command {
  /** Names as in `KeyboardEvent.key`, in lower case. */
  readonly keys: readonly string[];
  /** As the help shows the keys. */
  readonly shown: string;
  readonly what: string;
  readonly press: (key: string) => void;
  readonly release?: () => void;
}

/** The keys of a game: the player's own controls come first, then the game's settings, then what every game has. */
export interface Commands {
  readonly pressed: Keys;
  readonly released: Keys;
  /** Keys or gestures, and what they do. */
  readonly help: readonly (readonly [string, string])[];
}

export function gameCommands<S extends Settings, Sim extends Simulation>(
  game: GameDefinition<S, Sim>,
  actions: Actions,
): Commands {
  const steering = Object.values(game.controls?.buttons ?? {}).flatMap(({ keys }) => keys);
  const taken = new Set<string>(steering);
  const pressed: Record<string, () => void> = {};
  const released: Record<string, () => void> = {};
  const help: (readonly [string, string])[] = [];
  const again: Command = { keys: ['z'], shown: 'Z', what: 'watch this game from its beginning', press: actions.replay };
  const all = [
    ...settingCommands(game.settings, actions),
    ...rendererCommands(game, actions),
    ...(game.replay === undefined ? [] : [again]),
    ...common(actions),
  ];
  for (const { keys, shown, what, press, release } of all) {
    const free = keys.filter((key) => !taken.has(key));
    if (free.length === 0) continue;
    for (const key of free) {
      taken.add(key);
      pressed[key] = () => press(key);
      if (release !== undefined) released[key] = release;
    }
    // A key that a game uses for itself is left out of the line.
    help.push([free.length === keys.length ? shown : free.map((key) => key.toUpperCase()).join(' '), what]);
  }
  return { pressed, released, help: [...(game.help ?? []), ...help] };
}

function settingCommands(settings: Settings, { toggle }: Actions): Command[] {
  return Object.entries(settings).flatMap(([name, setting]) => {
    if (setting.kind !== 'switch' || setting.key === undefined) return [];
    const { key, label } = setting;
    return [{ keys: [key], shown: key.toUpperCase(), what: `${label} on or off`, press: () => toggle(name) }];
  });
}

function rendererCommands<S extends Settings, Sim extends Simulation>(
  { renderers }: GameDefinition<S, Sim>,
  actions: Actions,
): Command[] {
  const list = Object.entries(renderers);
  if (list.length < 2) return [];
  const byKey = new Map(list.map(([name, { dimensions }]) => [String(dimensions), name]));
  return [
    {
      keys: [...byKey.keys()],
      shown: [...byKey.keys()].join(' '),
      what: `draw in ${list.map(([, { label }]) => label).join(' or ')}`,
      press: (key) => actions.renderer(byKey.get(key) as string),
    },
  ];
}

function common(actions: Actions): Command[] {
  const { pause, step, reset, slow, rewind, stepBack, fit, zoom } = actions;
  const { help, side, plot, profile, picture, film, fullScreen, calm, safeColors } = actions;
  return [
    { keys: [' '], shown: 'Space', what: 'pause and go on', press: pause },
    { keys: ['.', 'arrowright'], shown: '. or →', what: 'one step', press: step },
    { keys: [','], shown: ',', what: 'one moment back', press: stepBack },
    {
      keys: ['backspace', 'b'],
      shown: 'B, held',
      what: 'back in time, the last twenty seconds',
      press: () => rewind(true),
      release: () => rewind(false),
    },
    { keys: ['s'], shown: 'S', what: 'slow motion', press: slow },
    { keys: ['r'], shown: 'R', what: 'start again', press: reset },
    { keys: ['f'], shown: 'F', what: 'see everything', press: fit },
    { keys: ['+', '=', '-'], shown: '+ −', what: 'closer, farther', press: (key) => zoom(key === '-' ? 0.8 : 1.25) },
    { keys: ['e'], shown: 'E', what: 'next plot: energy, momentum, any column', press: plot },
    { keys: ['o'], shown: 'O', what: 'time of a step by phase', press: profile },
    { keys: ['i'], shown: 'I', what: 'the picture as a file', press: picture },
    { keys: ['m'], shown: 'M', what: 'film, from now until pressed again', press: film },
    { keys: ['w'], shown: 'W', what: 'whole screen', press: fullScreen },
    { keys: ['x'], shown: 'X', what: 'less motion', press: calm },
    { keys: ['y'], shown: 'Y', what: 'colours that everybody tells apart', press: safeColors },
    { keys: ['p'], shown: 'P', what: 'panel', press: side },
    { keys: ['h', '?'], shown: 'H', what: 'this help', press: help },
  ];
}
