import type { FireworksGame } from './sim.ts';

/** Reference length of a frame, s. */
const REFERENCE_FRAME = 1 / 60;
/** Light of a spark in such a frame; light accumulates while it fades. */
const EXPOSURE = 0.5;
/** Number of sparks at which exposure is halved, so that a sky full of light does not saturate to white. */
const GLARE_COUNT = 5000;

/** Computes how light fades and accumulates in simulated time, so that a pause keeps it and slow motion slows it. */
export class LightClock {
  /** Fraction of the previous light that remains. */
  fade = 0;
  /** Factor of new light, chosen so that the brightness of sparks does not depend on the frame rate. */
  gain = EXPOSURE;
  #last = Number.NaN;

  reset(): void {
    this.#last = Number.NaN;
  }

  /**
   * @param glow decay time of light to 1/e, s
   * @returns whether time has passed; if not, no light is to be added
   */
  advance({ scene, world, dt }: FireworksGame, alpha: number, glow: number): boolean {
    const now = world.time + (alpha - 1) * dt;
    const passed = now - this.#last;
    if (passed === 0) return false;
    this.#last = now;
    const dazzled = 1 / (1 + scene.alive / GLARE_COUNT);
    const hasTrail = passed > 0 && glow > 0;
    this.fade = hasTrail ? Math.exp(-passed / glow) : 0;
    this.gain = EXPOSURE * dazzled * (hasTrail ? (1 - this.fade) / (1 - Math.exp(-REFERENCE_FRAME / glow)) : 2);
    return true;
  }
}
