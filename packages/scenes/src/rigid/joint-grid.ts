import { createJoint, revolute, spawn } from '@principia/physics';
import { countOf, defineScene } from '../scene.ts';
import { seededUniforms } from '../seeded.ts';
import { rigidWorld, runOf, sleeping } from './rigid-scene.ts';

/** A net of discs and hinges that hangs by seven of them. */
export const jointGrid = defineScene({
  name: 'joint-grid',
  description: 'a net of discs and hinges that hangs by seven of them',
  precision: 'f32',
  parameters: { count: countOf('discs', 10_000, 100_000), sleeping },
  build(setup) {
    const { seed, parameters } = setup;
    const edge = Math.max(1, Math.floor(Math.sqrt(parameters.count)));
    const world = rigidWorld(setup, 3 * edge * edge);
    const collider = { radius: 0.4, mask: 0 };
    const ids: number[] = [];
    const spin = seededUniforms(seed, edge * edge)(-0.1, 0.1);
    const isHeld = (column: number) => Math.abs(column - Math.floor(edge / 2)) <= 3 && edge > 1;
    for (let i = 0; i < edge * edge; i++) {
      const [column, row] = [Math.floor(i / edge), i % edge];
      const position = { x: column, y: -row };
      const held = row === 0 && isHeld(column);
      const moving = { angularVelocity: spin[i], collider: { ...collider, density: 1 } };
      const body = spawn(world, { position, rotation: 0, ...(held ? { collider } : moving) });
      if (row > 0) createJoint(world, revolute({ a: ids[i - 1], b: body, anchor: { x: column, y: 0.5 - row } }));
      // A hinge between two bodies that hold the net would move nothing.
      const joinsHeld = held && column > 0 && isHeld(column - 1);
      if (column > 0 && !joinsHeld)
        createJoint(world, revolute({ a: ids[i - edge], b: body, anchor: { x: column - 0.5, y: -row } }));
      ids.push(body);
    }
    return runOf(world);
  },
});
