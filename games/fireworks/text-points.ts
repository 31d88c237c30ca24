/**
 * Turns a text or an emoji into places of stars: it is drawn to a small canvas and sampled on a grid. The same pixels give
 * the same stars.
 */
import { MAX_TEXT_STARS, STAR_RGB } from '@principia/scenes';

/** Most characters of a text: with more, stars would be too far apart to read it. */
export const MAX_CHARACTERS = 12;

/** Pixels of an image: RGBA, row after row. */
export interface Pixels {
  readonly width: number;
  readonly height: number;
  readonly data: ArrayLike<number>;
}

/** Height of a letter, pixels. */
const LETTER = 56;
/** Opacity from which a pixel counts, and the brightest channel below which it is left dark, as the eyes of a face. */
const [MIN_ALPHA, MIN_BRIGHTNESS] = [120, 70];

/** The places of a text's stars, as in `ShellOrder`; none where the text leaves no mark. */
export function textPoints(text: string): number[] {
  const canvas = document.createElement('canvas');
  const font = `bold ${LETTER}px system-ui, "Noto Color Emoji", "Apple Color Emoji", sans-serif`;
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (context === null) return [];
  context.font = font;
  canvas.width = Math.ceil(context.measureText(text).width) + LETTER;
  canvas.height = 2 * LETTER;
  // A change of size resets the context.
  context.font = font;
  context.textBaseline = 'middle';
  context.fillStyle = '#fff';
  context.fillText(text, LETTER / 2, LETTER);
  return samplePoints(context.getImageData(0, 0, canvas.width, canvas.height));
}

/** Samples pixels on the finest grid that needs no more than `MAX_TEXT_STARS` stars. */
export function samplePoints(image: Pixels): number[] {
  for (let spacing = 2; spacing < image.width + image.height; spacing += 0.5) {
    const marks = sampleGrid(image, spacing);
    if (marks.length / 3 <= MAX_TEXT_STARS) return centred(marks);
  }
  return [];
}

/** Column, row and colour of each grid place that is drawn on. */
function sampleGrid({ width, height, data }: Pixels, spacing: number): number[] {
  const marks: number[] = [];
  for (let y = spacing / 2; y < height; y += spacing) {
    for (let x = spacing / 2; x < width; x += spacing) {
      const at = 4 * (Math.floor(y) * width + Math.floor(x));
      const [red, green, blue, alpha] = [data[at], data[at + 1], data[at + 2], data[at + 3]];
      if (alpha < MIN_ALPHA || Math.max(red, green, blue) < MIN_BRIGHTNESS) continue;
      marks.push(x, y, colorOf(red, green, blue));
    }
  }
  return marks;
}

/** Index of the most similar colour of a star; −1 for white, the colour of letters, which takes the chosen one. */
function colorOf(red: number, green: number, blue: number): number {
  if (Math.min(red, green, blue) > 240) return -1;
  let [best, least] = [-1, Number.POSITIVE_INFINITY];
  for (const [i, rgb] of STAR_RGB.entries()) {
    const [r, g, b] = [red - (rgb >> 16), green - ((rgb >> 8) & 255), blue - (rgb & 255)];
    const distance = r * r + g * g + b * b;
    if (distance < least) [best, least] = [i, distance];
  }
  return best;
}

/** Moves the middle of the marks to the origin and scales them to the unit circle, y upwards, in steps of 1/500. */
function centred(marks: readonly number[]): number[] {
  const [low, high] = [
    [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY],
    [Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY],
  ];
  for (let i = 0; i < marks.length; i += 3) {
    for (const axis of [0, 1]) {
      low[axis] = Math.min(low[axis], marks[i + axis]);
      high[axis] = Math.max(high[axis], marks[i + axis]);
    }
  }
  const [middleX, middleY] = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
  let radius = 1;
  for (let i = 0; i < marks.length; i += 3) {
    radius = Math.max(radius, Math.hypot(marks[i] - middleX, marks[i + 1] - middleY));
  }
  const round = (value: number) => Math.round((500 * value) / radius) / 500 + 0;
  return marks.map((value, i) => (i % 3 === 2 ? value : round(i % 3 === 0 ? value - middleX : middleY - value)));
}
