/** A picture of the player's that is printed on the cloth. It stays in the page: nothing is sent anywhere. */
import { CLOTH } from './sim.ts';
import { WORDS } from './words.ts';

/** Pixels between two threads. */
const SCALE = 16;
export const PRINT_WIDTH = SCALE * (CLOTH.columns - 1);
export const PRINT_HEIGHT = SCALE * (CLOTH.rows - 1);

export class ClothPrint {
  /** The picture, cut to the shape of the cloth; undefined without one. */
  canvas: HTMLCanvasElement | undefined;
  /** Incremented by every change. */
  version = 0;
  #pixels: Uint8ClampedArray | undefined;
  /** Incremented by every request, so that the last one wins. */
  #requests = 0;

  /** Prints a file. @throws Error with a sentence where the browser cannot show it */
  async load(file: File): Promise<void> {
    const request = ++this.#requests;
    const image = await createImageBitmap(file).catch(() => {
      throw new Error(WORDS.noPicture(file.name));
    });
    if (request === this.#requests) this.#print(image);
    image.close();
  }

  clear(): void {
    this.#requests++;
    this.canvas = undefined;
    this.#pixels = undefined;
    this.version++;
  }

  /** The colour at a part of the width and of the height from the upper left corner, 0 to 1 each: red, green, blue, 0 to 1. */
  colorAt(across: number, down: number): readonly [number, number, number] | undefined {
    const pixels = this.#pixels;
    if (pixels === undefined) return undefined;
    const x = Math.min(PRINT_WIDTH - 1, Math.floor(across * PRINT_WIDTH));
    const y = Math.min(PRINT_HEIGHT - 1, Math.floor(down * PRINT_HEIGHT));
    const at = 4 * (y * PRINT_WIDTH + x);
    return [pixels[at] / 255, pixels[at + 1] / 255, pixels[at + 2] / 255];
  }

  /** Fills the cloth with the middle of the picture, on white where it is transparent. */
  #print(image: ImageBitmap): void {
    const canvas = document.createElement('canvas');
    canvas.width = PRINT_WIDTH;
    canvas.height = PRINT_HEIGHT;
    const context = canvas.getContext('2d', { willReadFrequently: true });
    if (context === null) throw new Error(WORDS.noMemory);
    context.fillStyle = '#fff';
    context.fillRect(0, 0, PRINT_WIDTH, PRINT_HEIGHT);
    const scale = Math.max(PRINT_WIDTH / image.width, PRINT_HEIGHT / image.height);
    const [width, height] = [scale * image.width, scale * image.height];
    context.drawImage(image, (PRINT_WIDTH - width) / 2, (PRINT_HEIGHT - height) / 2, width, height);
    this.#pixels = context.getImageData(0, 0, PRINT_WIDTH, PRINT_HEIGHT).data;
    this.canvas = canvas;
    this.version++;
  }
}
