import type { FilmOverlay } from './film-overlay.ts';
import { words } from './words.ts';

// Screenshots of a game: the canvas drawn over the page's background.

/** The background of every game; equal to that of the style sheet. */
const BACKGROUND = [
  [0, '#2c3a72'],
  [0.45, '#1a2349'],
  [1, '#0d1226'],
] as const;

/**
 * Draws a canvas over the background; call it right after the canvas was drawn, before the browser clears it.
 * @param overlay paints what lies over it
 */
export function drawOverBackground(source: HTMLCanvasElement, target: HTMLCanvasElement, overlay?: FilmOverlay): void {
  const { width, height } = target;
  const context = target.getContext('2d', { alpha: false });
  if (context === null) throw new Error(words().noMemory);
  const gradient = context.createRadialGradient(0.42 * width, 0.12 * height, 0, 0.42 * width, 0.12 * height, width);
  for (const [at, color] of BACKGROUND) gradient.addColorStop(at, color);
  context.fillStyle = gradient;
  context.fillRect(0, 0, width, height);
  context.drawImage(source, 0, 0, width, height);
  overlay?.(target, source);
}

/**
 * A canvas of the same size as another, rounded to even numbers because video encoders require them.
 * @param maxSide scales a larger one down so that its longer side has this length, pixels
 */
export function canvasLike(
  { width, height }: HTMLCanvasElement,
  maxSide = Number.POSITIVE_INFINITY,
): HTMLCanvasElement {
  const scale = Math.min(1, maxSide / Math.max(width, height, 1));
  const made = document.createElement('canvas');
  made.width = Math.max(2, Math.round(scale * width) & ~1);
  made.height = Math.max(2, Math.round(scale * height) & ~1);
  return made;
}

/** Encodes the picture as a PNG file. */
export async function screenshotPng(source: HTMLCanvasElement): Promise<Blob> {
  const copy = canvasLike(source);
  drawOverBackground(source, copy);
  const blob = await new Promise<Blob | null>((done) => copy.toBlob(done, 'image/png'));
  if (blob === null) throw new Error(words().noPng);
  return blob;
}

/** Offers a file to the player as a download. */
export function download(blob: Blob, name: string): void {
  const url = URL.createObjectURL(blob);
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  // The browser reads the file asynchronously.
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}

/** `Black hole` at 12.34 s: `black-hole-12.3s.png`. */
export function fileName(title: string, time: number, extension: string): string {
  const words = title.toLowerCase().replace(/[^\p{L}\p{N}]+/gu, '-');
  return `${words}-${time.toFixed(1)}s.${extension}`;
}
