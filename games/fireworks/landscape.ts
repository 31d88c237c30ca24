/** The static landscape behind the fireworks: sky and stars, hills, a town with lit windows, a lake. */

/** A pseudo-random sequence, so that the landscape is the same every time. */
function randomSequence(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** Size of the painting, pixels, and distance of the waterline from its top. */
export interface LandscapeLayout {
  readonly width: number;
  readonly height: number;
  readonly horizon: number;
  /** Pixels per metre. */
  readonly scale: number;
}

function canvasOf(width: number, height: number): [HTMLCanvasElement, CanvasRenderingContext2D] {
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(1, Math.round(width));
  canvas.height = Math.max(1, Math.round(height));
  // A canvas in main memory: on the GPU, the gradients would have to compile shaders first, which delays the start.
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (context === null) throw new Error('This browser offers no 2D canvas.');
  return [canvas, context];
}

/** Colour of the sky at the horizon. */
export const HORIZON_COLOR = '#2a2850';

/** Paints the background: the sky above the horizon, the water below. */
export function paintSky({ width, height, horizon, scale }: LandscapeLayout): HTMLCanvasElement {
  const [canvas, context] = canvasOf(width, height);
  const sky = context.createLinearGradient(0, 0, 0, horizon);
  for (const [at, color] of [
    [0, '#03040d'],
    [0.45, '#070b21'],
    [0.8, '#101637'],
    [0.96, '#1d2149'],
    [1, HORIZON_COLOR],
  ] as const) {
    sky.addColorStop(at, color);
  }
  context.fillStyle = sky;
  context.fillRect(0, 0, width, horizon);
  paintStars(context, width, horizon);
  const water = context.createLinearGradient(0, horizon, 0, height);
  water.addColorStop(0, '#171a3d');
  water.addColorStop(0.25, '#0c1029');
  water.addColorStop(1, '#04060f');
  context.fillStyle = water;
  context.fillRect(0, horizon, width, height - horizon);
  // Reflections of the town's lights on the water.
  const random = randomSequence(11);
  for (let i = 0; i < width / 26; i++) {
    const [x, length] = [random() * width, (0.15 + 0.5 * random()) * (height - horizon)];
    const streak = context.createLinearGradient(0, horizon, 0, horizon + length);
    streak.addColorStop(0, 'rgba(255, 196, 120, 0.16)');
    streak.addColorStop(1, 'rgba(255, 196, 120, 0)');
    context.fillStyle = streak;
    context.fillRect(x, horizon, 0.25 * scale + random(), length);
  }
  return canvas;
}

function paintStars(context: CanvasRenderingContext2D, width: number, horizon: number): void {
  const random = randomSequence(7);
  for (let i = 0; i < (width * horizon) / 1900; i++) {
    const [x, y] = [random() * width, random() * horizon];
    const size = 0.35 + 0.9 * random() ** 6;
    const low = 1 - (y / horizon) ** 3;
    context.fillStyle = `rgba(${200 + 55 * random()}, ${215 + 30 * random()}, 255, ${(0.15 + 0.6 * random()) * low})`;
    context.beginPath();
    context.arc(x, y, size, 0, 7);
    context.fill();
  }
}

/** Paints the foreground on transparency: two rows of hills and the town between them. */
export function paintShore({ width, horizon, scale }: LandscapeLayout): HTMLCanvasElement {
  const [canvas, context] = canvasOf(width, horizon + 1);
  const random = randomSequence(23);
  paintHills(context, width, horizon, 9 * scale, 0.0105 / scale, 2, '#0c1030');
  const wide = 3.4 * scale;
  for (let x = -random() * wide; x < width; ) {
    const w = (0.35 + 0.75 * random()) * wide;
    // Buildings are tall in two clusters, low elsewhere.
    const place = x / width;
    const cluster = Math.exp(-(((place - 0.2) / 0.09) ** 2)) + Math.exp(-(((place - 0.82) / 0.07) ** 2));
    const h = (1.1 + 2 * random() + 6.5 * cluster * (0.35 + 0.65 * random())) * scale;
    paintHouse(context, x, horizon, w, h, scale, random);
    x += w + 0.2 * scale * random();
  }
  paintHills(context, width, horizon, 1.7 * scale, 0.03 / scale, 5, '#04050f');
  return canvas;
}

function paintHills(
  context: CanvasRenderingContext2D,
  width: number,
  foot: number,
  height: number,
  pace: number,
  phase: number,
  color: string,
): void {
  context.fillStyle = color;
  context.beginPath();
  context.moveTo(0, foot + 1);
  for (let x = 0; x <= width; x += 2) {
    const t = 6.2832 * pace * x + phase;
    const ridge =
      0.55 + 0.26 * Math.sin(t) + 0.12 * Math.sin(2.7 * t + 1) + 0.06 * Math.sin(7.3 * t) + 0.02 * Math.sin(23 * t);
    context.lineTo(x, foot - height * Math.max(0.06, ridge));
  }
  context.lineTo(width, foot + 1);
  context.fill();
}

function paintHouse(
  context: CanvasRenderingContext2D,
  x: number,
  foot: number,
  width: number,
  height: number,
  scale: number,
  random: () => number,
): void {
  context.fillStyle = '#070a1f';
  context.fillRect(x, foot - height, width, height);
  const [across, up] = [0.5 * scale, 0.62 * scale];
  for (let wx = x + 0.25 * scale; wx < x + width - 0.3 * scale; wx += across) {
    for (let wy = foot - height + 0.3 * scale; wy < foot - 0.4 * scale; wy += up) {
      if (random() > 0.3) continue;
      context.fillStyle = `rgba(255, ${176 + 60 * random()}, ${90 + 80 * random()}, ${0.25 + 0.55 * random()})`;
      context.fillRect(wx, wy, 0.22 * scale, 0.26 * scale);
    }
  }
}
