/** The sounds of the game's events, and the rumble of the engine. */

import { BLACK_HOLE } from '@principia/scenes';
import { Synth } from '@principia/shell';
import type { GameEvent } from './rules.ts';
import type { BlackHoleGame } from './sim.ts';

/** Time between two puffs of the engine, s. */
const PUFF_INTERVAL = 0.09;
/** A major chord for a goal, Hz. */
const CHORD = [523, 659, 784];

export interface Sounds {
  play(event: GameEvent): void;
  /** Call it once a frame. */
  update(sim: BlackHoleGame, seconds: number, on: boolean): void;
  destroy(): void;
}

export function createSounds(): Sounds {
  const synth = new Synth();
  // A typed array, because a captured variable would allocate a number on the heap in every frame.
  const sincePuff = new Float64Array(1);
  return {
    play({ kind, x }) {
      const pan = (2 * x) / BLACK_HOLE.width - 1;
      if (kind === 'launch') synth.noise({ frequency: 300, to: 1200, loudness: 0.25, seconds: 0.35, pan });
      if (kind === 'goal') for (const frequency of CHORD) synth.tone({ frequency, loudness: 0.16, seconds: 0.9, pan });
      if (kind === 'fall') synth.tone({ frequency: 220, to: 28, loudness: 0.5, seconds: 1.1, pan, wave: 'sawtooth' });
      if (kind === 'left') synth.tone({ frequency: 330, to: 165, loudness: 0.2, seconds: 0.4, pan });
      if (kind === 'sling') synth.tone({ frequency: 500, to: 1500, loudness: 0.2, seconds: 0.25, pan });
      if (kind === 'empty') synth.tone({ frequency: 140, loudness: 0.25, seconds: 0.3, pan, wave: 'square' });
    },
    update({ rules }, seconds, on) {
      synth.set(on);
      sincePuff[0] += seconds;
      const { push } = rules;
      if (push === undefined || !rules.hasFuel || rules.phase !== 'flying' || sincePuff[0] < PUFF_INTERVAL) return;
      sincePuff[0] = 0;
      if (synth.isAudible) puff(synth, Math.hypot(push.x, push.y));
    },
    destroy: () => synth.destroy(),
  };
}

function puff(synth: Synth, strength: number): void {
  synth.noise({ frequency: 170 + 90 * strength, to: 90, loudness: 0.09 * strength, seconds: 0.16 });
}
