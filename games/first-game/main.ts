import { boxWalls, createPhysicsWorld, createRunner, quadraticDrag, spawn, uniformGravity } from '@principia/physics';
import { worldSource } from '@principia/render-core';
import { applyCamera, createBodyLayer } from '@principia/render-pixi';
import { Application } from 'pixi.js';

// A world 16 m wide and 9 m high, with a ball in it. SI units throughout.
const world = createPhysicsWorld({
  forces: [uniformGravity({ y: -9.81 }), quadraticDrag()],
  walls: [boxWalls({ min: { x: -8, y: 0 }, max: { x: 8, y: 9 } })],
});
const collider = { radius: 0.5, restitution: 0.8 };
const ball = spawn(world, { position: { y: 6 }, velocity: { x: 3 }, mass: 1, collider, quadraticDrag: 0.01 });

const app = new Application();
await app.init({ preference: ['webgl', 'webgpu'], background: '#10141c', resizeTo: window, antialias: true });
document.body.append(app.canvas);
const layer = createBodyLayer({ source: worldSource(world), defaultColor: 0xffb454 });
app.stage.addChild(layer.container);

// A click below the ball kicks it up: velocity columns are plain typed arrays.
addEventListener('pointerdown', () => {
  const { x, y } = world.components.Velocity;
  y[ball] = 9;
  x[ball] += 4 * Math.sign(-world.components.Position.x[ball]);
});

const runner = createRunner(world, { dt: 1 / 120 });
app.ticker.add(({ deltaMS }) => {
  runner.advance(deltaMS / 1000);
  const camera = { x: 0, y: 4.5, pixelsPerMetre: Math.min(app.screen.width / 17, app.screen.height / 10) };
  applyCamera(app.stage, camera, app.screen);
  layer.update(runner.alpha);
});
