import { burst, createEmitter, createPhysicsWorld, despawn, restore, snapshot, spawn, step } from '@principia/physics';
import { expect, test } from 'vitest';
import { ColumnUpload } from './column-upload.ts';
import { PosePair, UploadedPoses } from './pose-pair.ts';
import { worldSource } from './world-source.ts';

/** A world whose poses are sent as renderers do, to two arrays in place of two textures. */
function sender(precision: 'f32' | 'f64') {
  const world = createPhysicsWorld({ precision, capacity: 100 });
  const source = worldSource(world);
  const pair = new PosePair();
  const sent = new UploadedPoses();
  const uploads = [new ColumnUpload(), new ColumnUpload()];
  const halves = [new Float32Array(source.rows), new Float32Array(source.rows)];
  const send = () => {
    pair.refresh(source);
    const what = sent.take(pair);
    const present = pair.isSwapped ? 1 : 0;
    if (what > 0) halves[present].set(uploads[present].refresh(source.position.x, source.rows));
    if (what > 1) halves[1 - present].set(uploads[1 - present].refresh(source.previousPosition.x, source.rows));
    return what;
  };
  /** Whether either half is what the world says, of every row. */
  const check = () => {
    const present = pair.isSwapped ? 1 : 0;
    const { position, previousPosition } = source;
    expect(halves[present].findIndex((x, row) => x !== Math.fround(position.x[row]))).toBe(-1);
    expect(halves[1 - present].findIndex((x, row) => x !== Math.fround(previousPosition.x[row]))).toBe(-1);
  };
  return { world, send, check };
}

test.each(['f32', 'f64'] as const)('sends half of the poses where steps follow each other (%s)', (precision) => {
  const { world, send, check } = sender(precision);
  for (let i = 1; i < 20; i++) spawn(world, { position: { x: i / 3 }, velocity: { x: i / 7 } });
  spawn(world, { position: { x: 100 } });
  expect(send()).toBe(2);
  check();
  expect(send()).toBe(0);
  for (let i = 0; i < 5; i++) {
    step(world, 1 / 60);
    expect(send()).toBe(1);
    check();
    expect(send()).toBe(0);
  }
});

test('is right whatever else happens to the bodies between two frames', () => {
  const { world, send, check } = sender('f32');
  const { Position } = world.components;
  const ids = Array.from({ length: 20 }, (_, i) => spawn(world, { position: { x: i }, velocity: { x: i } }));
  const events: (() => void)[] = [
    () => step(world, 1 / 60),
    () => {
      step(world, 1 / 60);
      step(world, 1 / 60);
    },
    () => {
      Position.x[ids[3]] += 5;
      world.versions.pose++;
      step(world, 1 / 60);
    },
    () => {
      step(world, 1 / 60);
      ids.push(spawn(world, { position: { x: -4 }, velocity: { x: 2 } }));
    },
    () => {
      despawn(world, ids.pop() as number);
      step(world, 1 / 60);
    },
    () => {
      world.components.Velocity.x[ids[5]] = Number.NaN;
      step(world, 1 / 60);
    },
    () => {
      const taken = snapshot(world);
      step(world, 1 / 60);
      restore(world, taken);
      step(world, 1 / 60);
    },
  ];
  for (const first of events) {
    for (const second of events) {
      for (const event of [first, second]) {
        event();
        send();
        check();
      }
    }
  }
});

test('a particle comes from the place of its birth, not from where the last one of its row ended', () => {
  const { world, send, check } = sender('f32');
  const emitter = createEmitter(world, { capacity: 8, lifetime: 0.05, speed: 3, mass: 1, whenFull: 'oldest' });
  for (let i = 0; i < 20; i++) {
    if (i % 3 < 2) burst(emitter, 3, { position: { x: i } });
    step(world, 1 / 60);
    send();
    check();
  }
});

test('draws between the halves whichever is the present one', () => {
  const pair = new PosePair();
  expect(pair.alphaOf(0.25)).toBe(0.25);
  pair.isSwapped = true;
  expect(pair.alphaOf(0.25)).toBe(0.75);
});
