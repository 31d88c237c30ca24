import { box, cos, rgba, sin, spawn, spawnChain } from '@principia/physics';
import { countOf, defineScene } from '../scene.ts';
import { seededUniforms } from '../seeded.ts';
import { addWalker, moveWalkers, Walker } from '../walkers.ts';
import { GRAVITY, rigidWorld, runOf, sleeping } from './rigid-scene.ts';

/** Ground for each character, m, distance of the vertices of the hills, their height and length, m. */
const ROOM = 3;
const SPACING = 1;
const HEIGHT = 1.5;
const LENGTH = 24;

/** Number of characters for each crate, and the side of a crate, m. */
const CHARACTERS_PER_CRATE = 5;
const SIDE = 0.4;

/** Half of the way that a character walks to and fro, m. */
const WAY = 6;

/** Characters that walk over hills, and push crates. */
export const crowd = defineScene({
  name: 'crowd',
  description: 'characters that walk over hills, and push crates',
  precision: 'f32',
  parameters: { count: countOf('characters', 200, 5_000), sleeping },
  build(setup) {
    const { count } = setup.parameters;
    const end = 0.5 * ROOM * count + 2 * WAY;
    const vertices = Math.ceil((2 * end) / SPACING) + 1;
    const crates = Math.ceil(count / CHARACTERS_PER_CRATE);
    const world = rigidWorld(setup, vertices + count + crates + 10, GRAVITY, { components: [Walker] });
    const heightAt = (x: number) => 0.5 * HEIGHT * (1 - cos((2 * Math.PI * x) / LENGTH) + 0.3 * sin(x));
    // What is solid lies to the left of a chain: below one that goes to the left.
    const hills = Array.from({ length: vertices }, (_, i) => {
      const x = end - i * SPACING;
      return { x, y: heightAt(x) };
    });
    spawnChain(world, hills, { friction: 0.6 });
    for (let i = 0; i < crates; i++) {
      const x = (i + 0.5 - 0.5 * crates) * CHARACTERS_PER_CRATE * ROOM;
      spawn(world, {
        position: { x, y: heightAt(x) + SIDE },
        velocity: {},
        collider: { shape: box(SIDE, SIDE), density: 100, friction: 0.6 },
      });
    }
    const speeds = seededUniforms(setup.seed, count)(1, 4);
    const walkers = Array.from({ length: count }, (_, i) => {
      const x = (i + 0.5 - 0.5 * count) * ROOM;
      const wanted = i % 2 === 0 ? speeds[i] : -speeds[i];
      return addWalker(world, { x, y: heightAt(x) + 0.5 }, rgba(0.4, 0.7, 1), { wanted, from: x - WAY, to: x + WAY });
    });
    moveWalkers(world, walkers, { gravity: GRAVITY, maxSlope: 0.9, stepHeight: 0.3 });
    return { ...runOf(world), losesEnergy: 'characters walk by themselves' };
  },
});
