/** The colours that carry meaning: the ship, the goal and danger. */
import type { WORDS } from './words.ts';

export interface Palette {
  readonly hull: number;
  readonly hullShade: number;
  readonly trail: number;
  /** The goal line and successes. */
  readonly goal: number;
  /** Name of the goal's colour. */
  readonly goalName: keyof typeof WORDS.goal;
  /** A fall into a hole. */
  readonly fall: number;
  readonly path: number;
  /** Lower edge of the zone of holes. */
  readonly zone: number;
}

const DEFAULT: Palette = {
  hull: 0xff4d57,
  hullShade: 0x9c1634,
  trail: 0xff8f5c,
  goal: 0x7dffb0,
  goalName: 'green',
  fall: 0xff3b4a,
  path: 0x9fd0ff,
  zone: 0x7fc4ff,
};

/**
 * Okabe and Ito's palette: sky blue for the goal and vermillion for a fall differ for all kinds of colour vision; the
 * ship is yellow.
 */
const COLOR_BLIND_SAFE: Palette = {
  hull: 0xf0e442,
  hullShade: 0xe69f00,
  trail: 0xe69f00,
  goal: 0x56b4e9,
  goalName: 'blue',
  fall: 0xd55e00,
  path: 0xffffff,
  zone: 0xcc79a7,
};

export function paletteOf(isSafe: boolean): Palette {
  return isSafe ? COLOR_BLIND_SAFE : DEFAULT;
}

export function css(color: number): string {
  return `#${color.toString(16).padStart(6, '0')}`;
}
