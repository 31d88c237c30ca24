import { removeComponent } from 'bitecs';
import { describe, expect, it } from 'vitest';
import { codeOf, emitting, living, run } from '../../../../test/support/emitting.ts';
import {
  aliveCount,
  bodies,
  boxWalls,
  burst,
  createEmitter,
  createPhysicsWorld,
  despawn,
  despawnMany,
  destroyEmitter,
  type Emitter,
  emitterCounts,
  endings,
  endParticle,
  isBody,
  on,
  type PhysicsWorld,
  particleContacts,
  restore,
  snapshot,
  spawn,
  stateHash,
  step,
  uniformGravity,
  wallContacts,
} from '../index.ts';

const DT = 1 / 64;

/** Five particles at rest that live for a second, in a pool of six. */
function five() {
  const made = emitting({ capacity: 6, lifetime: 1, speed: 0, reportEndings: true });
  burst(made.emitter, 5, { position: { x: 3 }, velocity: { y: 2 } });
  step(made.world, DT);
  return made;
}

type End = (world: PhysicsWorld, emitter: Emitter, id: number) => void;

const WAYS: [string, End][] = [
  ['endParticle', (_, emitter, id) => endParticle(emitter, id)],
  ['despawn', (world, _, id) => despawn(world, id)],
  ['despawnMany', (world, _, id) => despawnMany(world, [id])],
];

describe.each(WAYS)('a particle that %s ends', (_, end) => {
  it('has ended with the next step, is reported where it was, and frees its place', () => {
    const { world, emitter } = five();
    const [, id] = living(emitter);
    const { x, y } = world.components.Position;
    const at = [x[id], y[id], 0, 0, 2, 0];
    end(world, emitter, id);
    end(world, emitter, id);
    step(world, DT);
    expect(emitterCounts(emitter)).toEqual({ alive: 4, born: 5, ended: 1, dropped: 0 });
    const { count, ids, states } = endings(emitter);
    expect([count, ids[0], ...states.subarray(0, 6)]).toEqual([1, id, ...at]);
    expect(living(emitter)).not.toContain(id);
    burst(emitter, 3);
    step(world, DT);
    expect(emitterCounts(emitter)).toEqual({ alive: 6, born: 7, ended: 1, dropped: 1 });
    expect(isBody(world, id)).toBe(true);
    // Those that were not ended live out their time.
    run(world, 1.5, DT);
    expect(emitterCounts(emitter)).toMatchObject({ alive: 0, born: 7, ended: 7 });
  });

  it('leaves room in a rain whose drops end where they land', () => {
    const world = createPhysicsWorld({
      preset: particleContacts,
      capacity: 400,
      forces: [uniformGravity()],
      walls: [boxWalls({ min: { y: 0 } })],
    });
    const rain = createEmitter(world, {
      capacity: 150,
      rate: 100,
      lifetime: 10,
      position: { y: 3 },
      positionSpread: { x: 5 },
      mass: 1e-3,
      collider: { radius: 0.01, mask: 0 },
    });
    on(world, 'wallContact', (contact) => end(world, rain, wallContacts(world).body[contact]));
    run(world, 8);
    const { alive, born, ended, dropped } = emitterCounts(rain);
    // A drop falls for less than 0.9 s.
    expect([dropped, born - ended - alive, born > 790, alive > 50 && alive < 100]).toEqual([0, 0, true, true]);
    expect(bodies(world).count).toBe(150);
    expect(rain.ids).not.toContain(spawn(world, { position: {}, mass: 7 }));
  });

  it('is over in a snapshot, too', () => {
    const { world, emitter } = five();
    end(world, emitter, living(emitter)[0]);
    const saved = snapshot(world);
    const play = () => {
      run(world, 0.5, DT);
      return `${stateHash(world)} ${aliveCount(emitter)} ${emitterCounts(emitter).ended}`;
    };
    const first = play();
    expect(aliveCount(emitter)).toBe(4);
    restore(world, saved);
    expect(play()).toBe(first);
  });
});

describe('endParticle', () => {
  it('refuses what is no living particle of the emitter', () => {
    const { world, emitter } = five();
    const other = createEmitter(world, { capacity: 5 });
    const body = spawn(world, { position: {}, mass: 1 });
    const waiting = [...emitter.ids].filter((id) => world.components.Mass.value[id] === 0);
    expect(waiting).toHaveLength(1);
    for (const id of [...waiting, ...other.ids, body, 0, -1, 1e9, 1.5, Number.NaN, undefined as never, '1' as never]) {
      expect(`${id} ${codeOf(() => endParticle(emitter, id))}`).toBe(`${id} E_STALE`);
    }
    const [id] = living(emitter);
    endParticle(emitter, id);
    step(world, DT);
    expect(() => endParticle(emitter, id)).toThrow(/no living particle of this emitter.*emitter\.ids/);
    destroyEmitter(emitter);
    expect(codeOf(() => endParticle(emitter, id))).toBe('E_STALE');
  });
});

describe('despawn', () => {
  it('leaves what waits in a pool, and with despawnMany ends all particles of a world', () => {
    const { world, emitter } = five();
    const body = spawn(world, { position: {}, mass: 1 });
    despawnMany(world, [...emitter.ids, body]);
    step(world, DT);
    expect([isBody(world, body), aliveCount(emitter), bodies(world).count]).toEqual([false, 0, 6]);
    burst(emitter, 6);
    step(world, DT);
    expect(aliveCount(emitter)).toBe(6);
  });

  it('removes an entity that left its pool or whose emitter was destroyed', () => {
    const { world, emitter } = five();
    const [id, next] = living(emitter);
    removeComponent(world, id, world.components.Mass);
    despawn(world, id);
    expect(isBody(world, id)).toBe(false);
    destroyEmitter(emitter);
    const heir = spawn(world, { position: {}, mass: 1 });
    expect(emitter.ids).toContain(heir);
    despawn(world, heir);
    expect([isBody(world, heir), isBody(world, next)]).toEqual([false, false]);
  });
});
