/** The sounds of the game's events, and the rumble of the engine. */

import { BLACK_HOLE } from '@principia/scenes';
import { Synth } from '@principia/shell';
import type { GameEvent } from './rules.ts';
import type { BlackHoleGame } from './sim.ts';

/** Steps between two puffs of the engine. */
const PUFF_STEPS = 11;
/** A major chord for a goal, Hz. */
const CHORD = [523, 659, 784];

export interface Sounds {
  play(event: GameEvent): void;
  /** Call it once a frame. */
  update(sim: BlackHoleGame, on: boolean): void;
  destroy(): void;
}

export function createSounds(): Sounds {
  const synth = new Synth();
  /** Step of the last puff. */
  let lastPuff = 0;
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
    update({ rules, world }, on) {
      synth.set(on);
      if (!synth.isAudible) return;
      const { push } = rules;
      // A rewind leads to steps before the last puff.
      const isDue = Math.abs(world.tick - lastPuff) >= PUFF_STEPS;
      if (push === undefined || !rules.hasFuel || rules.phase !== 'flying' || !isDue) return;
      lastPuff = world.tick;
      puff(synth, Math.hypot(push.x, push.y));
    },
    destroy: () => synth.destroy(),
  };
}

function puff(synth: Synth, strength: number): void {
  synth.noise({ frequency: 170 + 90 * strength, to: 90, loudness: 0.09 * strength, seconds: 0.16 });
}
