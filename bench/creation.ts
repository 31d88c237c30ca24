import type { SceneRun } from '@principia/scenes';
import { addComponent, addEntity, createWorld } from 'bitecs';
import { bytesInUse } from './memory.ts';
import { median } from './statistics.ts';

/** The cost of creating a world. */
export interface Creation {
  readonly ms: number;
  readonly bytes: number;
  readonly peers: readonly { readonly name: string; readonly ms: number; readonly bytes: number }[];
}

interface Cost {
  ms: number;
  bytes: number;
}

/**
 * Makes the scene, and, where `peers` are asked for, in turns with a bare bitECS world of as many entities with one
 * component each: the least that any bitECS program pays. The last world made is the one to go on with.
 */
export function measureCreation(
  create: () => SceneRun,
  count: number,
  peers: boolean,
): { creation: Creation; run: SceneRun } {
  if (!peers) {
    const { cost, made } = costOf(create);
    return { creation: { ...cost, peers: [] }, run: made };
  }
  const ROUNDS = 3;
  const ours: Cost[] = [];
  const bare: Cost[] = [];
  for (let round = 0; round < ROUNDS; round++) {
    bare.push(costOf(() => bareEntities(count)).cost);
    ours.push(costOf(create).cost);
  }
  const run = create();
  return { creation: { ...middle(ours), peers: [{ name: 'bare bitECS', ...middle(bare) }] }, run };
}

function costOf<T>(make: () => T): { cost: Cost; made: T } {
  const before = bytesInUse();
  const start = performance.now();
  const made = make();
  const ms = performance.now() - start;
  return { cost: { ms, bytes: bytesInUse() - before }, made };
}

function middle(costs: readonly Cost[]): Cost {
  return { ms: median(costs.map(({ ms }) => ms)), bytes: median(costs.map(({ bytes }) => bytes)) };
}

function bareEntities(count: number): object {
  const world = createWorld();
  const Position = {};
  for (let i = 0; i < count; i++) addComponent(world, addEntity(world), Position);
  return world;
}
