// Ids that user code writes to the columns of joints and parts: the kernels read the rows of these ids.
import { createJoint, rayCast, revolute, spawn, spawnCompound, step } from '@principia/physics';
import { expect, it } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';

const refused = (field: string, value: number) => expect.objectContaining({ code: 'E_RANGE', field, value });

it.each([1500, 4_000_000, 4_000_000_000])('a joint to %d refuses the step, until its ends are bodies again', (id) => {
  const world = rigidWorld({ forces: [] });
  const [a, b] = [1, 3].map((x) => spawn(world, { position: { x }, collider: { radius: 0.5, density: 1 } }));
  const joint = createJoint(world, revolute({ a, b, anchor: { x: 2 } }));
  step(world, DT);
  const { Joint, Position } = world.components;
  for (const end of ['a', 'b'] as const) {
    const before = Joint[end][joint];
    Joint[end][joint] = id;
    expect(() => step(world, DT)).toThrow(refused(`joint.${end}`, id));
    // Also where the list of joints is made anew.
    spawn(world, { position: { y: 50 } });
    expect(() => step(world, DT)).toThrow(refused(`joint.${end}`, id));
    Joint[end][joint] = before;
    step(world, DT);
  }
  expect([Position.x[a], Position.x[b], world.internal.counts.Joint]).toEqual([1, 3, 1]);
});

it.each([1500, 4_000_000, 4_000_000_000])('a part of %d refuses steps and queries, until it has a body again', (id) => {
  const world = rigidWorld({ forces: [] });
  const { body, parts } = spawnCompound(world, { parts: [-1, 1].map((x) => ({ x, density: 1, radius: 0.5 })) });
  step(world, DT);
  const { Attachment } = world.components;
  const cast = () => rayCast(world, { x: -5 }, { x: 5 })?.body;
  Attachment.body[parts[0]] = id;
  expect(() => step(world, DT)).toThrow(refused('attachment.body', id));
  expect(cast).toThrow(refused('attachment.body', id));
  Attachment.body[parts[0]] = body;
  step(world, DT);
  expect(cast()).toBe(parts[0]);
});
