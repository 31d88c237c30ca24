// What is changed about a sleeping body, or about what it lies on, wakes it.
import {
  asleepCount,
  box,
  COMBINE,
  circle,
  despawn,
  isAsleep,
  type PhysicsWorld,
  setShape,
  spawn,
  spawnCompound,
  step,
  thrust,
  uniformGravity,
} from '@principia/physics';
import { addComponent, removeComponent, set } from 'bitecs';
import { describe, expect, test } from 'vitest';
import { DT, G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

describe('a body whose locked axis is opened falls', () => {
  const ways: Record<string, (world: PhysicsWorld, body: number) => void> = {
    'by the column': ({ components }, body) => {
      components.MotionLocks.y[body] = 0;
    },
    'by another component': (world, body) => addComponent(world, body, set(world.components.MotionLocks, { y: 0 })),
    'without the component': (world, body) => removeComponent(world, body, world.components.MotionLocks),
  };
  test.each(Object.entries(ways))('%s', (_name, open) => {
    const world = rigidWorld();
    const body = spawn(world, { position: {}, motionLocks: { y: true }, collider: { radius: 0.5, density: 1 } });
    run(world, 1);
    expect(isAsleep(world, body)).toBe(true);
    open(world, body);
    run(world, 1);
    // Semi-implicit Euler with 240 sub-steps: g t²/2 · (1 + 1/240).
    expect(world.components.Position.y[body]).toBeCloseTo(-0.5 * G * (1 + 1 / 240), 3);
  });
});

const ANGLE = 0.3;

/** A slope through the origin that something of `collider` sleeps on, and how far that has moved a second after a change. */
function slide(
  angle: number,
  addSlope: (world: PhysicsWorld) => number,
  collider: object,
  change: (world: PhysicsWorld, slope: number) => void,
): number {
  const world = rigidWorld();
  const slope = addSlope(world);
  const position = { x: 0.5 * Math.sin(angle), y: 0.5 * Math.cos(angle) };
  const body = spawn(world, { rotation: -angle, position, collider: { density: 1, friction: 1, ...collider } });
  run(world, 2);
  expect(isAsleep(world, body)).toBe(true);
  const { Position } = world.components;
  const [x, y] = [Position.x[body], Position.y[body]];
  change(world, slope);
  run(world, 1);
  return Math.hypot(Position.x[body] - x, Position.y[body] - y);
}

const BLOCK = { shape: box(1, 1) };
const [SINE, COSINE] = [Math.sin(ANGLE), Math.cos(ANGLE)];
/** The way of a block on a slope without friction in 1 s, m. */
const FREE_SLIDE = 0.5 * G * SINE;

/** The upper face of a slope, as a body or as the part of one. */
const plate = (angle: number, more: object) => ({
  position: { x: -0.5 * Math.sin(angle), y: -0.5 * Math.cos(angle) },
  rotation: -angle,
  collider: { shape: box(50, 1), ...more },
});

describe('what lies on a surface slides when that loses its friction', () => {
  const cases: Record<string, [(world: PhysicsWorld) => number, (world: PhysicsWorld, slope: number) => void]> = {
    'of a half-plane': [
      (world) => spawn(world, { planeWall: { nx: SINE, ny: COSINE, friction: 1 } }),
      ({ components }, slope) => {
        components.PlaneWall.friction[slope] = 0;
      },
    ],
    'of a segment': [
      (world) =>
        spawn(world, {
          segmentWall: { ax: -20 * COSINE, ay: 20 * SINE, bx: 20 * COSINE, by: -20 * SINE, friction: 1 },
        }),
      ({ components }, slope) => {
        components.SegmentWall.friction[slope] = 0;
      },
    ],
    'of a part': [
      (world) => {
        const { position, rotation, collider } = plate(ANGLE, { friction: 1 });
        return spawnCompound(world, { position, rotation, parts: [collider] }).parts[0];
      },
      ({ components }, slope) => {
        components.Collider.friction[slope] = 0;
      },
    ],
    'by its rule of friction': [
      (world) => spawn(world, plate(ANGLE, { friction: 0, frictionCombine: COMBINE.max })),
      ({ components }, slope) => {
        components.Collider.frictionCombine[slope] = COMBINE.min;
      },
    ],
  };
  test.each(Object.entries(cases))('%s', (_name, [addSlope, change]) => {
    // It starts a step late, and takes g t h/2 too long a way: 3 % and 0.4 %.
    expect(slide(ANGLE, addSlope, BLOCK, change) / FREE_SLIDE).toBeCloseTo(1, 1);
  });

  test('a disc rolls when the resistance is gone', () => {
    const addSlope = (world: PhysicsWorld) => spawn(world, plate(0.1, { friction: 1, rollingResistance: 0.3 }));
    const way = slide(0.1, addSlope, { shape: circle(0.5) }, ({ components }, slope) => {
      components.Collider.rollingResistance[slope] = 0;
    });
    // A disc rolls with 2/3 of the acceleration.
    expect(way / (0.5 * G * Math.sin(0.1) * (2 / 3))).toBeCloseTo(1, 1);
  });

  test('a belt starts that is a part', () => {
    const world = rigidWorld();
    const { parts } = spawnCompound(world, { position: { y: -0.5 }, parts: [{ shape: box(50, 1), friction: 1 }] });
    const load = spawn(world, { position: { y: 0.5 }, collider: { shape: box(1, 1), density: 1, friction: 1 } });
    run(world, 1);
    world.components.Collider.tangentSpeed[parts[0]] = 1;
    run(world, 2);
    expect(Math.abs(world.components.Velocity.x[load])).toBeCloseTo(1, 2);
  });
});

describe('what lies on a part', () => {
  const settle = (parts: object[]) => {
    const world = rigidWorld();
    const ground = spawnCompound(world, { position: { y: -0.5 }, parts: [{ shape: box(20, 1), friction: 1 }] });
    const tower = spawnCompound(world, { position: { y: 0.5 }, parts });
    run(world, 1);
    expect(asleepCount(world)).toBe(1);
    return { world, ground, tower };
  };
  const cube = { shape: box(1, 1), density: 1 };

  test('moves with its shape', () => {
    const { world, ground, tower } = settle([cube]);
    setShape(world, ground.parts[0], box(20, 0.5));
    run(world, 1);
    expect(world.components.Position.y[tower.body]).toBeCloseTo(0.25, 2);
  });

  test('is pushed out when a part of its own grows', () => {
    const { world, tower } = settle([cube, { ...cube, y: 1 }]);
    const { y } = world.components.Position;
    const before = y[tower.body];
    setShape(world, tower.parts[0], box(1, 2));
    run(world, 2);
    expect(y[tower.body] - before).toBeCloseTo(0.5, 2);
  });

  test('falls when the part is moved away within its body', () => {
    const { world, ground, tower } = settle([cube]);
    world.components.Attachment.y[ground.parts[0]] -= 0.2;
    run(world, 1);
    expect(world.components.Position.y[tower.body]).toBeCloseTo(0.3, 2);
  });
});

test('what lies on a kinematic body sleeps on while that stands, and wakes when it starts', () => {
  const world = rigidWorld();
  const collider = { shape: box(10, 1), friction: 1, density: 1 };
  const platform = spawn(world, { position: { y: -0.5 }, velocity: {}, kinematic: {}, collider });
  const load = spawn(world, { position: { y: 0.5 }, collider: { shape: box(1, 1), density: 1, friction: 1 } });
  run(world, 1);
  for (let i = 0; i < 60; i++) {
    run(world, 1 / 60);
    expect(isAsleep(world, load)).toBe(true);
  }
  world.components.Velocity.x[platform] = 0.5;
  run(world, 3);
  expect(world.components.Velocity.x[load]).toBeCloseTo(0.5, 3);
  world.components.Velocity.x[platform] = 0;
  run(world, 3);
  expect(isAsleep(world, load)).toBe(true);
  world.components.Position.y[platform] -= 1;
  run(world, 2);
  expect(world.components.Position.y[load]).toBeCloseTo(-0.5, 2);
});

describe.each([0.2, 2])('a floor that becomes one-way %s s after a box has landed', (seconds) => {
  const boxOn = (rotation: number) => {
    const world = rigidWorld();
    const floor = spawn(world, { position: { y: -0.5 }, rotation, collider: { shape: box(20, 1) } });
    const body = spawn(world, { position: { y: 0.5 }, collider: { shape: box(1, 1), density: 1 } });
    run(world, seconds);
    world.components.Collider.oneWay[floor] = 1;
    run(world, 1);
    return world.components.Position.y[body];
  };

  test('holds it on the upper side', () => {
    expect(boxOn(0)).toBeCloseTo(0.5, 2);
  });

  test('lets it fall where that is below', () => {
    // A step passes before it falls, and semi-implicit Euler takes g t h/2 too long a way.
    expect(boxOn(Math.PI)).toBeCloseTo(0.5 - 0.5 * G, 0);
  });
});

describe.each(['f32', 'f64'] as const)('a thrust of one step in %s', (precision) => {
  // What wakes is what would gain 1 cm/s in a second; the others are common.
  test.each([0.02, 1, 100])('of %d N gives a sleeping body its whole impulse', (force) => {
    const world = rigidWorld({ precision, forces: [uniformGravity(), thrust()] });
    const collider = { shape: box(1, 1), friction: 0 };
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1), friction: 0 } });
    const body = spawn(world, { position: { y: 0.5 }, mass: 1, collider, thrust: {} });
    run(world, 2);
    expect(isAsleep(world, body)).toBe(true);
    const { Thrust, Velocity } = world.components;
    Thrust.x[body] = force;
    step(world, DT);
    Thrust.x[body] = 0;
    // F Δt/m to the rounding of four sums.
    const speed = force * DT;
    const rounding = 8 * 2 ** (precision === 'f32' ? -24 : -53) * speed;
    expect(Math.abs((Velocity.x[body] as number) - speed)).toBeLessThan(rounding);
    step(world, DT);
    expect(Math.abs((Velocity.x[body] as number) - speed)).toBeLessThan(rounding);
  });
});

describe('what sleeps on something that holds it no longer falls in the same step', () => {
  const ways: Record<string, (world: PhysicsWorld, ground: number) => void> = {
    'because it is gone': (world, ground) => despawn(world, ground),
    'because it was moved away': ({ components }, ground) => {
      components.Position.x[ground] += 100;
    },
    'because it collides with nothing': ({ components }, ground) => {
      components.Collider.mask[ground] = 0;
    },
    'because it is in another layer': ({ components }, ground) => {
      components.Collider.layers[ground] = 0;
    },
    'because it is a sensor': ({ components }, ground) => {
      components.Collider.sensor[ground] = 1;
    },
  };
  test.each(Object.entries(ways))('%s', (_name, change) => {
    const world = rigidWorld();
    const ground = spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1) } });
    // The upper one touches only what sleeps as well.
    const bodies = [0.5, 1.5].map((y) =>
      spawn(world, { position: { y }, collider: { shape: box(1, 1), density: 10 } }),
    );
    run(world, 2);
    expect(asleepCount(world)).toBe(2);
    change(world, ground);
    step(world, DT);
    for (const body of bodies) expect(world.components.Velocity.y[body]).toBeCloseTo(-G * DT, 3);
  });

  test('because it was a part of a static compound', () => {
    const world = rigidWorld();
    const shape = box(1, 1);
    const { parts } = spawnCompound(world, { position: {}, parts: [{ shape, x: -2 }, { shape }] });
    const { x, y } = world.components.Position;
    const [column, floor] = [x[parts[1]], y[parts[1]]];
    const body = spawn(world, { position: { x: column, y: floor + 1 }, collider: { shape, density: 10 } });
    run(world, 2);
    expect(isAsleep(world, body)).toBe(true);
    despawn(world, parts[1]);
    step(world, DT);
    expect(world.components.Velocity.y[body]).toBeCloseTo(-G * DT, 3);
  });
});
