/**
 * Frames of a game that goes on leave at most a kilobyte behind, and no object for each body, contact or particle: a step,
 * the picture brought up to date, and the shell. Words on the page are made a few times a second. What pixi and three make
 * while they draw is bounded, and is not ours.
 * `GARBAGE=print` lists who makes what.
 */
import { describe, expect, it } from 'vitest';
import { playGame } from '../support/game-page.ts';
import { COMPILED_SOON, driveFrames, type Garbage, GarbageWatch } from '../support/garbage.ts';

/** Frames until compilers have come to rest, and the moments that can be gone back to are all there: twenty seconds. */
const WARM = 2600;
/** Frames watched at a time, a second, and how often: what is learned once is in some of them alone. */
const FRAMES = 60;
const WATCHES = 3;

/**
 * What is ours a frame: bytes at most, and objects, of which there are hundreds where each body makes one. What a compiler
 * keeps in registers changes with the version of the browser and the load of the machine.
 */
const BYTES = 1024;
const OBJECTS = 5;

interface Play {
  readonly game: string;
  readonly query: string;
  /** Bytes of libraries a frame at most. */
  readonly libraries: number;
  /** Before all frames, and before those that are watched. */
  readonly key?: string;
  readonly held?: string;
}

// Every sound is made of objects, so the black hole is silent. The show of the demonstration ends with L: shells go up now
// and then. A ship that is pushed flies on for seconds.
const plays: readonly Play[] = [
  { game: 'bouncing-balls', query: 'count=200&collisions=true&trails=true&renderer=pixi', libraries: 1200 },
  { game: 'bouncing-balls', query: 'count=200&collisions=true&renderer=three', libraries: 3000 },
  { game: 'black-hole', query: 'seed=4&sound=off', libraries: 7000, held: 'ArrowUp' },
  { game: 'fireworks', query: 'barrage=true&sparks=20000', libraries: 7000, key: 'l' },
  { game: 'fireworks', query: 'barrage=true&sparks=20000&renderer=three', libraries: 6000, key: 'l' },
];

const isWords = ({ file }: Garbage) => /(hud|stats)\.ts$/.test(file);
const isOurs = ({ file }: Garbage) => /^(packages|games)\//.test(file);
const isLibrary = (each: Garbage) => !isOurs(each) && each.file !== 'browser' && each.file !== 'driver';
const sum = (list: readonly Garbage[], what: 'bytes' | 'objects') =>
  list.reduce((total, each) => total + each[what], 0);
const told = (list: readonly Garbage[]) =>
  list
    .map(({ file, line, name, bytes, objects, numbers }) => {
      const [b, o, n] = [bytes, objects, numbers].map((each) => each.toFixed(2));
      return `${b} bytes, ${o} objects, ${n} numbers: ${file}:${line} ${name}`;
    })
    .join('\n');

/** The least of some watches, by what is made of objects. */
async function leastOf(watch: GarbageWatch): Promise<Garbage[]> {
  let least: Garbage[] = [];
  for (let i = 0; i < WATCHES; i++) {
    const seen = await watch.watch(FRAMES);
    const objects = (list: readonly Garbage[]) => sum(list.filter(isOurs), 'objects');
    if (i === 0 || objects(seen) < objects(least)) least = seen;
  }
  return least;
}

describe.each(plays)('$game?$query', ({ game, query, libraries, key, held }) => {
  const { open } = playGame(game, { viewport: { width: 480, height: 320 }, prepare: driveFrames }, COMPILED_SOON);
  const ofFrames = (list: readonly Garbage[]) => list.filter((each) => isOurs(each) && !isWords(each));

  it('makes at most a kilobyte in a frame, and no object for each body; one object on purpose is seen', async () => {
    const page = await open(query);
    if (key !== undefined) await page.keyboard.press(key);
    const watch = await GarbageWatch.of(page);
    await watch.frames(WARM);
    if (held !== undefined) {
      await page.keyboard.down(held);
      await watch.frames(FRAMES);
    }
    const least = await leastOf(watch);
    const ours = ofFrames(least);
    if (process.env.GARBAGE === 'print') process.stdout.write(`${game}?${query}\n${told(least)}\n`);
    const objects = sum(ours, 'objects');
    expect(objects, told(ours)).toBeLessThan(OBJECTS);
    expect(sum(ours, 'bytes'), told(ours)).toBeLessThan(BYTES);
    expect(sum(least.filter(isWords), 'objects')).toBeLessThan(2);
    expect(sum(least.filter(isLibrary), 'bytes')).toBeLessThan(libraries);
    // The frames without it come last: compilers go on, and leave fewer objects.
    await watch.litter(true);
    const littered = sum(ofFrames(await watch.watch(FRAMES)), 'objects');
    await watch.litter(false);
    expect(littered).toBeGreaterThan(sum(ofFrames(await leastOf(watch)), 'objects') + 0.9);
  });
});
