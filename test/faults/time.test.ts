import {
  box,
  contactEvents,
  createRunner,
  destroyWorld,
  type PhysicsWorld,
  spawn,
  stateHash,
  step,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { rigidWorld } from '../support/rigid-world.ts';
import {
  assertRefused,
  assertWorldAlive,
  ball,
  DT,
  groundWorld,
  refusal,
  steps,
  worldState,
} from '../support/worlds.ts';

function bouncing(): PhysicsWorld {
  const world = groundWorld();
  for (let i = 0; i < 5; i++) ball(world, i, 1 + i, { x: i - 2 });
  return world;
}

describe('time', () => {
  it('44 step(0) has no effect', () => {
    const world = bouncing();
    step(world, DT);
    const before = worldState(world);
    step(world, 0);
    step(world, -0);
    expect(worldState(world)).toEqual(before);
  });

  it.each([-1, -1e-300])('45 a negative dt (%d) throws without moving bodies', (dt) => {
    const world = bouncing();
    assertRefused(world, () => step(world, dt), { code: 'E_RANGE', field: 'dt', value: dt });
    assertWorldAlive(world);
  });

  it.each([NaN, Infinity, -Infinity])('46 dt %d throws without moving bodies', (dt) => {
    const world = bouncing();
    assertRefused(world, () => step(world, dt), { code: 'E_NONFINITE', field: 'dt', value: dt });
    assertWorldAlive(world);
  });

  it.each([undefined, '0.016', 1n, null])('46 a dt of another type (%s) throws without moving bodies', (dt) => {
    const world = bouncing();
    assertRefused(world, () => step(world, dt as never), { code: 'E_TYPE', field: 'dt' });
  });

  it.each([1e13, Number.MAX_VALUE])('46 a dt of %d s is refused, because the sum of times must stay finite', (dt) => {
    assertRefused(bouncing(), () => step(bouncing(), dt), { code: 'E_RANGE', field: 'dt' });
  });

  it('46 a NaN world time is refused until it is finite again', () => {
    const world = bouncing();
    world.time = NaN;
    expect(refusal(() => step(world, DT)).code).toBe('E_NONFINITE');
    world.time = 0;
    assertWorldAlive(world);
  });

  it('47 a frame of 10 s is clamped by the runner and the rest is counted', () => {
    const world = bouncing();
    const runner = createRunner(world);
    expect(runner.advance(10)).toBe(15);
    expect(runner.droppedTime).toBe(9.75);
    expect(world.time).toBeCloseTo(0.25, 12);
    assertWorldAlive(world);
  });

  it('48 a step of 1e-12 s moves bodies by v dt without loss', () => {
    const world = bouncing();
    const { Position, Velocity } = world.components;
    const [x, v] = [Position.x[1], Velocity.x[1]];
    steps(world, 1000, 1e-12);
    // A thousand additions of 2e-12 to a number near 1, each rounded to half an ulp (1.1e-16).
    expect(Math.abs(Position.x[1] - (x + v * 1e-9))).toBeLessThan(1000 * 1.2e-16);
    expect(world.faults.faults).toEqual([]);
    assertWorldAlive(world);
  });

  it('48 a step below the minimum of 1e-20 s is refused', () => {
    const world = groundWorld({ precision: 'f32' });
    ball(world, 0, 0.05, { y: -3 }); // into the floor: the wall divides by dt
    step(world, 1e-20);
    expect(world.faults.faults).toEqual([]);
    assertRefused(world, () => step(world, 1e-30), { code: 'E_RANGE', field: 'dt' });
    assertWorldAlive(world);
  });

  it('48 a runner with more than a million steps per frame is refused', () => {
    expect(refusal(() => createRunner(bouncing(), { dt: 1e-12 }))).toMatchObject({ code: 'E_RANGE', field: 'dt' });
    expect(createRunner(bouncing(), { dt: 1e-6, maxFrame: 1e-3 }).advance(1)).toBe(1000);
  });

  it('49 an hour in a hidden tab costs a single clamped frame', () => {
    const world = bouncing();
    const runner = createRunner(world);
    runner.advance(1 / 60);
    expect(runner.advance(3600)).toBe(15);
    expect(runner.advance(1 / 60)).toBe(1);
    expect(runner.droppedTime).toBeCloseTo(3600 - 0.25, 9);
  });

  it('50 irregular frame times give the trajectory of constant ones', () => {
    // 60 times 55 ms are 3.3 s, and so are 200 times 16.5 ms: 198 steps of 1/60 s, the last one only just.
    const play = (frames: readonly number[], times: number) => {
      const world = bouncing();
      const runner = createRunner(world);
      const hashes: string[] = [];
      world.phases.events.push(() => hashes.push(stateHash(world)));
      for (let i = 0; i < times; i++) for (const ms of frames) runner.advance(ms / 1000);
      return hashes;
    };
    const jittery = play([1, 1, 50, 0, 0, 3], 60);
    const constant = play([16.5], 200);
    expect(constant).toHaveLength(198);
    expect(jittery).toEqual(constant);
  });

  it.each([-1, NaN, Infinity, '1', undefined])('a frame time of %s is refused', (elapsed) => {
    const world = bouncing();
    const runner = createRunner(world);
    runner.advance(0.01);
    const { alpha } = runner;
    refusal(() => runner.advance(elapsed as number));
    expect([runner.alpha, runner.droppedTime, world.tick]).toEqual([alpha, 0, 0]);
  });

  it.each([
    [{ dt: 0 }, 'E_RANGE'],
    [{ dt: -1 }, 'E_RANGE'],
    [{ dt: NaN }, 'E_NONFINITE'],
    [{ dt: '1' }, 'E_TYPE'],
    [{ dt: 1, maxFrame: 0.5 }, 'E_RANGE'],
    [{ afterStep: 1 }, 'E_TYPE'],
    [{ step: 1 }, 'E_UNKNOWN'],
    [null, 'E_TYPE'],
  ])('a runner with options %o is refused with %s', (options, code) => {
    expect(refusal(() => createRunner(bouncing(), options as never)).code).toBe(code);
  });

  // A frame of 1/30 s has two steps, and every fourth of 1/240 s has one.
  it.each([1 / 30, 1 / 60, 1 / 240])('in frames of %f s each event of a step is read once', (frame) => {
    const fall = () => {
      const world = rigidWorld();
      spawn(world, { position: { y: -1 }, collider: { shape: box(50, 2) } });
      for (let i = 0; i < 8; i++) {
        const collider = { radius: 0.2, density: 1, restitution: 0.8 };
        spawn(world, { position: { x: i, y: 1 + i / 4 }, velocity: {}, rotation: 0, angularVelocity: 0, collider });
      }
      return world;
    };
    let expected = 0;
    const stepped = fall();
    for (let i = 0; i < 180; i++) {
      step(stepped, 1 / 60);
      expected += contactEvents(stepped).hit.count;
    }
    expect(expected).toBeGreaterThan(16);
    let read = 0;
    const runner = createRunner(fall(), { afterStep: (world) => (read += contactEvents(world).hit.count) });
    for (let i = 0; i < Math.round(3 / frame); i++) runner.advance(frame);
    expect(read).toBe(expected);
  });

  it('a runner continues after a step that threw, and accumulates at most a frame', () => {
    const world = bouncing();
    const runner = createRunner(world);
    world.phases.input.push(() => {
      throw new Error('oops');
    });
    for (let i = 0; i < 100; i++) expect(() => runner.advance(0.25)).toThrow(AggregateError);
    expect(world.tick).toBe(100);
    world.phases.input.pop();
    expect(runner.advance(0)).toBeLessThanOrEqual(15 + 1);
    // All time passed in was simulated, dropped, or remains for the next step.
    expect(world.time + runner.droppedTime + runner.alpha * runner.dt).toBeCloseTo(25, 9);
  });

  it('a runner inside its own afterStep is refused, and runs on at the next call', () => {
    const world = bouncing();
    let inner: string | undefined;
    const runner = createRunner(world, {
      afterStep: () => {
        inner = refusal(() => runner.advance(1)).code;
      },
    });
    expect(runner.advance(1 / 60)).toBe(1);
    expect(inner).toBe('E_REENTRANT');
    expect(runner.advance(1 / 30)).toBe(2);
    expect(world.tick).toBe(3);
  });

  it('a runner during a step is refused, and stops if its world is destroyed in a step', () => {
    const world = bouncing();
    const runner = createRunner(world);
    let inner: string | undefined;
    world.phases.input.push(() => {
      inner = refusal(() => runner.advance(1)).code;
    });
    runner.advance(1 / 60);
    expect(inner).toBe('E_REENTRANT');
    world.phases.input.push((w) => destroyWorld(w));
    expect(runner.advance(0.25)).toBe(1);
    expect(refusal(() => runner.advance(0.25)).code).toBe('E_DESTROYED');
    expect(refusal(() => createRunner(world)).code).toBe('E_DESTROYED');
  });
});
