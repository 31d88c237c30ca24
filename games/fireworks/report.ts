import type { Desk } from './desk.ts';
import { paletteOf } from './palette.ts';
import type { FireworksGame } from './sim.ts';

/** What tests see. */
export function tell(sim: FireworksGame, desk: Desk) {
  const { scene, log, fired, refused, isShowing, isDemo, sight, held } = sim;
  const { editor, sound, isEditing, kind, color } = desk;
  return {
    hash: sim.hash(),
    log: [...log.entries],
    alive: scene.alive,
    flying: scene.flying,
    news: scene.news.count,
    fired,
    refused,
    isShowing,
    isDemo,
    sight: { ...sight },
    held: [...held.keys()],
    isEditing,
    kind,
    color,
    cues: editor.cues,
    cursor: editor.cursor,
    chosen: editor.chosen,
    sound: { state: sound.state, heard: sound.heard, lastDelay: sound.lastDelay },
  };
}

/** Gives the shells their colours; a world that has them already is left alone. */
export function dress(sim: FireworksGame, isSafe: boolean): void {
  if (isSafe === sim.isSafe) return;
  sim.isSafe = isSafe;
  sim.press({ do: 'colors', colors: paletteOf(isSafe).map(({ rgb }) => rgb) });
}
