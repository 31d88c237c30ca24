/**
 * Every example without a page: its description is complete, it runs without a fault, repeats itself, lets go of what it
 * made, ends where it always ended, and its figures are right. `test/browser/laboratory.test.ts` opens each on its page.
 */
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { energy, type Integrator, stateHash, step } from '@principia/physics';
import { beforeAll, describe, expect, it, vi } from 'vitest';
import { motionHash } from '../../../../test/support/chaos.ts';
import type { CheckState } from './check.ts';
import type { Example, ExampleRun } from './define-example.ts';
import { EXAMPLES } from './examples.gen.ts';
import { now, type Picture } from './picture.ts';

/** Names that the address of the laboratory uses for itself. */
const RESERVED =
  /^(example|seed|renderer|manual|integrator|ghosts|arrows|trails|step|camera|plot|folded|errors|search|code)$/;

/** Steps at the ends of parameters. */
const STEPS_AT_ENDS = 200;

/** Steps that every example takes at least. */
const STEPS = 600;

it('there are examples, each with a name of its own', () => {
  expect(EXAMPLES.length).toBeGreaterThan(4);
  expect(new Set(EXAMPLES.map(({ id }) => id)).size).toBe(EXAMPLES.length);
});

/** Takes the first `STEPS` steps. */
function runBriefly(run: ExampleRun): void {
  for (let i = 0; i < STEPS; i++) {
    step(run.world, run.dt);
    run.observe();
  }
}

/** Runs on until all checks are done, at most for the duration of the example. */
function runToEnd(run: ExampleRun, { duration }: Example): void {
  const steps = Math.ceil(duration / run.dt) + 1;
  for (let i = STEPS; i < steps && !run.isDone(); i++) {
    step(run.world, run.dt);
    run.observe();
  }
}

/** What is wrong with a figure that did not pass. */
function saysWhy(label: string, { state, computed, exact, error }: CheckState, duration: number): string {
  if (state === 'waiting') return `${label}: what it waits for does not happen within the duration, ${duration} s`;
  return `${label}: ${computed} instead of ${exact}, off by ${error}`;
}

/** Where the motion of each example that was run is after `STEPS` steps. */
const motions = new Map<string, string>();

setFlagsFromString('--expose-gc');
const collectGarbage = runInNewContext('gc') as () => void;

/** Starts an example and takes two steps; nothing but what is returned knows of the run. */
function startBriefly(example: Example): WeakRef<object>[] {
  const run = example.start();
  for (let i = 0; i < 2; i++) step(run.world, run.dt);
  run.observe();
  return [new WeakRef(run), new WeakRef(run.world)];
}

/** What the checks name: integrators, with the default values or a preset; first the example's own. */
function settingsOf({ checks }: Example): { integrator: Integrator | undefined; preset: string | undefined }[] {
  const settings = [{ integrator: undefined, preset: undefined }, ...checks];
  return settings
    .map(({ integrator, preset }) => ({ integrator, preset }))
    .filter((a, i, all) => i === all.findIndex((b) => a.integrator === b.integrator && a.preset === b.preset));
}

/** The presets, each parameter at either end, and all of them there at once. */
function settingsOfPage({ presets, parameters }: Example) {
  const ends = (['min', 'max'] as const).flatMap((end) => {
    const all = Object.entries(parameters).map(([name, parameter]) => ({ [name]: parameter[end] }));
    return [...all, Object.assign({}, ...all)];
  });
  return [
    ...presets.map(({ values }) => ({ values: values as Record<string, number>, isPreset: true })),
    ...ends.map((values) => ({ values, isPreset: false })),
  ];
}

/** Each slider at both ends and between, with a few of what is counted. */
function placesOfSliders({ parameters }: Example): Record<string, number>[] {
  const few = parameters.count?.integer ? { count: Math.max(parameters.count.min, 20) } : {};
  const sliders = Object.entries(parameters).filter(([, { integer = false }]) => !integer);
  return sliders.flatMap(([name, { min, max, scale }]) =>
    [0, 0.4, 1].map((share) => {
      const between = scale === 'log' ? min * (max / min) ** share : min + (max - min) * share;
      return { ...few, [name]: Math.min(max, between) };
    }),
  );
}

/** Values of plots that are no numbers. */
function gapsIn({ world, plots }: ExampleRun): string[] {
  return plots.flatMap(({ title, x, series }) => {
    const values = [x.value(), ...series.flatMap(({ value, exact }) => [value(), exact?.(world.time) ?? 0])];
    return values.every(Number.isFinite) ? [] : [`${title} at ${world.time} s: ${values.join(', ')}`];
  });
}

describe.each(EXAMPLES.map((entry) => [entry.id, entry] as const))('%s', (id, entry) => {
  let example: Example;
  beforeAll(async () => {
    example = await entry.load();
  });

  it('flies its camera, if at all, through places whose times lie in its duration', () => {
    const keys = example.start().picture.cameraPath ?? [];
    const times = keys.map(({ time }) => time);
    expect(times).toEqual(times.toSorted((a, b) => a - b));
    expect(new Set(times).size).toBe(times.length);
    expect(times.every((time) => time >= 0 && time <= example.duration)).toBe(true);
    if (keys.length > 0) expect([example.dimensions, keys.length > 1]).toEqual([3, true]);
  });

  it('says what it is', () => {
    expect(example).toMatchObject({ id, title: entry.title });
    expect(id).toMatch(new RegExp(`^ch${String(example.chapter).padStart(2, '0')}-[a-z0-9-]+$`));
    expect(example.about.length).toBeGreaterThan(60);
    expect(example.tags.length).toBeGreaterThan(0);
    expect(example.tryThis.length).toBeGreaterThan(0);
    expect(example.checks.length).toBeGreaterThan(0);
    expect(example.duration).toBeGreaterThan(0);
    for (const [name, { label, unit, initial, min, max, choices, integer }] of Object.entries(example.parameters)) {
      expect(name).not.toMatch(RESERVED);
      expect(label, name).not.toBe('');
      // A number without a unit has none.
      expect(unit, name).not.toBe('');
      expect(min, name).toBeLessThan(max);
      expect(initial, name).toBeGreaterThanOrEqual(min);
      expect(initial, name).toBeLessThanOrEqual(max);
      if (integer) expect(Number.isInteger(initial), name).toBe(true);
      if (choices !== undefined) expect([min, max, integer], name).toEqual([0, choices.length - 1, true]);
    }
  });

  it('passes its checks without a fault or a message, whenever it is run', () => {
    const messages: unknown[] = [];
    const spies = (['log', 'warn', 'error', 'info'] as const).map((name) =>
      vi.spyOn(console, name).mockImplementation((...text) => void messages.push(text)),
    );
    const judged = new Set<number>();
    for (const { integrator, preset } of settingsOf(example)) {
      const { values = {} } = example.presets.find(({ label }) => label === preset) ?? {};
      const options = { values: values as Record<string, number>, ...(integrator === undefined ? {} : { integrator }) };
      const [run, again] = [example.start(options), example.start(options)];
      for (const each of [run, again]) runBriefly(each);
      expect(stateHash(again.world)).toBe(stateHash(run.world));
      if (integrator === undefined && preset === undefined) motions.set(id, motionHash(run.world));
      runToEnd(run, example);
      for (const [i, state] of run.checkStates().entries()) {
        const { label, integrator: wanted, preset: meant } = example.checks[i];
        // A figure without an integrator is about the example's own, and one without a preset about the default values.
        const isOther = (wanted === undefined && integrator !== undefined) || meant !== preset;
        if (state.state === 'not applicable' || isOther) continue;
        judged.add(i);
        expect(state.state, saysWhy(label, state, example.duration)).toBe('passed');
      }
      expect(run.world.faults.faults).toEqual([]);
    }
    expect([...judged].sort((a, b) => a - b)).toEqual(example.checks.map((_, i) => i));
    for (const spy of spies) spy.mockRestore();
    expect(messages).toEqual([]);
  });

  it('is right with every preset and with every parameter at both ends, alone and together', () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    for (const { values, isPreset } of settingsOfPage(example)) {
      const run = example.start({ values });
      const settings = JSON.stringify(values);
      const all = Math.ceil(example.duration / run.dt) + 1;
      // Presets until all figures are judged, ends of parameters only briefly.
      for (let i = 0; i < all && (i < STEPS_AT_ENDS || (isPreset && !run.isDone())); i++) {
        step(run.world, run.dt);
        run.observe();
        if (i % 16 === 0) expect(gapsIn(run), settings).toEqual([]);
      }
      for (const [i, { state, computed, exact }] of run.checkStates().entries()) {
        const figure = `${settings}, ${example.checks[i].label}: ${computed} instead of ${exact}`;
        expect(state, figure).not.toBe('failed');
        // No figure of a run that has ended is still waiting.
        if (example.ends && isPreset) expect(state, figure).not.toBe('waiting');
      }
      expect(run.world.faults.faults, settings).toEqual([]);
      expect(warn.mock.calls, settings).toEqual([]);
    }
    warn.mockRestore();
  }, 300_000);

  it('conserves its energy over its whole duration, if at all, wherever the sliders are', () => {
    if (!example.conservesEnergy) return;
    for (const values of placesOfSliders(example)) {
      const run = example.start({ values });
      const { total, potential } = energy(run.world);
      for (let i = 0; i < example.duration / run.dt; i++) step(run.world, run.dt);
      const change = energy(run.world).total - total;
      expect(Math.abs(change), JSON.stringify(values)).toBeLessThan(1e-6 * Math.abs(potential));
      expect(run.world.faults.faults).toEqual([]);
    }
  }, 60_000);

  it('takes presses on its picture without a fault, if any', () => {
    const { pointer, dimensions, actions } = example;
    if (pointer === undefined) return;
    expect(pointer.about.length).toBeGreaterThan(10);
    // Who has no pointer has a key.
    expect(Object.keys(actions)).not.toEqual([]);
    // In three dimensions a drag turns the view.
    if (dimensions === 3) expect(pointer.aims ?? false).toBe(false);
    const run = example.start();
    const { minX, maxX, minY, maxY } = run.picture.view;
    const at = (x: number, y: number) => ({ x: minX + x * (maxX - minX), y: minY + y * (maxY - minY) });
    for (let i = 0; i < 100; i++) {
      const [from, to] = [at((i % 10) / 9, i / 99), at((i % 7) / 6, (i % 5) / 4)];
      run.point('press', from, from);
      for (let k = 0; k < 3; k++) step(run.world, run.dt);
      run.point('move', to, from);
      run.point(i % 4 === 3 ? 'cancel' : 'release', to, from);
      step(run.world, run.dt);
    }
    expect(run.world.faults.faults).toEqual([]);
  });

  it('holds on to nothing when it is started again and again', async () => {
    const made: WeakRef<object>[] = [];
    // Each run is looked for by itself, so that ten tell as much as fifty.
    for (let i = 0; i < 10; i++) made.push(...startBriefly(example));
    const held = () => made.filter((reference) => reference.deref() !== undefined).length;
    // What weak references were asked for stays until the end of the task.
    for (let i = 0; i < 10 && held() > 2; i++) {
      await new Promise((done) => setTimeout(done));
      collectGarbage();
    }
    // The last one may still be on the stack.
    expect(held()).toBeLessThanOrEqual(2);
  });

  it('shows and plots only finite numbers', () => {
    const run = example.start();
    for (let i = 0; i < 30; i++) step(run.world, run.dt);
    for (const number of numbersIn(run.picture, run.world.time)) expect(number).toBeTypeOf('number');
    for (const number of numbersIn(run.picture, run.world.time)) expect(Number.isFinite(number)).toBe(true);
    for (const { x, y, series } of run.plots) {
      // The unit follows the comma.
      for (const { label } of [x, y]) expect(label).toMatch(/^[^,]+(, [^,]+)?$/);
      for (const { value } of [x, ...series]) expect(Number.isFinite(value())).toBe(true);
      for (const { exact } of series) expect(Number.isFinite(exact?.(run.world.time) ?? 0)).toBe(true);
    }
    for (const { x, densities, exact = () => 0 } of run.histograms) {
      for (const value of [...densities(), exact(x.min), exact(x.max)]) expect(Number.isFinite(value)).toBe(true);
    }
  });
});

/**
 * See `test/determinism/golden.test.ts` for what another hash means. `npx vitest run --project unit` with the path of this
 * file and `-u` writes that of a new example.
 */
it('600 steps of every example end where they always ended', async (context) => {
  if (motions.size < EXAMPLES.length) return context.skip('Not all examples were run.');
  const lines = EXAMPLES.map(({ id }) => `${motions.get(id)} ${id}\n`);
  await expect(lines.join('')).toMatchFileSnapshot('../../../../test/determinism/example-hashes.txt');
});

/** The coordinates of everything in a picture. */
function numbersIn(picture: Picture, time: number): number[] {
  const { view, lines = [], curves = [], arrows = [], dots = [], labels = [] } = picture;
  const points = [
    ...lines.flatMap(({ from, to }) => [now(from), now(to)]),
    ...curves.flatMap((curve) => [...curve.points, ...(curve.now === undefined ? [] : [curve.now(time)])]),
    ...arrows.flatMap(({ from, vector }) => [now(from), vector()]),
    ...[...dots, ...labels].map(({ at }) => now(at)),
  ];
  return [...Object.values(view), ...points.flatMap(({ x, y, z = 0 }) => [x, y, z])];
}
