// Which bodies collide, from which side, and with which coefficients: groups, the user's function, one-way platforms, rules.
import {
  box,
  COMBINE,
  contactEvents,
  restore,
  sensorEvents,
  snapshot,
  softStep,
  spawn,
  spawnCompound,
  stateHash,
  step,
} from '@principia/physics';
import { describe, expect, it, test } from 'vitest';
import { DT, G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

const refused = (code: string) => expect.objectContaining({ code });

describe('groups', () => {
  it('of equal sign and number collide always or never, others by their layers', () => {
    const world = rigidWorld();
    const fall = (x: number, floor: object, ball: object) => {
      spawn(world, { position: { x, y: -0.5 }, collider: { shape: box(1, 1), ...floor } });
      return spawn(world, { position: { x, y: 1 }, collider: { radius: 0.3, density: 1, ...ball } });
    };
    const held = [
      fall(0, {}, {}),
      fall(2, { group: 7, layers: 2 }, { group: 7, mask: 1 }),
      fall(4, { group: -1 }, { group: -2 }),
      fall(6, { group: -1 }, {}),
      fall(12, { group: 7, mask: 0 }, { group: 7, mask: 0 }),
    ];
    const through = [fall(8, { group: -4 }, { group: -4 }), fall(10, { group: 7, layers: 2 }, { group: 8, mask: 1 })];
    run(world, 1);
    const { y } = world.components.Position;
    for (const id of held) expect(y[id]).toBeCloseTo(0.3, 1);
    for (const id of through) expect(y[id]).toBeLessThan(-2);
  });

  it('are whole numbers', () => {
    const world = rigidWorld();
    expect(() => spawn(world, { collider: { radius: 1, group: 0.5 } })).toThrow(refused('E_RANGE'));
    expect(() => spawn(world, { collider: { radius: 1, group: 2 ** 24 } })).toThrow(refused('E_RANGE'));
    expect(() => spawn(world, { collider: { radius: 1, sensor: 2 } })).toThrow(refused('E_RANGE'));
    expect(() => spawn(world, { collider: { radius: 1, frictionCombine: 5 } })).toThrow(refused('E_RANGE'));
  });
});

describe('the function of the user', () => {
  it('is asked once about each pair, in ascending order, and false keeps the two apart until they part', () => {
    const asked: string[] = [];
    const world = rigidWorld({
      integrator: softStep({
        shouldCollide: (_, a, b) => {
          asked.push(`${a} ${b}`);
          return a !== 1;
        },
      }),
    });
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(20, 1) } });
    spawn(world, { position: { y: -5.5 }, collider: { shape: box(20, 1) } });
    const balls = [0, 1, 2].map((x) =>
      spawn(world, { position: { x: 2 * x, y: 0.5 }, collider: { radius: 0.4, density: 1 } }),
    );
    run(world, 2);
    expect(asked.slice(0, 3)).toEqual(['1 3', '1 4', '1 5']);
    expect(asked).toHaveLength(6);
    for (const id of balls) expect(world.components.Position.y[id]).toBeCloseTo(-4.6, 1);
    expect(contactEvents(world).begin.count).toBe(0);
  });

  it('may throw: the pair collides, the step completes, and the exception comes after it', () => {
    const world = rigidWorld({
      integrator: softStep({
        shouldCollide: () => {
          throw new Error('mine');
        },
      }),
    });
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(20, 1) } });
    const ball = spawn(world, { position: { y: 0.41 }, collider: { radius: 0.4, density: 1 } });
    expect(() => step(world, DT)).toThrow(AggregateError);
    run(world, 1);
    expect(world.components.Position.y[ball]).toBeCloseTo(0.4, 2);
    expect(() => softStep({ shouldCollide: 3 as never })).toThrow(refused('E_TYPE'));
  });

  it.each([0.2, 2, 4.9, 31])(
    'lets a fast body through that begins %d m in front of a wall, without a halt',
    (distance) => {
      const world = rigidWorld({ forces: [], integrator: softStep({ shouldCollide: () => false }) });
      spawn(world, { position: {}, collider: { shape: box(0.1, 10) } });
      const position = { x: -distance };
      const ball = spawn(world, { position, velocity: { x: 300 }, collider: { radius: 0.1, density: 1 } });
      run(world, 0.2);
      expect(world.components.Position.x[ball]).toBeCloseTo(60 - distance, 6);
    },
  );

  it('keeps a sensor from what it names, also where that is fast, and holds when it is no sensor any more', () => {
    const world = rigidWorld({ forces: [], integrator: softStep({ shouldCollide: (_, a) => a !== 1 }) });
    const area = spawn(world, { position: {}, collider: { shape: box(2, 10), sensor: true } });
    const slow = spawn(world, { position: { x: -0.9 }, velocity: { x: 1 }, collider: { radius: 0.2, density: 1 } });
    spawn(world, { position: { x: -2, y: 2 }, velocity: { x: 300 }, collider: { radius: 0.1, density: 1 } });
    for (let i = 0; i < 120; i++) {
      if (i === 60) world.components.Collider.sensor[area] = 0;
      step(world, DT);
      expect(sensorEvents(world).begin.count).toBe(0);
    }
    expect(world.components.Position.x[slow]).toBeCloseTo(1.1, 3);
  });

  it('keeps what it said over a snapshot', () => {
    const world = rigidWorld({ integrator: softStep({ shouldCollide: (_, a, b) => (a + b) % 2 === 0 }) });
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(20, 1) } });
    for (let i = 0; i < 12; i++)
      spawn(world, { position: { x: 0.3 * (i % 4), y: 1 + 0.4 * i }, collider: { radius: 0.3, density: 1 } });
    run(world, 0.5);
    const kept = snapshot(world);
    run(world, 1);
    const hash = stateHash(world);
    restore(world, kept);
    run(world, 1);
    expect(stateHash(world)).toBe(hash);
  });
});

describe.each(['f32', 'f64'] as const)('a one-way platform in %s', (precision) => {
  const platform = { shape: box(4, 0.2), oneWay: true, friction: 0.6 };

  it('holds what falls on it, and lets through what rises from below, to the height of a free throw', () => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: 2 }, collider: platform });
    const jumper = spawn(world, {
      position: {},
      velocity: { y: 8 },
      collider: { shape: box(0.5, 0.5), density: 1, friction: 0.6 },
    });
    const { Position, Velocity } = world.components;
    let top = 0;
    for (let i = 0; i < 120; i++) {
      step(world, DT);
      top = Math.max(top, Position.y[jumper]);
    }
    expect(Math.abs(top - 64 / (2 * G))).toBeLessThan(8 * (DT / 4));
    expect(Position.y[jumper]).toBeCloseTo(2.35, 2);
    expect(Math.abs(Velocity.y[jumper])).toBeLessThan(1e-3);
    // One that does not reach its upper side falls back.
    const low = spawn(world, { position: { x: 1.2 }, velocity: { y: 6.4 }, collider: { radius: 0.2, density: 1 } });
    run(world, 2);
    expect(Position.y[low]).toBeLessThan(-5);
  });

  it('stops fast bodies from above only', () => {
    const world = rigidWorld({ precision, forces: [] });
    spawn(world, { position: {}, collider: platform });
    const ball = { radius: 0.1, density: 1 };
    const down = spawn(world, { position: { x: -1, y: 5 }, velocity: { y: -300 }, collider: ball });
    const up = spawn(world, { position: { x: 1, y: -5 }, velocity: { y: 300 }, collider: ball });
    run(world, 0.5);
    expect(world.components.Position.y[down]).toBeGreaterThan(0.15);
    expect(world.components.Position.y[up]).toBeGreaterThan(100);
  });

  it('turns its upper side with it, carries as a kinematic lift, and as a part', () => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { x: -9 }, rotation: Math.PI, collider: platform });
    const through = spawn(world, { position: { x: -9, y: 2 }, collider: { radius: 0.3, density: 1 } });
    spawn(world, { position: {}, velocity: { y: 1 }, collider: platform });
    const carried = spawn(world, {
      position: { y: 0.6 },
      collider: { shape: box(0.5, 0.5), density: 1, friction: 0.6 },
    });
    spawnCompound(world, { position: { x: 9 }, parts: [{ ...platform, y: 1 }] });
    const onPart = spawn(world, { position: { x: 9, y: 2 }, collider: { radius: 0.3, density: 1 } });
    run(world, 2);
    const { y } = world.components.Position;
    expect(y[through]).toBeLessThan(-2);
    expect(y[carried]).toBeCloseTo(2.35, 1);
    expect(y[onPart]).toBeCloseTo(1.4, 1);
  });
});

test('friction and restitution combine by the rule of the larger number', () => {
  const speedAfter = (a: number, b: number, ruleA: number, ruleB: number) => {
    const world = rigidWorld({ forces: [], precision: 'f64' });
    const wall = { restitution: a, restitutionCombine: ruleA };
    spawn(world, { position: {}, collider: { shape: box(1, 10), ...wall } });
    const collider = { radius: 0.5, density: 1, restitution: b, restitutionCombine: ruleB };
    const ball = spawn(world, { position: { x: -2 }, velocity: { x: 10 }, collider });
    run(world, 0.5);
    return -world.components.Velocity.x[ball] / 10;
  };
  const { standard, average, min, multiply, max } = COMBINE;
  expect(speedAfter(0.8, 0.5, standard, standard)).toBeCloseTo(0.8, 5);
  expect(speedAfter(0.8, 0.5, average, standard)).toBeCloseTo(0.65, 5);
  expect(speedAfter(0.8, 0.5, average, min)).toBeCloseTo(0.5, 5);
  expect(speedAfter(0.8, 0.5, multiply, min)).toBeCloseTo(0.4, 5);
  expect(speedAfter(0.8, 0.5, multiply, max)).toBeCloseTo(0.8, 5);

  // A block slides v²/(2 μ g) far.
  const distance = (rule: number) => {
    const world = rigidWorld({ precision: 'f64' });
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(100, 1), friction: 0.9, frictionCombine: rule } });
    const block = spawn(world, {
      position: { y: 0.25 },
      velocity: { x: 5 },
      collider: { shape: box(1, 0.5), density: 1, friction: 0.4 },
    });
    run(world, 4);
    return world.components.Position.x[block];
  };
  for (const [rule, mu] of [
    [standard, Math.sqrt(0.36)],
    [average, 0.65],
    [min, 0.4],
    [multiply, 0.36],
    [max, 0.9],
  ]) {
    expect(distance(rule) / (25 / (2 * mu * G))).toBeCloseTo(1, 1);
  }
});
