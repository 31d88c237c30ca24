import { createPhysicsWorld, despawn, restore, snapshot, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { createTestBodySource } from '../../../test/support/body-source.ts';
import { TEXTURE_WIDTH } from './column-upload.ts';
import { TrailHistory } from './trails.ts';
import { worldSource } from './world-source.ts';

function sourceWith(ids: number[], dimensions: 2 | 3 = 2) {
  const source = createTestBodySource(2048, dimensions, 'f64');
  source.show(ids);
  return source;
}

describe('TrailHistory', () => {
  it('keeps one slice a recording, in a ring', () => {
    const source = sourceWith([1, 1500]);
    const history = new TrailHistory({ source, length: 3 });
    expect(history.rowsPerSlice).toBe(2);
    for (let step = 0; step < 5; step++) {
      source.position.x[1] = step;
      source.position.y[1500] = 10 * step;
      expect(history.record()).toBe(true);
    }
    expect(history.newestSlice).toBe(1);
    const slice = (k: number, slot: number) => k * 2 * TEXTURE_WIDTH + slot;
    expect([0, 1, 2].map((k) => history.x[slice(k, 1)])).toEqual([3, 4, 2]);
    expect([0, 1, 2].map((k) => history.y[slice(k, 1500)])).toEqual([30, 40, 20]);
    expect(history.z.length).toBe(0);
  });

  it('gathers chosen bodies into consecutive slots', () => {
    const source = sourceWith([2, 5, 9], 3);
    source.position.z[9] = 4;
    const history = new TrailHistory({ source, length: 2, bodies: [9, 2] });
    history.record();
    expect(history.rowsPerSlice).toBe(1);
    expect(history.count).toBe(2);
    expect([history.z[0], history.z[1]]).toEqual([4, 0]);
  });

  it('notes when a body came, so that a reused id does not inherit a trail', () => {
    const source = sourceWith([1, 2]);
    const history = new TrailHistory({ source, length: 4 });
    history.record();
    history.record();
    source.show([1]);
    history.record();
    source.show([1, 2]);
    const before = history.birthVersion;
    history.record();
    expect(history.birth[1]).toBe(0);
    expect(history.birth[2]).toBe(3);
    expect(history.birthVersion).toBe(before + 1);
    history.record();
    expect(history.birthVersion).toBe(before + 1);
    history.restart(1);
    history.record();
    expect(history.birth[1]).toBe(5);
  });

  it('keeps every n-th pose and says whether the newest is the current one', () => {
    const source = sourceWith([1]);
    const history = new TrailHistory({ source, length: 4, interval: 3 });
    const written = [0, 1, 2, 3, 4, 5, 6].map(() => [history.record(), history.newestIsCurrent]);
    expect(written.map(([wrote]) => wrote)).toEqual([true, false, false, true, false, false, true]);
    expect(written.every(([wrote, current]) => wrote === current)).toBe(true);
  });

  it('records relative to an origin and can move it', () => {
    const source = sourceWith([1]);
    source.position.x[1] = 1e9 + 0.25;
    const history = new TrailHistory({ source, length: 2, origin: { x: 1e9, y: 0 } });
    history.record();
    expect(history.x[1]).toBe(0.25);
    history.setOrigin(1e9 - 2, 0);
    expect(history.x[1]).toBe(2.25);
    expect(history.resetVersion).toBe(1);
  });

  it('forgets everything on clear', () => {
    const source = sourceWith([1]);
    const history = new TrailHistory({ source, length: 4 });
    history.record();
    history.record();
    history.clear();
    expect(history.birth[1]).toBe(2);
    history.record();
    expect(history.birth[1]).toBe(2);
  });

  it('says what is wrong with its options', () => {
    const source = sourceWith([1]);
    expect(() => new TrailHistory({ source, length: 1 })).toThrow(/at least 2, got 1/);
    expect(() => new TrailHistory({ source, length: 3, interval: 0 })).toThrow(/interval.*got 0/);
    expect(() => new TrailHistory({ source, length: 3, bodies: [1, 9999] })).toThrow(/bodies\[1\].*2047, got 9999/);
  });
});

/** A world with two bodies, and the number of points that the trail in a slot has, at most 8. */
function worldWithTrails(options: { listed?: boolean; interval?: number }) {
  const world = createPhysicsWorld({ capacity: 10 });
  const ids = [3, 5].map((x) => spawn(world, { position: { x }, velocity: { x: 1 } }));
  const bodies = options.listed ? { bodies: ids } : {};
  const { interval = 1 } = options;
  const history = new TrailHistory({ source: worldSource(world), length: 8, interval, ...bodies });
  const slots = options.listed ? [0, 1] : ids;
  const points = () => slots.map((slot) => Math.min(8, Math.max(0, history.recordings - history.birth[slot])));
  const play = (steps: number) => {
    for (let i = 0; i < steps; i++) {
      step(world, 1 / 60);
      history.record();
    }
  };
  return { world, ids, history, points, play };
}

describe('trails of a world that goes back', () => {
  it.each([{ interval: 1 }, { interval: 3 }])(
    'begin anew: their points lie in the future: $interval',
    ({ interval }) => {
      const { world, ids, history, points, play } = worldWithTrails({ interval });
      const start = snapshot(world);
      play(5 * interval);
      expect(points()).toEqual([5, 5]);
      restore(world, start);
      history.record();
      expect(points()).toEqual([1, 1]);
      expect(history.x[history.newestSlice * TEXTURE_WIDTH + ids[0]]).toBe(3);
      play(interval);
      expect(points()).toEqual([2, 2]);
    },
  );
});

describe('the trail of a body that is removed', () => {
  it.each([{ interval: 1 }, { interval: 3 }])('ends with it, and comes back with it: $interval', ({ interval }) => {
    const { world, ids, history, points, play } = worldWithTrails({ listed: true, interval });
    play(3 * interval);
    const before = snapshot(world);
    expect(points()).toEqual([3, 3]);
    despawn(world, ids[0]);
    history.record();
    expect(points()[0]).toBe(0);
    play(2 * interval);
    expect(points()[0]).toBe(0);
    history.restart(ids[0]);
    history.clear();
    play(interval);
    expect(points()).toEqual([0, 1]);
    restore(world, before);
    play(2 * interval);
    expect(points()[0]).toBe(2);
  });

  it('does not pass to one that takes its id, whether or not a picture lies between', () => {
    for (const pictures of [0, 1]) {
      for (const listed of [false, true]) {
        const { world, ids, points, history, play } = worldWithTrails({ listed });
        play(3);
        despawn(world, ids[0]);
        for (let i = 0; i < pictures; i++) history.record();
        expect(spawn(world, { position: { x: -6 }, velocity: {} })).toBe(ids[0]);
        play(1);
        // One of all bodies leaves a trail of its own; a list names bodies, and the new one is none of them.
        expect(points()).toEqual([listed ? 0 : 1, 4 + pictures]);
        play(2);
        expect(points()).toEqual([listed ? 0 : 3, 6 + pictures]);
      }
    }
  });

  it('does not pass to one that takes its id between two points', () => {
    const { world, ids, points, play } = worldWithTrails({ interval: 4 });
    play(8);
    expect(points()).toEqual([2, 2]);
    despawn(world, ids[0]);
    spawn(world, { position: { x: -6 }, velocity: {} });
    play(1);
    expect(points()).toEqual([1, 3]);
    despawn(world, ids[0]);
    spawn(world, { position: { x: 6 }, velocity: {} });
    play(1);
    expect(points()).toEqual([0, 3]);
  });
});
