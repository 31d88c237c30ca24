import { box, capsule, cos, createJoint, revolute, sin, spawn, spawnChain } from '@principia/physics';
import { countOf, defineScene } from '../scene.ts';
import { seededUniforms } from '../seeded.ts';
import { rigidWorld, runOf, sleeping } from './rigid-scene.ts';

/** Vertices of the ring, its radius, m, and the angular speed of the blade, rad/s: those of Box2D's spinner. */
const VERTICES = 360;
const RADIUS = 40;
const SPEED = 5;

/** Capsules, discs and boxes stirred by a blade in a ring of smooth edges. */
export const spinner = defineScene({
  name: 'spinner',
  description: 'capsules, discs and boxes stirred by a blade in a ring of smooth edges',
  precision: 'f32',
  parameters: { count: countOf('bodies', 6076, 20_000), sleeping },
  build(setup) {
    const { count } = setup.parameters;
    const world = rigidWorld(setup, count + VERTICES + 10);
    // What is solid lies to the left of a chain: outside of one that goes round clockwise.
    const points = Array.from({ length: VERTICES }, (_, i) => {
      const angle = (i / VERTICES) * 2 * Math.PI;
      return { x: RADIUS * cos(angle), y: 32 - RADIUS * sin(angle) };
    });
    spawnChain(world, points, { friction: 0.1 }, { closed: true });
    const middle = { y: 12 };
    const blade = spawn(world, { position: middle, collider: { shape: box(1.2, 40.4), density: 1, friction: 0 } });
    createJoint(world, revolute({ b: blade, anchor: middle, motor: { speed: SPEED, max: 1e9 } }));
    const material = { density: 0.25, friction: 0.1, restitution: 0.1 };
    const shapes = [capsule(0.5, 0.25), undefined, box(0.7, 0.7)];
    const shift = seededUniforms(setup.seed, 64)(-0.01, 0.01);
    for (let i = 0; i < count; i++) {
      const position = { x: -23 + 0.5 * (i % 92) + shift[i % 64], y: 2 + 0.5 * Math.floor(i / 92) };
      const shape = shapes[i % 3];
      spawn(world, { position, rotation: 0, collider: { ...(shape ? { shape } : { radius: 0.35 }), ...material } });
    }
    return { ...runOf(world), losesEnergy: 'a motor turns the blade, and friction dissipates energy' };
  },
});
