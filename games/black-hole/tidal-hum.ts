/**
 * What the ship sounds like to a listener far away: its frame hums, the louder the more tides strain it, and the deeper the
 * nearer it is to a horizon.
 */
import { BLACK_HOLE } from '@principia/scenes';

/** Pitch far from every hole, Hz. */
const PITCH = 150;
/** Loudness at a horizon. */
const LOUDEST = 0.4;
/** Speeds of a ship are taken as this part of that of light at most: it may fly faster in the game. */
const FASTEST = 0.9;

/** Difference of gravity between two points at a distance, by that at the horizon: it falls with 1/r³. */
export const tideAt = (distance: number, radius: number): number => (radius / Math.max(radius, distance)) ** 3;

/**
 * Ratio of the frequency that is heard far away to that of a ship near a horizon: √(1 − r_s/r) by gravity (Misner, Thorne and
 * Wheeler, Gravitation, section 25.4), and by the classical Doppler effect 1/(1 + v/c).
 * @param recession speed towards the hole and so away from the listener, m/s
 */
export function frequencyRatio(distance: number, radius: number, recession: number): number {
  const { lightSpeed } = BLACK_HOLE;
  const speed = Math.min(FASTEST, Math.max(-FASTEST, recession / lightSpeed));
  return Math.sqrt(Math.max(0, 1 - radius / distance)) / (1 + speed);
}

export interface Hum {
  /** 0 to 1. */
  loudness: number;
  /** Hz. */
  frequency: number;
}

interface Motion {
  readonly x: number;
  readonly y: number;
  readonly vx: number;
  readonly vy: number;
}

/** Takes a hole into account, if its tides are stronger than those before. @param hum without loudness at first */
export function hearHole(hum: Hum, ship: Motion, holeX: number, holeY: number, radius: number): void {
  const [dx, dy] = [holeX - ship.x, holeY - ship.y];
  const distance = Math.hypot(dx, dy);
  const loudness = LOUDEST * Math.sqrt(tideAt(distance, radius));
  if (!(loudness > hum.loudness)) return;
  hum.loudness = loudness;
  hum.frequency = PITCH * frequencyRatio(distance, radius, (ship.vx * dx + ship.vy * dy) / distance);
}
