import { step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { findBeats, MIN_GAP } from './beats.ts';
import { composeShow } from './music-show.ts';
import { createGame } from './sim.ts';

const RATE = 8000;

/** Drum strokes that fade within 50 ms at the given times, over a steady tone. */
function drums(times: readonly number[], seconds: number, tone = 0.05): Float32Array {
  return Float32Array.from({ length: RATE * seconds }, (_, i) => {
    const t = i / RATE;
    const strokes = times.map((start) => (t < start ? 0 : Math.exp(-(t - start) / 0.05)));
    return tone * Math.sin(1500 * t) + 0.8 * Math.sin(700 * t) * Math.max(...strokes);
  });
}

describe('beats', () => {
  it('are where the drum is struck, to two hops of 1/86 s', () => {
    const times = [0.5, 1, 1.5, 2, 2.5, 3.25, 4];
    const beats = findBeats(drums(times, 5), RATE);
    expect(beats).toHaveLength(times.length);
    for (const [i, { time }] of beats.entries()) expect(Math.abs(time - times[i])).toBeLessThan(2 / 86);
  });

  it('keep their distance, and a steady tone or silence has none after its start', () => {
    const fast = Array.from({ length: 40 }, (_, i) => 0.3 + i * 0.1);
    const beats = findBeats(drums(fast, 5), RATE);
    for (let i = 1; i < beats.length; i++) expect(beats[i].time - beats[i - 1].time).toBeGreaterThanOrEqual(MIN_GAP);
    expect(findBeats(new Float32Array(RATE), RATE)).toEqual([]);
    expect(findBeats(new Float32Array(0), RATE)).toEqual([]);
  });
});

describe('a show for music', () => {
  const beats = [0.1, 3, 3.5, 4, 6].map((time) => ({ time, strength: 0.5 }));

  it('launches each shell so that it bursts on its beat, to a tenth of a second', () => {
    const cues = composeShow(beats, 7);
    // The first beat comes before a shell could have flown.
    expect(cues).toHaveLength(4);
    const values = { wind: 0, barrage: false, sparks: 1000 };
    const game = createGame({ values, seed: 1, dimensions: 2, opening: cues });
    const bursts: number[] = [];
    for (let seen = 0; game.world.time < 7; ) {
      step(game.world, game.dt);
      const { events } = game.scene;
      for (; seen < events.count; seen++) if (events.at(seen).type === 'burst') bursts.push(events.at(seen).time);
    }
    expect(bursts).toHaveLength(4);
    for (const [i, { time }] of beats.slice(1).entries()) expect(Math.abs(bursts[i] - time)).toBeLessThan(0.1);
  });

  it('is the same for the same seed, and another for another', () => {
    expect(composeShow(beats, 7)).toEqual(composeShow(beats, 7));
    expect(composeShow(beats, 8)).not.toEqual(composeShow(beats, 7));
  });
});
