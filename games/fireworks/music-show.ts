/** A show for music: a shell bursts on every beat, the larger the louder. */
import { createRandom } from '@principia/physics';
import { FIREWORKS_SKY, STAR_COLORS } from '@principia/scenes';
import type { Beat } from './beats.ts';
import type { Cue } from './sim.ts';

const STEPS_PER_SECOND = 60;
/** Kinds that burst at once and are gone soon: peony, ring, crackle and palm; and willow on the strongest beats. */
const [KINDS, STRONG_KIND] = [[0, 2, 3, 4], 1];
/** Steps that a shell takes to 30 m, by which it is launched before its beat; and those of each further metre. */
const [FLIGHT, FLIGHT_PER_METRE] = [146, 2.2];

/** Steps from the launch of a shell to its burst. @param y height of the burst, m */
export const flightSteps = (y: number) => FLIGHT + FLIGHT_PER_METRE * (y - 30);

/** @param seed of the choice of kinds, colours and places */
export function composeShow(beats: readonly Beat[], seed: number): Cue[] {
  const random = createRandom(seed, 3);
  const cues = beats.map(({ time, strength }, i) => {
    const side = i % 2 === 0 ? 1 : -1;
    const x = side * random.uniform(0.05, 0.8) * FIREWORKS_SKY.halfWidth;
    const y = random.uniform(26, 44);
    const kind =
      strength > 0.9 && random.uniform(0, 1) < 0.4 ? STRONG_KIND : KINDS[random.integer(0, KINDS.length - 1)];
    const color = random.integer(0, STAR_COLORS.length - 1);
    return {
      tick: Math.round(STEPS_PER_SECOND * time - flightSteps(y)),
      x,
      y,
      z: 0,
      kind,
      color,
      power: 0.15 + 0.4 * strength,
    };
  });
  // What would have to fly before the music begins is left out.
  return cues.filter(({ tick }) => tick >= 0).sort((a, b) => a.tick - b.tick);
}
