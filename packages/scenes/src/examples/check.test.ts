import { createPhysicsWorld, restore, snapshot, spawn, step, uniformGravity } from '@principia/physics';
import { expect, test } from 'vitest';
import { type Check, monitor } from './check.ts';

const DT = 1 / 64;

/** A stone thrown upwards at 8 m/s, in a gravity of 8 m/s²: it is back after 2 s. */
function throwStone() {
  const world = createPhysicsWorld({ capacity: 2, forces: [uniformGravity({ y: -8 })] });
  const stone = spawn(world, { position: {}, velocity: { y: 8 }, mass: 1 });
  return { world, dt: DT, height: () => world.components.Position.y[stone] };
}

type Run = ReturnType<typeof throwStone>;
const height = (run: Run) => run.height();
const check = (own: Partial<Check<Run, object>> & Pick<Check<Run, object>, 'at'>): Check<Run, object> => ({
  label: 'height',
  unit: 'm',
  exact: 4,
  tolerance: { absolute: 1e-9 },
  measure: height,
  ...own,
});

function watch(checks: readonly Check<Run, object>[], seconds: number, isDefault = true) {
  const run = throwStone();
  const watched = monitor(run, {}, {}, checks, () => isDefault);
  const advance = (steps: number) => {
    for (let i = 0; i < steps; i++) step(run.world, DT);
    watched.observe();
  };
  advance(seconds / DT);
  return { run, advance, ...watched };
}

test('measures at a time, and says by how much the figure is off', () => {
  const { states } = watch([check({ at: { time: 1 } }), check({ at: { time: 1.5 } }), check({ at: { time: 3 } })], 2);
  expect(states()[0]).toMatchObject({ state: 'passed', computed: expect.closeTo(4, 12) });
  // 8 t - 4 t² = 3 after 1.5 s.
  expect(states()[1]).toMatchObject({ state: 'failed', error: expect.closeTo(1, 12) });
  expect(states()[2]).toMatchObject({ state: 'waiting', computed: Number.NaN });
});

test('measures at an event, interpolated between two steps', () => {
  const falls = check({ at: { event: (run) => 3 - run.height() }, measure: ({ world }) => world.time, exact: 1.5 });
  const { states } = watch([falls], 2);
  // The height passes 3 m in a step whose middle is off the chord by g dt²/8 at a speed of 4 m/s.
  expect(Math.abs(states()[0].computed - 1.5)).toBeLessThan((8 * DT * DT) / 8 / 4);
});

test('measures between two events, and the largest, smallest and mean value', () => {
  const periods = check({
    at: { event: ({ world }) => -Math.cos(world.time * Math.PI), from: 1, to: 2 },
    measure: ({ world }) => world.time,
    exact: 2,
    tolerance: { relative: 1e-3 },
  });
  const all = (['largest', 'smallest', 'mean'] as const).map((take) => check({ at: { until: 2, take } }));
  const { states } = watch([periods, ...all], 4);
  const [period, largest, smallest, mean] = states().map(({ computed }) => computed);
  expect(period).toBeCloseTo(2, 3);
  expect(largest).toBeCloseTo(4, 12);
  expect(smallest).toBeCloseTo(0, 12);
  // The mean of 8 t - 4 t² over 2 s is 8/3; the trapezoid rule and one more point change it by some dt.
  expect(Math.abs(mean - 8 / 3)).toBeLessThan(2 * DT);
});

test('a plain figure holds for the values it belongs to, a function for all', () => {
  const checks = [check({ at: { time: 1 } }), check({ at: { time: 1 }, exact: () => 4 })];
  expect(
    watch(checks, 2, false)
      .states()
      .map(({ state }) => state),
  ).toEqual(['not applicable', 'passed']);
});

test('a figure is judged only where its exact value holds, and is a number', () => {
  const at = { time: 1 };
  const { states, isDone } = watch(
    [check({ at, exact: () => 4, holds: () => false }), check({ at, exact: () => Math.sqrt(-1) })],
    0,
  );
  expect(states().map(({ state }) => state)).toEqual(['no figure', 'no figure']);
  expect(isDone()).toBe(true);
});

test('where the exact value is about 0, what is rounding to that of the default settings is no error', () => {
  const measured = (value: number): Check<Run, { readonly scale: number }> => ({
    label: 'height',
    exact: ({ scale }) => 4 * scale,
    tolerance: { relative: 1e-3 },
    at: { time: 0 },
    measure: () => value,
  });
  // A height of 0 where it is 4 m by default, and rounding of 1e-12 of that.
  const checks = [0, 3.9e-12, 4.1e-12].map(measured);
  const { states } = monitor(throwStone(), { scale: 0 }, { scale: 1 }, checks, () => false);
  expect(states().map(({ state, error }) => [state, error])).toEqual([
    ['passed', 0],
    ['passed', 0],
    ['failed', Number.POSITIVE_INFINITY],
  ]);
});

test('rewinding the world rewinds its checks', () => {
  const run = throwStone();
  const { observe, states, isDone } = monitor(run, {}, {}, [check({ at: { time: 1 } })], () => true);
  const start = snapshot(run.world);
  for (let i = 0; i < 70; i++) step(run.world, DT);
  observe();
  expect(isDone()).toBe(true);
  restore(run.world, start);
  expect(states()[0].state).toBe('waiting');
});
