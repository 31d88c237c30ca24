import type { GameDefinition, Simulation } from './game.ts';
import type { Keys, ReleasedKeys } from './keyboard.ts';
import type { Settings } from './settings.ts';
import { touchHelp } from './touch-help.ts';
import { words } from './words.ts';

/** The actions that the player has in every game. */
export interface Actions {
  pause(): void;
  /** The space bar goes down or up: a drag pans while it is down, and without a drag it pauses. */
  spaceBar(down: boolean, isLost?: boolean): void;
  step(): void;
  reset(): void;
  /** Replays the game from its beginning. */
  replay(): void;
  slow(): void;
  /** Rewinds time while `on` is true. */
  rewind(on: boolean): void;
  /** Goes back by one step, or to the last recorded moment if the player acted since. */
  stepBack(): void;
  fit(): void;
  zoom(factor: number): void;
  help(): void;
  sidebar(): void;
  plot(): void;
  profile(): void;
  screenshot(): void;
  copyLink(): void;
  recordVideo(): void;
  /** Records the next seconds to be shared, or gives them up. */
  shareClip(): void;
  fullScreen(): void;
  reducedMotion(): void;
  safeColors(): void;
  renderer(name: string): void;
  toggle(setting: string): void;
}

/** A keyboard action and its line in the help. */
interface Command {
  /** Values of `KeyboardEvent.key`, in lower case. */
  readonly keys: readonly string[];
  /** How the help spells the keys. */
  readonly shown: string;
  readonly description: string;
  readonly press: (key: string) => void;
  readonly release?: (isLost: boolean) => void;
}

/**
 * The key bindings of a game. The game's own controls come first, then its settings, then the commands of all games.
 */
export interface Commands {
  readonly pressed: Keys;
  readonly released: ReleasedKeys;
  /** Pairs of keys or gestures and their descriptions: the game's own first. */
  readonly help: readonly (readonly [string, string])[];
  /** The lines of the help that a touch screen without a keyboard needs. */
  readonly gestures: readonly (readonly [string, string])[];
}

export function gameCommands<S extends Settings, Sim extends Simulation>(
  game: GameDefinition<S, Sim>,
  actions: Actions,
): Commands {
  const steering = Object.values(game.controls?.buttons ?? {}).flatMap(({ keys }) => keys);
  const taken = new Set<string>(steering);
  const pressed: Record<string, () => void> = {};
  const released: Record<string, (isLost: boolean) => void> = {};
  const help: (readonly [string, string])[] = [];
  const again: Command = {
    keys: ['z'],
    shown: 'Z',
    description: words().keys.replay,
    press: actions.replay,
  };
  const all = [
    ...settingCommands(game.settings, actions),
    ...rendererCommands(game, actions),
    ...(game.replay === undefined ? [] : [again]),
    ...common(actions),
  ];
  for (const { keys, shown, description, press, release } of all) {
    const free = keys.filter((key) => !taken.has(key));
    if (free.length === 0) continue;
    for (const key of free) {
      taken.add(key);
      pressed[key] = () => press(key);
      if (release !== undefined) released[key] = release;
    }
    // The help leaves out a key that the game uses for itself.
    help.push([free.length === keys.length ? shown : free.map((key) => key.toUpperCase()).join(' '), description]);
  }
  const own = (game.help ?? []).map(([keys, text]) => [keys, text] as const);
  return { pressed, released, help: [...own, ...help], gestures: touchHelp(game) };
}

function settingCommands(settings: Settings, { toggle }: Actions): Command[] {
  return Object.entries(settings).flatMap(([name, setting]) => {
    if (setting.kind !== 'switch' || setting.key === undefined) return [];
    const { key, label } = setting;
    return [
      { keys: [key], shown: key.toUpperCase(), description: words().keys.onOff(label), press: () => toggle(name) },
    ];
  });
}

function rendererCommands<S extends Settings, Sim extends Simulation>(
  { renderers }: GameDefinition<S, Sim>,
  actions: Actions,
): Command[] {
  const list = Object.entries(renderers);
  if (list.length < 2) return [];
  // Renderers of equal dimensions are told apart by their place in the list.
  const areDistinct = new Set(list.map(([, { dimensions }]) => dimensions)).size === list.length;
  const byKey = new Map(list.map(([name, { dimensions }], i) => [String(areDistinct ? dimensions : i + 1), name]));
  return [
    {
      keys: [...byKey.keys()],
      shown: [...byKey.keys()].join(' '),
      description: words().keys.draw(list.map(([, { label }]) => label).join(words().or)),
      press: (key) => actions.renderer(byKey.get(key) as string),
    },
  ];
}

function common(actions: Actions): Command[] {
  const { step, reset, slow, rewind, stepBack, fit, zoom } = actions;
  const { help, sidebar, plot, profile, screenshot, recordVideo, shareClip } = actions;
  const { fullScreen, reducedMotion, safeColors } = actions;
  const { keys } = words();
  return [
    {
      keys: [' '],
      shown: words().space,
      description: keys.pause,
      press: () => actions.spaceBar(true),
      release: (isLost) => actions.spaceBar(false, isLost),
    },
    { keys: ['.'], shown: '.', description: keys.step, press: step },
    { keys: [','], shown: ',', description: keys.stepBack, press: stepBack },
    {
      keys: ['backspace', 'b'],
      shown: words().holdB,
      description: keys.rewind,
      press: () => rewind(true),
      release: () => rewind(false),
    },
    { keys: ['s'], shown: 'S', description: keys.slow, press: slow },
    { keys: ['r'], shown: 'R', description: keys.restart, press: reset },
    { keys: ['f'], shown: 'F', description: keys.fit, press: fit },
    {
      keys: ['+', '=', '-'],
      shown: '+ −',
      description: keys.zoom,
      press: (key) => zoom(key === '-' ? 0.8 : 1.25),
    },
    { keys: ['e'], shown: 'E', description: keys.plot, press: plot },
    { keys: ['o'], shown: 'O', description: keys.profile, press: profile },
    { keys: ['i'], shown: 'I', description: keys.screenshot, press: screenshot },
    { keys: ['j'], shown: 'J', description: keys.video, press: recordVideo },
    { keys: ['8'], shown: '8', description: keys.clip, press: shareClip },
    { keys: ['w'], shown: 'W', description: keys.fullScreen, press: fullScreen },
    { keys: ['x'], shown: 'X', description: keys.motion, press: reducedMotion },
    { keys: ['y'], shown: 'Y', description: keys.colors, press: safeColors },
    { keys: ['p'], shown: 'P', description: keys.settings, press: sidebar },
    { keys: ['h', '?'], shown: 'H', description: keys.help, press: help },
  ];
}
