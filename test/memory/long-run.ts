/**
 * A program for `node --expose-gc`: a million steps, or as many as its argument says, of worlds that use most features at
 * once. After every ten thousand it prints how many bytes are on the JavaScript heap; a value that is not finite, a
 * fault, or energy out of bounds ends it.
 */
import { getHeapStatistics } from 'node:v8';
import {
  bodies,
  contactEvents,
  contacts,
  createEmitter,
  despawn,
  energy,
  on,
  type PhysicsWorld,
  restore,
  snapshot,
  spawn,
  step,
} from '@principia/physics';
import { tumbler } from '@principia/scenes';
import { chaoticWorld } from '../support/chaos.ts';

declare const gc: () => void;

const ROUND = 10_000;
const [steps = '1000000'] = process.argv.slice(2);

/** Energies of a few dozen bodies of 1 kg and a motor are hundreds of joules. */
const MAX_ENERGY = 1e5;

const mixed = mixedWorld();
const rigid = tumbler.create({ count: 24 });
const seen = { contacts: 0, begun: 0 };
on(mixed.world, 'contact', (i) => {
  if (contacts(mixed.world).speed[i] > 0) seen.contacts++;
});

/** Discs with springs, attractors and drag among the particles of an emitter. */
function mixedWorld() {
  const world = chaoticWorld(2, 'f64', 7, 40);
  const collider = { radius: 0.1, restitution: 0.5 };
  createEmitter(world, { capacity: 60, rate: 20, lifetime: [1, 2], speed: 3, position: { x: 10, y: 15 }, collider });
  return { world, spare: snapshot(world), guest: 0 };
}

/** Edits as a game makes them: a body comes and goes, and sometimes time goes back by a few steps. */
function edit(i: number): void {
  if (i % 50 === 0) {
    if (mixed.guest !== 0) despawn(mixed.world, mixed.guest);
    mixed.guest = spawn(mixed.world, { position: { x: 3, y: 18 }, velocity: {}, mass: 1, collider: { radius: 0.3 } });
  }
  if (i % 1000 === 40) snapshot(mixed.world, mixed.spare);
  if (i % 1000 === 45) restore(mixed.world, mixed.spare);
}

function check(world: PhysicsWorld): void {
  const total = energy(world).kinetic;
  if (!(total < MAX_ENERGY)) throw new Error(`the kinetic energy is ${total} J after ${world.tick} steps`);
  const [fault] = world.faults.faults;
  if (fault !== undefined) throw new Error(`a fault: ${JSON.stringify(fault)}`);
  const { ids, count } = bodies(world);
  const { x, y } = world.components.Position;
  for (let i = 0; i < count; i++) {
    if (!Number.isFinite(x[ids[i]] + y[ids[i]])) throw new Error(`body ${ids[i]} is at ${x[ids[i]]}, ${y[ids[i]]}`);
  }
}

for (let i = 0; i < Number(steps); i++) {
  edit(i);
  step(mixed.world, 1 / 60);
  step(rigid.world, rigid.dt);
  seen.begun += contactEvents(rigid.world).begin.count;
  if ((i + 1) % ROUND !== 0) continue;
  check(mixed.world);
  check(rigid.world);
  gc();
  process.stdout.write(`${getHeapStatistics().used_heap_size}\n`);
}
if (seen.contacts === 0 || seen.begun === 0) throw new Error('nothing touched');
