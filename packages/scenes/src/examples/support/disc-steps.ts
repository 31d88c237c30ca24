/** A disc that takes a step of 2 px at each tick of a clock or of a display: the animations of chapter 2. */
import { COLORS, type Color, type Picture } from '../picture.ts';

const [START, STEP, WIDTH] = [50, 2, 600];

/** Where the disc is after a number of steps, px. */
export const placeAfter = (steps: number): number => START + STEP * steps;

/** The disc on its line, from the left again where it would leave; `text` stands below. */
export function discOnLine(x: () => number, color: Color, text: () => string): Picture {
  return {
    yDown: true,
    view: { minX: 0, maxX: 700, minY: 120, maxY: 380 },
    lines: [{ from: { x: 0, y: 275 }, to: { x: 700, y: 275 }, color: COLORS.ground }],
    dots: [{ at: () => ({ x: START + ((x() - START) % WIDTH), y: 250 }), radius: 20, color }],
    labels: [{ at: { x: 30, y: 340 }, text }],
  };
}
