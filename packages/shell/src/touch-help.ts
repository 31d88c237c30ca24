import type { GameDefinition, HelpLine, Simulation } from './game.ts';
import type { Settings } from './settings.ts';
import { words } from './words.ts';

type Line = readonly [input: string, description: string];

/** The help of a game on a touch screen: the game's own gestures, or else those of the views and the buttons on the screen. */
export function touchHelp<S extends Settings, Sim extends Simulation>(game: GameDefinition<S, Sim>): readonly Line[] {
  const own = (game.help ?? []).filter(([, , gesture]) => gesture !== '').map(onTouch);
  return own.length > 0 ? own : commonLines(game);
}

const onTouch = ([input, text, gesture = input, description = text]: HelpLine): Line => [gesture, description];

function commonLines<S extends Settings, Sim extends Simulation>({
  controls,
  renderers,
}: GameDefinition<S, Sim>): readonly Line[] {
  const { gestures, ways } = words();
  const { drag, turn, fingers, pause, rewind, restart, panel, help } = gestures;
  const turns = Object.values(renderers).some(({ dimensions }) => dimensions === 3);
  const buttons = Object.entries(controls?.buttons ?? {})
    .filter(([, { touch = true }]) => touch)
    .map(([name, { label, title }]) => [label, title ?? ways[name] ?? name]);
  const lines = [drag, ...(turns ? [turn] : []), fingers, ...buttons, pause, rewind, restart, panel, help];
  return lines.map(([input, description]) => [input, description]);
}
