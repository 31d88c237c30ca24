/** The sounds of the game's events, the rumble of the engine, and the hum of tides. */

import { BLACK_HOLE } from '@principia/scenes';
import { Synth } from '@principia/shell';
import type { GameEvent } from './rules.ts';
import type { BlackHoleGame } from './sim.ts';
import { type Hum, hearHole } from './tidal-hum.ts';

/** Steps between two puffs of the engine. */
const PUFF_STEPS = 11;
/** Steps between two grains of the hum, s of each, and the loudness below which there is none. */
const [GRAIN_STEPS, GRAIN_SECONDS, QUIETEST] = [10, 0.3, 0.02];
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
  const hum = createHum(synth);
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
    update(sim, on) {
      synth.set(on);
      if (!synth.isAudible) return;
      hum(sim);
      const { rules, world } = sim;
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

/** Plays grains of a tone that follows the ship, each from the pitch of the last one to its own. */
function createHum(synth: Synth): (sim: BlackHoleGame) => void {
  const heard: Hum = { loudness: 0, frequency: 0 };
  const ship = { x: 0, y: 0, vx: 0, vy: 0 };
  let last = 0;
  let pitch = 0;
  return ({ rules, scene, world }) => {
    if (rules.phase !== 'flying') pitch = 0;
    if (rules.phase !== 'flying' || Math.abs(world.tick - last) < GRAIN_STEPS) return;
    last = world.tick;
    const { Position, Velocity } = world.components;
    [ship.x, ship.y] = [Position.x[scene.ship], Position.y[scene.ship]];
    [ship.vx, ship.vy] = [Velocity.x[scene.ship], Velocity.y[scene.ship]];
    heard.loudness = 0;
    for (const [i, id] of scene.holeIds.entries())
      hearHole(heard, ship, Position.x[id], Position.y[id], scene.holes[i].radius);
    const frequency = Math.max(20, heard.frequency);
    if (heard.loudness > QUIETEST) {
      const pan = (2 * ship.x) / BLACK_HOLE.width - 1;
      const shape = { loudness: heard.loudness, seconds: GRAIN_SECONDS, pan, wave: 'triangle' } as const;
      synth.tone({ ...shape, frequency: pitch === 0 ? frequency : pitch, to: frequency });
    }
    pitch = frequency;
  };
}
