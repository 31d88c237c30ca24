/** A button that chooses music on this device: shells burst on its beats. The file is read here and sent nowhere. */
import { element, type ViewContext } from '@principia/shell';
import { findBeats } from './beats.ts';
import type { PlayerControls } from './controls.ts';
import { MusicPlayer } from './music-player.ts';
import { composeShow } from './music-show.ts';
import type { Settings } from './settings.ts';
import type { Cue, FireworksGame } from './sim.ts';
import { WORDS } from './words.ts';

export interface MusicButton {
  readonly elements: readonly HTMLElement[];
  /** Call it once a frame. */
  update(): void;
  destroy(): void;
}

export function createMusicButton(
  context: ViewContext<Settings, FireworksGame>,
  controls: PlayerControls,
): MusicButton {
  const button = element('button', 'fw-extra', { type: 'button' }, WORDS.music);
  button.title = WORDS.musicHint;
  const input = element('input', '', { type: 'file', accept: 'audio/*', hidden: '', 'aria-label': WORDS.musicFile });
  const player = new MusicPlayer();
  let cues: readonly Cue[] | undefined;
  const stop = () => {
    cues = undefined;
    player.stop();
    button.textContent = WORDS.music;
  };
  const start = async (file: File) => {
    button.textContent = WORDS.listening;
    try {
      const music = await player.load(file);
      const beats = findBeats(music.samples, music.rate);
      cues = composeShow(beats, context.sim().world.tick + 1);
      if (cues.length === 0) throw new Error(WORDS.noBeats(file.name));
      context.sim().press({ do: 'play', cues });
      player.start();
      button.textContent = WORDS.stopMusic;
    } catch (error) {
      stop();
      controls.showMessage((error as Error).message);
    }
  };
  button.addEventListener('click', () => {
    if (cues === undefined) {
      input.click();
      return;
    }
    context.sim().press({ do: 'stop' });
    stop();
  });
  input.addEventListener('change', () => {
    const [file] = input.files ?? [];
    if (file !== undefined) void start(file);
    input.value = '';
  });
  return {
    elements: [button, input],
    update() {
      if (cues === undefined) return;
      const sim = context.sim();
      // Until the next step the show has not begun; another show, or another world, ends the music.
      const isWaiting = sim.log.state.waiting.length > 0;
      if (sim.show !== cues && !isWaiting) stop();
      else player.follow(isWaiting ? 0 : (sim.world.tick - sim.showStart) * sim.dt, context.values().sound);
      if (player.hasEnded) stop();
    },
    destroy: () => player.destroy(),
  };
}
