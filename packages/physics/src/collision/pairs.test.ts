// The broad phase finds the pairs of shapes whose boxes begin to overlap: all of them, and each once.
import {
  bodyBoxes,
  box,
  createRandom,
  type PhysicsWorld,
  type ShouldCollide,
  softStep,
  spawn,
  step,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';

const BODIES = 120;

interface Flyer {
  readonly id: number;
  readonly kind: 'dynamic' | 'static' | 'kinematic';
  readonly layers: number;
  readonly mask: number;
}

const random = createRandom(7);

/** A box that flies, or stands, on some of three layers; now and then on none of those of any mask. */
function spawnFlyer(world: PhysicsWorld, kind: Flyer['kind']): Flyer {
  const [layers, mask] = [random.integer(1, 7), random.integer(0, 7)];
  const id = spawn(world, {
    position: { x: random.uniform(-15, 15), y: random.uniform(-15, 15) },
    rotation: random.uniform(-3, 3),
    velocity: kind === 'static' ? {} : { x: random.uniform(-8, 8), y: random.uniform(-8, 8) },
    collider: {
      shape: box(random.uniform(0.2, 3), random.uniform(0.2, 3)),
      layers,
      mask,
      ...(kind === 'dynamic' ? { density: 1 } : {}),
    },
  });
  return { id, kind, layers, mask };
}

const keyOf = (a: number, b: number) => `${Math.min(a, b)} ${Math.max(a, b)}`;

/** The pairs that overlap and may collide, by trying all. */
function overlapsOf(world: PhysicsWorld, flyers: readonly Flyer[]): Set<string> {
  const { count, body, minX, minY, maxX, maxY } = bodyBoxes(world);
  const byId = new Map(flyers.map((flyer) => [flyer.id, flyer]));
  const pairs = new Set<string>();
  for (let i = 0; i < count; i++) {
    for (let j = 0; j < i; j++) {
      const [a, b] = [byId.get(body[i]), byId.get(body[j])] as [Flyer, Flyer];
      if (a.kind !== 'dynamic' && b.kind !== 'dynamic') continue;
      if ((a.layers & b.mask) === 0 || (b.layers & a.mask) === 0) continue;
      const alongX = minX[i] <= maxX[j] && minX[j] <= maxX[i];
      const alongY = minY[i] <= maxY[j] && minY[j] <= maxY[i];
      if (alongX && alongY) pairs.add(keyOf(a.id, b.id));
    }
  }
  return pairs;
}

describe.each(['f32', 'f64'] as const)('pairs in %s', (precision) => {
  it('are those whose boxes overlap and did not in the step before', () => {
    const asked: string[] = [];
    const shouldCollide: ShouldCollide = (_, a, b) => {
      asked.push(keyOf(a, b));
      return false;
    };
    const world = rigidWorld({ precision, integrator: softStep({ shouldCollide }), forces: [] });
    const flyers = Array.from({ length: BODIES }, (_, i) =>
      spawnFlyer(world, (['dynamic', 'static', 'kinematic'] as const)[i % 3]),
    );
    const standing = flyers.filter(({ kind }) => kind === 'static');
    let before = new Set<string>();
    let found = 0;
    for (let n = 0; n < 200; n++) {
      asked.length = 0;
      // Now and then one that stands is moved.
      if (n % 20 === 10) world.components.Position.x[standing[n % 7].id] = random.uniform(-15, 15);
      step(world, DT);
      const now = overlapsOf(world, flyers);
      expect([...asked].sort(), `step ${n}`).toEqual([...now].filter((key) => !before.has(key)).sort());
      found += asked.length;
      before = now;
    }
    expect(found).toBeGreaterThan(100);
  });
});
