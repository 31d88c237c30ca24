// Encoded snapshots pass between builds of one program whose functions have other names, as minifiers give them.
import {
  breakSprings,
  createEmitter,
  createPhysicsWorld,
  decodeSnapshot,
  encodeSnapshot,
  type GlobalSystem,
  localSystem,
  mergeOnContact,
  type PhysicsWorld,
  particleContacts,
  rigidBodies,
  snapshot,
  standard,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';

/** Every function among the systems of a world gets another name, as by a minifier. */
function minify({ phases }: PhysicsWorld): void {
  for (const system of Object.values(phases).flat()) {
    if (typeof system === 'function')
      Object.defineProperty(system, 'name', { value: `${system.name}x`, configurable: true });
  }
}

function make(preset: typeof standard, ...own: readonly GlobalSystem[]): PhysicsWorld {
  const world = createPhysicsWorld({ preset, capacity: 50 });
  createEmitter(world, { capacity: 5 });
  world.phases.finish.push(breakSprings);
  if (preset === particleContacts) world.phases.finish.push(mergeOnContact);
  world.phases.input.push(...own);
  return world;
}

describe.each(Object.entries({ standard, particleContacts, rigidBodies }))('with the preset %s', (_, preset) => {
  const bytesOf = (world: PhysicsWorld) => encodeSnapshot(snapshot(world));

  it('a snapshot passes between builds', () => {
    const bytes = bytesOf(make(preset, () => {}));
    const other = make(preset, () => {});
    minify(other);
    expect(() => decodeSnapshot(other, bytes)).not.toThrow();
  });

  it('systems of one’s own are compared by their number and their systemName', () => {
    const named = (systemName: string): GlobalSystem => Object.assign(() => {}, { systemName });
    const bytes = bytesOf(make(preset, named('score')));
    expect(() => decodeSnapshot(make(preset, named('score')), bytes)).not.toThrow();
    for (const other of [make(preset), make(preset, () => {}), make(preset, named('lives'))]) {
      expect(() => decodeSnapshot(other, bytes)).toThrow(/differs in systems/);
    }
  });

  it('local systems are compared by their name, and each system by its phase', () => {
    const local = (name: string, phase: 'input' | 'events') => {
      const world = make(preset);
      world.phases[phase].push(localSystem(name, () => {}));
      return world;
    };
    const bytes = bytesOf(local('wind', 'input'));
    expect(() => decodeSnapshot(local('wind', 'input'), bytes)).not.toThrow();
    expect(() => decodeSnapshot(local('wind', 'events'), bytes)).toThrow(/differs in systems/);
    expect(() => decodeSnapshot(local('rain', 'input'), bytes)).toThrow(/differs in systems/);
  });

  it('the systems of the package are told apart', () => {
    const world = make(preset);
    const bytes = bytesOf(world);
    const other = make(preset);
    other.phases.finish.splice(other.phases.finish.indexOf(breakSprings), 1, mergeOnContact);
    expect(() => decodeSnapshot(other, bytes)).toThrow(/break springs.*merge on contact/);
    const names = Object.values(world.phases)
      .flat()
      .map((system) => (typeof system === 'function' ? system.systemName : system.name));
    expect(names).not.toContain(undefined);
  });
});
