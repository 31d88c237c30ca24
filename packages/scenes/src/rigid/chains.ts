import { box, createJoint, revolute, spawn } from '@principia/physics';
import { countOf, defineScene } from '../scene.ts';
import { seededUniforms } from '../seeded.ts';
import { rigidWorld, runOf, sleeping } from './rigid-scene.ts';

/** Links of a chain, their length, m, and the mass at its end in masses of a link. */
const LINKS = 50;
const LENGTH = 0.2;
const LOAD = 20;

/** Chains of fifty links with a heavy ball at the end, which fall from level and swing. */
export const chains = defineScene({
  name: 'chains',
  description: 'chains of fifty links with a heavy ball at the end, which fall from level and swing',
  precision: 'f32',
  parameters: { count: countOf('links', 2500, 50_000), sleeping },
  build(setup) {
    const { count } = setup.parameters;
    const chainCount = Math.max(1, Math.floor(count / LINKS));
    const links = Math.min(count, LINKS);
    const world = rigidWorld(setup, 2 * (chainCount * (links + 2)));
    const shift = seededUniforms(setup.seed, 64)(-0.05, 0.05);
    const link = { shape: box(LENGTH, 0.05), density: 100, mask: 0 };
    for (let c = 0; c < chainCount; c++) {
      const y = -0.5 * c + shift[c % 64];
      let last = spawn(world, { position: { y }, rotation: 0, collider: { radius: 0.05, mask: 0 } });
      for (let i = 0; i < links; i++) {
        const next = spawn(world, { position: { x: LENGTH * (i + 0.5), y }, collider: link });
        createJoint(world, revolute({ a: last, b: next, anchor: { x: LENGTH * i, y } }));
        last = next;
      }
      const end = { x: LENGTH * links, y };
      const ball = { radius: 0.25, density: (LOAD * 100 * LENGTH * 0.05) / (Math.PI * 0.25 * 0.25), mask: 0 };
      const load = spawn(world, { position: end, rotation: 0, collider: ball });
      createJoint(world, revolute({ a: last, b: load, anchor: end }));
    }
    return { ...runOf(world), losesEnergy: 'what swings on joints keeps its energy to second order only' };
  },
});
