import { box, cos, type PhysicsWorld, polygon, sin, spawn, spawnCompound } from '@principia/physics';
import { countOf, defineScene } from '../scene.ts';
import { seededUniforms } from '../seeded.ts';
import { MATERIAL, rigidWorld, runOf, sleeping } from './rigid-scene.ts';

/** Plates of the drum, its radii, m, and its angular speed, rad/s: those of Box2D's washer. */
const PLATES = 36;
const [BLADE, INNER, OUTER] = [14, 16, 18];
const SPEED = (25 * Math.PI) / 180;

/** Boxes that tumble in a round drum of forty plates, one compound body that turns. */
export const washer = defineScene({
  name: 'washer',
  description: 'boxes that tumble in a round drum of forty plates, one compound body that turns',
  precision: 'f32',
  parameters: { count: countOf('boxes', 8100, 20_000), sleeping },
  build(setup) {
    const { count } = setup.parameters;
    const world = rigidWorld(setup, count + 60);
    addDrum(world);
    const edge = Math.ceil(Math.sqrt(count));
    const shift = seededUniforms(setup.seed, 64)(-0.001, 0.001);
    for (let i = 0; i < count; i++) {
      const [x, y] = [i % edge, Math.floor(i / edge)].map((place) => 0.21 * (place - 0.5 * (edge - 1)));
      spawn(world, { position: { x: x + shift[i % 64], y }, collider: { shape: box(0.2, 0.2), ...MATERIAL } });
    }
    return { ...runOf(world), losesEnergy: 'the drum is driven, and friction dissipates energy' };
  },
});

function addDrum(world: PhysicsWorld): void {
  const sector = (2 * Math.PI) / PLATES;
  const plate = (from: number, to: number, middle: number, half: number) => {
    const at = (radius: number, angle: number) => ({ x: radius * cos(angle), y: radius * sin(angle) });
    const corners = [at(from, middle - half), at(to, middle - half), at(to, middle + half), at(from, middle + half)];
    const shape = polygon(corners);
    return { shape, x: shape.centre.x, y: shape.centre.y, friction: 0.6 };
  };
  const plates = Array.from({ length: PLATES }, (_, i) => plate(INNER, OUTER, (i + 0.5) * sector, 0.6 * sector));
  const blades = [0, 1, 2, 3].map((i) => plate(BLADE, INNER, (9 * i + 0.5) * sector, 0.5 * sector));
  spawnCompound(world, { position: {}, angularVelocity: SPEED, velocity: {}, parts: [...plates, ...blades] });
}
