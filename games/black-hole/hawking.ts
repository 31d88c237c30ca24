/**
 * Decorative Hawking radiation: a hole of mass M has the temperature T = ħ c³/(8π G M k) and radiates the power
 * P ∝ 1/M². In this game masses are proportional to radii, so the smallest hole is three times as hot as the largest
 * and emits nine times as many sparks. The sparks do not affect the game.
 */
import type { HoleTable } from './sky-view.ts';
import type { Sparks } from './sparks.ts';

/** Sparks per second from a hole of radius `REFERENCE`, m. */
const RATE = 80;
const REFERENCE = 10;
/** Black-body colours, from hot to cool. */
const TINTS = [0xa9c8ff, 0xe8efff, 0xfff0d0, 0xffd296, 0xffa860, 0xff7d45];

/** Emits the sparks of all holes for `seconds`. */
export function emitGlow({ values, count }: HoleTable, seconds: number, { source, random, burst }: Sparks): void {
  for (let i = 0; i < count; i++) {
    const x = values[4 * i];
    const y = values[4 * i + 1];
    const r = values[4 * i + 2];
    if (!(r > 0)) continue;
    const expected = RATE * (REFERENCE / r) ** 2 * Math.min(seconds, 0.25);
    const sparks = Math.floor(expected) + (random.uniform() < expected % 1 ? 1 : 0);
    const cool = Math.min(TINTS.length - 1, Math.max(0, Math.round((r / REFERENCE - 1) * 2.5)));
    for (let s = 0; s < sparks; s++) {
      const angle = random.uniform(0, 2 * Math.PI);
      const dx = Math.cos(angle);
      const dy = Math.sin(angle);
      const speed = random.uniform(18, 40);
      source[0] = x + 1.1 * r * dx;
      source[1] = y + 1.1 * r * dy;
      source[2] = speed * dx;
      source[3] = speed * dy;
      if (!isSwallowed(values, count, source)) burst(1, 5, TINTS[cool]);
    }
  }
}

/** Sparks of one hole may start inside another. */
function isSwallowed(values: Float32Array, count: number, place: Float64Array): boolean {
  for (let i = 0; i < count; i++) {
    const dx = values[4 * i] - place[0];
    const dy = values[4 * i + 1] - place[1];
    if (dx * dx + dy * dy < values[4 * i + 2] ** 2) return true;
  }
  return false;
}
