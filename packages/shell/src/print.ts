// Pictures and films of a game: what the canvas shows over the page's ground.

/** The ground below every game, as the style sheet has it. */
const GROUND = [
  [0, '#2c3a72'],
  [0.45, '#1a2349'],
  [1, '#0d1226'],
] as const;

/** Draws a canvas over the ground; call it right after the canvas was drawn, before the browser clears it. */
export function printCanvas(source: HTMLCanvasElement, target: HTMLCanvasElement): void {
  const { width, height } = target;
  const context = target.getContext('2d', { alpha: false });
  if (context === null) throw new Error('The browser has no memory left for a picture: close other pages.');
  const ground = context.createRadialGradient(0.42 * width, 0.12 * height, 0, 0.42 * width, 0.12 * height, width);
  for (const [at, color] of GROUND) ground.addColorStop(at, color);
  context.fillStyle = ground;
  context.fillRect(0, 0, width, height);
  context.drawImage(source, 0, 0, width, height);
}

/** A canvas with as many pixels as another; films want even numbers. */
export function canvasLike({ width, height }: HTMLCanvasElement): HTMLCanvasElement {
  const made = document.createElement('canvas');
  made.width = Math.max(2, width & ~1);
  made.height = Math.max(2, height & ~1);
  return made;
}

/** The picture as a PNG file. */
export async function picturePng(source: HTMLCanvasElement): Promise<Blob> {
  const copy = canvasLike(source);
  printCanvas(source, copy);
  const blob = await new Promise<Blob | null>((done) => copy.toBlob(done, 'image/png'));
  if (blob === null) throw new Error('The picture could not be stored: the window may be too large or too small.');
  return blob;
}

/** Hands a file to the player. */
export function download(blob: Blob, name: string): void {
  const url = URL.createObjectURL(blob);
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  // The browser reads the file a little later.
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}

/** `Black hole` at 12.34 s: `black-hole-12.3s.png`. */
export function fileName(title: string, time: number, ending: string): string {
  const words = title.toLowerCase().replace(/[^a-z0-9]+/g, '-');
  return `${words}-${time.toFixed(1)}s.${ending}`;
}
