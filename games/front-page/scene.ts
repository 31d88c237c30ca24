/** The live scene at the head of the front page: dust on orbits about a star, which the pointer stirs. */
import { attractors, createPhysicsWorld, spawn, step } from '@principia/physics';

const COUNT = 700;
/** Gravitational parameters of the star and of the pointer, m³/s². */
const [STAR, POINTER] = [40, 9];
/** Inner and outer radius of the dust, m. */
const [INNER, OUTER] = [1.6, 6.4];
/** Length of a step, s. */
const STEP = 1 / 120;
/** Height that the canvas shows, m. */
const VISIBLE = 9;

/**
 * A number from 0 to 1, evenly spread over i and the three axes. Source: the sequence R3 of Roberts, "The unreasonable
 * effectiveness of quasirandom sequences" (2018).
 */
function spread(i: number, axis: 0 | 1 | 2): number {
  return (0.5 + i * [0.8191725134, 0.6710436067, 0.5497004779][axis]) % 1;
}

function createDust() {
  const world = createPhysicsWorld({ capacity: COUNT + 2, precision: 'f32', forces: [attractors()] });
  const softening = 0.35;
  spawn(world, { position: {}, attractor: { mu: STAR, softening } });
  const stirrer = spawn(world, { position: { y: 1e4 }, attractor: { mu: POINTER, softening: 0.8 } });
  // One by one, because `spawnMany` would add 2.4 KB to this page, and these bodies take some milliseconds.
  const dust = Array.from({ length: COUNT }, (_, i) => {
    const r = INNER + (OUTER - INNER) * Math.sqrt(spread(i, 0));
    const angle = 2 * Math.PI * spread(i, 1);
    const speed = Math.sqrt(STAR / r) * (0.96 + 0.08 * spread(i, 2));
    return spawn(world, {
      position: { x: r * Math.cos(angle), y: r * Math.sin(angle) },
      velocity: { x: -speed * Math.sin(angle), y: speed * Math.cos(angle) },
      mass: 1,
    });
  });
  return { world, dust, stirrer };
}

/** A scene that can stand still for a while. */
export interface LiveScene {
  pause(): void;
  resume(): void;
}

/** Draws the dust on a canvas while it is seen. @param isStill draws one picture only */
export function showDust(canvas: HTMLCanvasElement, isStill: boolean): LiveScene | undefined {
  const context = canvas.getContext('2d');
  if (context === null) return undefined;
  const { world, dust, stirrer } = createDust();
  const { Position } = world.components;
  let scale = 1;
  /** Position of the star, as a fraction of the width: beside the text where there is room. */
  let centre = 0.5;
  const resize = () => {
    const resolution = Math.min(2, devicePixelRatio);
    canvas.width = canvas.clientWidth * resolution;
    canvas.height = canvas.clientHeight * resolution;
    scale = canvas.height / VISIBLE;
    centre = canvas.clientWidth > 900 ? 0.74 : 0.5;
  };
  const draw = () => {
    const { width, height } = canvas;
    // What was drawn fades, which leaves trails.
    context.globalCompositeOperation = 'destination-out';
    context.fillStyle = isStill ? '#000' : '#0003';
    context.fillRect(0, 0, width, height);
    context.globalCompositeOperation = 'lighter';
    const size = Math.max(1.4, 0.016 * scale);
    for (let i = 0; i < dust.length; i++) {
      const id = dust[i];
      context.fillStyle = i % 5 === 0 ? '#ffc15e' : i % 3 === 0 ? '#ff7a8a' : '#7fa8ff';
      context.fillRect(centre * width + scale * Position.x[id], height / 2 - scale * Position.y[id], size, size);
    }
  };
  resize();
  addEventListener('resize', resize);
  if (isStill) {
    draw();
    addEventListener('resize', draw);
    return undefined;
  }
  addEventListener('pointermove', ({ clientX, clientY }) => {
    const box = canvas.getBoundingClientRect();
    const metre = box.height / VISIBLE;
    Position.x[stirrer] = (clientX - box.left - centre * box.width) / metre;
    Position.y[stirrer] = -(clientY - box.top - box.height / 2) / metre;
  });
  // Time that is left of a step, s. A runner would do more than this page needs.
  let left = 0;
  return animate(canvas, (seconds) => {
    for (left += seconds; left >= STEP; left -= STEP) step(world, STEP);
    draw();
  });
}

/** Calls `frame` while an element is in the window and not paused; a hidden page draws no frames by itself. */
function animate(element: Element, frame: (seconds: number) => void): LiveScene {
  let request = 0;
  let [isSeen, isPaused] = [false, false];
  let last: number | undefined;
  const tick = (now: number) => {
    // Its time begins with the first frame, whose stamp may lie before a clock read in advance.
    frame(Math.min(0.05, (now - (last ?? now)) / 1000));
    last = now;
    request = requestAnimationFrame(tick);
  };
  const update = () => {
    cancelAnimationFrame(request);
    if (!isSeen || isPaused) return;
    last = undefined;
    request = requestAnimationFrame(tick);
  };
  const setPaused = (paused: boolean) => {
    isPaused = paused;
    update();
  };
  new IntersectionObserver((entries) => {
    isSeen = entries[entries.length - 1].isIntersecting;
    update();
  }).observe(element);
  return { pause: () => setPaused(true), resume: () => setPaused(false) };
}
