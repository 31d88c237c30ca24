import type { FireworksGame } from './sim.ts';

/** Length of a frame in which a spark leaves all its light, s. */
const FRAME = 1 / 60;
/** Light of a spark in such a frame: what is drawn adds up while it fades. */
const EXPOSURE = 0.5;
/** Sparks from which on the eye narrows: a sky full of light is not seen as white. */
const DAZZLING = 5000;

/** How light fades and is added: by the world's time, so that a pause keeps it and slow motion slows it. */
export class LightClock {
  /** The share of the former light that is left. */
  fade = 0;
  /** Factor of the light that is added, so that sparks are as bright whatever the length of a frame. */
  gain = EXPOSURE;
  #last = Number.NaN;

  reset(): void {
    this.#last = Number.NaN;
  }

  /**
   * @param glow time in which light falls to 1/e, s
   * @returns whether time went by; if not, no light is to be added
   */
  advance({ scene, world, dt }: FireworksGame, alpha: number, glow: number): boolean {
    const now = world.time + (alpha - 1) * dt;
    const passed = now - this.#last;
    if (passed === 0) return false;
    this.#last = now;
    const dazzled = 1 / (1 + scene.alive / DAZZLING);
    const hasTrail = passed > 0 && glow > 0;
    this.fade = hasTrail ? Math.exp(-passed / glow) : 0;
    this.gain = EXPOSURE * dazzled * (hasTrail ? (1 - this.fade) / (1 - Math.exp(-FRAME / glow)) : 2);
    return true;
  }
}
