import type { PlayerControls } from './controls.ts';
import { paletteOf } from './palette.ts';
import type { FireworksGame } from './sim.ts';

/** The state that tests read. */
export function reportState(sim: FireworksGame, controls: PlayerControls) {
  const { scene, log, fired, refused, isShowing, isDemo, crosshair, held } = sim;
  const { editor, sound, isEditing, kind, color } = controls;
  return {
    hash: sim.hash(),
    log: [...log.entries],
    alive: scene.alive,
    flying: scene.flying,
    news: scene.events.count,
    fired,
    refused,
    isShowing,
    isDemo,
    crosshair: { ...crosshair },
    held: [...held.keys()],
    isEditing,
    kind,
    color,
    cues: editor.cues,
    cursor: editor.cursor,
    chosen: editor.chosen,
    sound: { state: sound.state, heard: sound.soundCount, lastDelay: sound.lastDelay },
  };
}

/** Sets the palette of the shells, unless the world uses it already. */
export function applyColors(sim: FireworksGame, isSafe: boolean): void {
  if (isSafe === sim.usesSafeColors) return;
  sim.usesSafeColors = isSafe;
  sim.press({ do: 'colors', colors: paletteOf(isSafe).map(({ rgb }) => rgb) });
}
