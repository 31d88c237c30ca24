import { boxWalls, createPhysicsWorld, createRunner, quadraticDrag, spawn, uniformGravity } from '@principia/physics';
import { placeInPicture, toWorld, worldSource } from '@principia/render-core';
import { applyCamera, createBodyLayer, createSegmentLayer } from '@principia/render-pixi';
import { Application } from 'pixi.js';

// A room that suits the window, with a ball in it. SI units throughout.
const [halfWidth, height] = innerWidth > innerHeight ? [8, 9] : [4.5, 15];
const world = createPhysicsWorld({
  forces: [uniformGravity({ y: -9.81 }), quadraticDrag()],
  walls: [boxWalls({ min: { x: -halfWidth, y: 0 }, max: { x: halfWidth, y: height } })],
});
const collider = { radius: 0.5, restitution: 0.8 };
const ball = spawn(world, { position: { y: 6 }, velocity: { x: 3 }, mass: 1, collider, quadraticDrag: 0.01 });
const { Position, Velocity } = world.components; // typed arrays, indexed by body

const app = new Application();
await app.init({ preference: ['webgl', 'webgpu'], background: '#10141c', resizeTo: window, antialias: true });
document.body.append(app.canvas);
const layer = createBodyLayer({ source: worldSource(world), defaultColor: 0xffb454 });
const floor = createSegmentLayer({ thickness: 4, color: 0x5b8cff });
floor.set([-halfWidth, 0, halfWidth, 0]);
app.stage.addChild(floor.container, layer.container);

let sound: AudioContext | undefined; // browsers allow it after the first tap
function beep(frequency: number) {
  sound ??= new AudioContext();
  const tone = new OscillatorNode(sound, { frequency });
  const fade = new GainNode(sound, { gain: 0.2 });
  fade.gain.exponentialRampToValueAtTime(0.001, sound.currentTime + 0.3);
  tone.connect(fade).connect(sound.destination);
  tone.start();
  tone.stop(sound.currentTime + 0.3);
}

// Every tap that hits the ball kicks it up and counts, until the ball touches the floor.
const output = document.querySelector('output') as HTMLOutputElement;
const { touch, keys, top } = output.dataset; // the words of the page, in the reader's language
const hint = matchMedia('(pointer: coarse)').matches ? touch : keys;
const camera = { x: 0, y: height / 2, pixelsPerMetre: 1 };
let [score, best] = [0, 0];
try {
  best = Number(localStorage.getItem('keep it up'));
} catch {} // browsers may refuse to keep anything
function kick(sideways: number) {
  Position.y[ball] = Math.max(Position.y[ball], 0.75); // clear of the floor
  Velocity.y[ball] = 9;
  Velocity.x[ball] = sideways;
  score++;
  best = Math.max(best, score);
  beep(300 + 30 * score);
  try {
    localStorage.setItem('keep it up', String(best));
  } catch {}
}
addEventListener('pointerdown', ({ clientX, clientY }) => {
  const pointer = placeInPicture(app.canvas, clientX, clientY, app.screen, { x: 0, y: 0 });
  const { x, y } = toWorld(camera, app.screen, pointer.x, pointer.y, { x: 0, y: 0 });
  if (Math.hypot(x - Position.x[ball], y - Position.y[ball]) < 1.2) kick(5 * (Position.x[ball] - x));
});
addEventListener('keydown', ({ key, repeat }) => {
  if (key !== ' ' || repeat) return;
  if (Position.y[ball] < 3 && (Velocity.y[ball] < 0 || score === 0)) kick(Velocity.x[ball]);
  else score = 0; // too early
});

const runner = createRunner(world, { dt: 1 / 120 });
app.ticker.add(({ deltaMS }) => {
  runner.advance(deltaMS / 1000);
  if (score > 0 && Position.y[ball] < 0.7) {
    score = 0;
    beep(90);
  }
  output.value = score === 0 ? `${hint} – ${top}: ${best}` : `${score}`;
  camera.pixelsPerMetre = Math.min(app.screen.width / (2 * halfWidth + 1), app.screen.height / (height + 1));
  applyCamera(app.stage, camera, app.screen);
  layer.update(runner.alpha);
});
