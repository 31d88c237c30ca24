/** Paints the star sky: stars and faint clouds on a square texture that repeats mirrored. */
import { createRandom } from '@principia/physics';
import { Texture } from 'pixi.js';

/** Edge of the square, pixels. */
const SIZE = 2048;
/** Edge of the square on the stage, m. */
export const SKY_METRES = 1300;

const TINTS = ['#ffffff', '#dfe8ff', '#b9cdff', '#ffe9cf', '#ffd0a8', '#ffffff'];
const CLOUDS = ['58, 70, 160', '112, 52, 140', '30, 96, 132', '150, 70, 80'];

/** A canvas in main memory: on the GPU, the gradients would have to compile shaders first, which delays the start. */
function canvasOf(size: number): [HTMLCanvasElement, CanvasRenderingContext2D] {
  const canvas = document.createElement('canvas');
  canvas.width = size;
  canvas.height = size;
  return [canvas, canvas.getContext('2d', { willReadFrequently: true }) as CanvasRenderingContext2D];
}

export function paintSky(seed: number): Texture {
  const [canvas, context] = canvasOf(SIZE);
  const random = createRandom(seed, 3);
  context.fillStyle = '#04060e';
  context.fillRect(0, 0, SIZE, SIZE);
  context.globalCompositeOperation = 'lighter';
  for (let i = 0; i < 46; i++) {
    const [x, y, r] = [random.uniform(0, SIZE), random.uniform(0, SIZE), random.uniform(140, 420)];
    const glow = context.createRadialGradient(x, y, 0, x, y, r);
    glow.addColorStop(0, `rgba(${CLOUDS[i % CLOUDS.length]}, ${random.uniform(0.06, 0.2)})`);
    glow.addColorStop(1, 'rgba(0, 0, 0, 0)');
    context.fillStyle = glow;
    context.fillRect(x - r, y - r, 2 * r, 2 * r);
  }
  context.globalAlpha = 1;
  for (let i = 0; i < 2000; i++) {
    // Few stars are bright, as in the real sky.
    const light = random.uniform() ** 4;
    const radius = 0.6 + 1.9 * light;
    const [x, y] = [random.uniform(0, SIZE), random.uniform(0, SIZE)];
    context.globalAlpha = 0.25 + 0.75 * light;
    context.fillStyle = TINTS[random.integer(0, TINTS.length - 1)];
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fill();
    if (light < 0.5) continue;
    const glow = context.createRadialGradient(x, y, 0, x, y, 6 * radius);
    glow.addColorStop(0, 'rgba(150, 180, 255, 0.45)');
    glow.addColorStop(0.35, 'rgba(130, 160, 255, 0.1)');
    glow.addColorStop(1, 'rgba(0, 0, 0, 0)');
    context.globalAlpha = light;
    context.fillStyle = glow;
    context.fillRect(x - 6 * radius, y - 6 * radius, 12 * radius, 12 * radius);
  }
  const texture = Texture.from(canvas, true);
  texture.source.style.addressMode = 'mirror-repeat';
  texture.source.style.scaleMode = 'linear';
  // Lensing compresses the sky; without mipmaps the texture would show moiré.
  texture.source.autoGenerateMipmaps = true;
  texture.source.style.mipmapFilter = 'linear';
  return texture;
}

/** A soft round dot for the path and the sparks. */
export function paintSpot(): Texture {
  const [canvas, context] = canvasOf(32);
  const glow = context.createRadialGradient(16, 16, 0, 16, 16, 16);
  glow.addColorStop(0, 'rgba(255, 255, 255, 1)');
  glow.addColorStop(0.35, 'rgba(255, 255, 255, 0.85)');
  glow.addColorStop(1, 'rgba(255, 255, 255, 0)');
  context.fillStyle = glow;
  context.fillRect(0, 0, 32, 32);
  return Texture.from(canvas, true);
}
