/** Colours of the bodies: by height in the build, so that one sees where a body came from. */
import { bodies, rgba } from '@principia/physics';
import { SAFE_COLORS } from '@principia/shell';
import type { StackingRun } from './sim.ts';

/** From the ground up. */
const PALETTES: readonly (readonly number[])[] = [
  [0xff7a59, 0xffc15e, 0x7be0ad, 0x38d6c4, 0x5b8cff, 0xb45cf0],
  [0xf9506b, 0xff9f45, 0xffcf56, 0xfff3b0, 0x9bf6ff, 0xa0c4ff],
  [0x9b7bff, 0x5b8cff, 0x3bb3c2, 0x7be0ad, 0xffd166, 0xf27bd0],
];

export function applyColors({ world, ground }: StackingRun, seed: number, safeColors: boolean): void {
  const palette = safeColors ? SAFE_COLORS : PALETTES[seed % PALETTES.length];
  const { Position, Appearance } = world.components;
  const { ids, count } = bodies(world);
  const heights = Array.from(ids.subarray(0, count), (id) => Position.y[id]);
  const top = Math.max(1e-6, ...heights);
  for (let i = 0; i < count; i++) {
    if (ids[i] === ground) continue;
    const color = palette[Math.min(palette.length - 1, Math.floor((heights[i] / top) * palette.length))];
    Appearance.color[ids[i]] = rgba(((color >> 16) & 255) / 255, ((color >> 8) & 255) / 255, (color & 255) / 255);
  }
  world.versions.style++;
}
