/**
 * Finds the beats of music: moments at which its energy rises above what it has been.
 * Onsets of energy as in Bello and others, A Tutorial on Onset Detection in Music Signals, IEEE Transactions on Speech and
 * Audio Processing 13, 1035 (2005), sections III A and IV.
 */

/** Samples between two values of energy, by the rate: 86 values a second at 44.1 kHz. */
const HOP_SECONDS = 1 / 86;
/** Window of the mean around a beat, s, by which factor a beat is louder than that, and its least share of the loudest rise. */
const [WINDOW_SECONDS, FACTOR, FLOOR] = [1.2, 1.6, 0.06];
/** Shortest time between two beats, s. */
export const MIN_GAP = 0.28;

export interface Beat {
  /** Seconds from the start. */
  readonly time: number;
  /** Loudness compared with the strongest beat, 0 to 1. */
  readonly strength: number;
}

/** @param samples of one channel, −1 to 1 @param rate samples per second */
export function findBeats(samples: Float32Array, rate: number): Beat[] {
  const hop = Math.max(1, Math.round(HOP_SECONDS * rate));
  const rises = energyRises(samples, hop);
  const reach = Math.round(WINDOW_SECONDS / 2 / (hop / rate));
  let largest = 0;
  for (const rise of rises) largest = Math.max(largest, rise);
  if (largest === 0) return [];
  const beats: Beat[] = [];
  let last = Number.NEGATIVE_INFINITY;
  for (let i = 0; i < rises.length; i++) {
    const time = (i * hop) / rate;
    const isPeak = rises[i] >= (rises[i - 1] ?? 0) && rises[i] > (rises[i + 1] ?? 0);
    const isLoud = rises[i] > FLOOR * largest && rises[i] > FACTOR * meanAbout(rises, i, reach);
    if (!isPeak || !isLoud || time < last + MIN_GAP) continue;
    beats.push({ time, strength: Math.sqrt(rises[i] / largest) });
    last = time;
  }
  return beats;
}

/** How much the energy of each hop exceeds that of the one before. */
function energyRises(samples: Float32Array, hop: number): Float64Array {
  const rises = new Float64Array(Math.floor(samples.length / hop));
  let before = 0;
  for (let i = 0; i < rises.length; i++) {
    let energy = 0;
    for (let k = i * hop; k < (i + 1) * hop; k++) energy += samples[k] * samples[k];
    rises[i] = Math.max(0, energy - before);
    before = energy;
  }
  return rises;
}

function meanAbout(values: Float64Array, at: number, reach: number): number {
  const [from, to] = [Math.max(0, at - reach), Math.min(values.length, at + reach + 1)];
  let sum = 0;
  for (let i = from; i < to; i++) sum += values[i];
  return sum / (to - from);
}
