/** Paints the surfaces of the bodies: seeded noise on a sphere, so that no seam shows. */
import { createRandom } from '@principia/physics';
import { CanvasTexture, Color, SRGBColorSpace } from 'three';
import type { Look } from './bodies.ts';

const WIDTH = 256;
const HEIGHT = 128;
const GRID = 16;

/** Smooth noise of three coordinates, −1 to 1. */
function createNoise(seed: number): (x: number, y: number, z: number) => number {
  const random = createRandom(seed, 7);
  const values = Float32Array.from({ length: GRID ** 3 }, () => random.uniform(-1, 1));
  const at = (x: number, y: number, z: number) =>
    values[((x & (GRID - 1)) * GRID + (y & (GRID - 1))) * GRID + (z & (GRID - 1))];
  const mix = (a: number, b: number, t: number) => a + (b - a) * t;
  const smooth = (t: number) => t * t * (3 - 2 * t);
  return (x, y, z) => {
    const [i, j, k] = [Math.floor(x), Math.floor(y), Math.floor(z)];
    const [u, v, w] = [smooth(x - i), smooth(y - j), smooth(z - k)];
    const edge = (b: number, c: number) => mix(at(i, b, c), at(i + 1, b, c), u);
    return mix(mix(edge(j, k), edge(j + 1, k), v), mix(edge(j, k + 1), edge(j + 1, k + 1), v), w);
  };
}

/** Sum of noises of rising frequency, about −1 to 1. */
function rough(noise: (x: number, y: number, z: number) => number, x: number, y: number, z: number): number {
  let sum = 0;
  for (let octave = 0, size = 1, frequency = 1; octave < 4; octave++, size *= 0.5, frequency *= 2) {
    sum += size * noise(frequency * x + 7 * octave, frequency * y, frequency * z);
  }
  return sum / 1.2;
}

export function paintSurface(look: Look, seed: number): CanvasTexture {
  const canvas = document.createElement('canvas');
  canvas.width = WIDTH;
  canvas.height = HEIGHT;
  const context = canvas.getContext('2d', { willReadFrequently: true }) as CanvasRenderingContext2D;
  const image = context.createImageData(WIDTH, HEIGHT);
  const noise = createNoise(seed);
  const colors = look.surface.map((color) => new Color(color).convertLinearToSRGB());
  for (let row = 0, i = 0; row < HEIGHT; row++) {
    const latitude = Math.PI * ((row + 0.5) / HEIGHT - 0.5);
    for (let column = 0; column < WIDTH; column++, i += 4) {
      const longitude = (2 * Math.PI * column) / WIDTH;
      const x = Math.cos(latitude) * Math.cos(longitude);
      const y = Math.cos(latitude) * Math.sin(longitude);
      const z = Math.sin(latitude);
      const height = look.isBanded
        ? band(noise, x, y, z)
        : 0.5 + 0.5 * rough(noise, 2.4 * x + 9, 2.4 * y + 9, 2.4 * z + 9);
      // Ice at the poles, where ice is the lightest colour.
      const ice = colors.length > 3 && !look.isBanded && Math.abs(z) > 0.93 + 0.05 * height ? 1 : 0;
      write(image.data, i, colors, Math.max(ice, Math.min(0.999, Math.max(0, height))));
    }
  }
  context.putImageData(image, 0, 0);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}

/** Bands along circles of latitude, with eddies. */
function band(noise: (x: number, y: number, z: number) => number, x: number, y: number, z: number): number {
  const eddy = rough(noise, 3 * x + 5, 3 * y + 5, 6 * z + 5);
  return 0.5 + 0.45 * Math.sin(17 * z + 1.1 * eddy) * (1 - 0.5 * z * z) + 0.12 * eddy;
}

function write(data: Uint8ClampedArray, i: number, colors: readonly Color[], height: number): void {
  const place = height * (colors.length - 1);
  const first = Math.min(colors.length - 2, Math.floor(place));
  const share = place - first;
  const [a, b] = [colors[first], colors[first + 1]];
  data[i] = 255 * (a.r + share * (b.r - a.r));
  data[i + 1] = 255 * (a.g + share * (b.g - a.g));
  data[i + 2] = 255 * (a.b + share * (b.b - a.b));
  data[i + 3] = 255;
}
