/**
 * What a page's frames leave on the JavaScript heap, function by function: frames are asked for one after the other
 * instead of by the display, and the browser tells of every object that is made, also of objects that are freed at once.
 */
import { SourceMap } from 'node:module';
import type { CDPSession, Page } from 'playwright-core';

/**
 * Flags for the browser: the compiler works at once and not when a core is free, and takes less to find a function worth
 * its while. What it has not compiled makes numbers on the heap; seconds of play would compile the same.
 */
export const COMPILED_SOON = [
  '--js-flags=--no-concurrent-recompilation,--interrupt-budget=3000,--invocation-count-for-turbofan=50',
];

/** What frames made in one function, a frame. */
export interface Garbage {
  /** From the repository's root; of a library its name. */
  readonly file: string;
  readonly name: string;
  readonly line: number;
  readonly bytes: number;
  /** Numbers put on the heap because they were handed from function to function. */
  readonly numbers: number;
  /** Everything else: objects, lists, functions, strings. */
  readonly objects: number;
}

/** Bytes of a number on the heap: a word that says so, and the number. The least object with a field has four more. */
const NUMBER = 12;

/**
 * Runs in the page before anything of the game does: from `__drive()` on, frames come when `__frames(n)` asks. Everything
 * is told to the graphics card but to draw, which takes long without one.
 */
export function driveFrames(): void {
  const { requestAnimationFrame: request, cancelAnimationFrame: cancel } = globalThis;
  const drawn = ['drawElements', 'drawArrays', 'drawElementsInstanced', 'drawArraysInstanced', 'clear'];
  for (const name of drawn) Object.assign(WebGL2RenderingContext.prototype, { [name]: () => {} });
  const clock = new Float64Array(1);
  let driven = false;
  // Lists of fixed length that take turns, so that what asks for frames leaves nothing itself.
  let asked: (FrameRequestCallback | undefined)[] = new Array(64).fill(undefined);
  let due: (FrameRequestCallback | undefined)[] = new Array(64).fill(undefined);
  let count = 0;
  let littering = false;
  let litter: object | undefined;
  globalThis.requestAnimationFrame = (callback) => {
    if (!driven) return request(callback);
    asked[count++] = callback;
    if (littering) litter = { count };
    return count;
  };
  globalThis.cancelAnimationFrame = (which) => {
    if (driven) asked[which - 1] = undefined;
    else cancel(which);
  };
  Object.assign(globalThis, {
    __drive() {
      driven = true;
      const now = Math.ceil(performance.now());
      clock[0] = now;
      // Watching takes time, and nothing is to depend on how much; the browser's own clock makes a number at each look.
      performance.now = () => now;
    },
    __litter(on: boolean) {
      littering = on;
      return litter;
    },
    __isAsked: () => count > 0,
    __frames(frames: number) {
      for (let i = 0; i < frames; i++) {
        clock[0] += 1000 / 60;
        [due, asked] = [asked, due];
        const last = count;
        if (last === 0) throw new Error('Nobody asks for frames any more.');
        count = 0;
        for (let c = 0; c < last; c++) due[c]?.(clock[0]);
      }
    },
  });
}

type CallFrame = {
  readonly functionName: string;
  readonly url: string;
  readonly lineNumber: number;
  readonly columnNumber: number;
};

type ProfileNode = { readonly id: number; readonly callFrame: CallFrame; readonly children: readonly ProfileNode[] };

/** Counts what the frames of a page leave behind; the page was opened with `driveFrames`. */
export class GarbageWatch {
  readonly #page: Page;
  readonly #session: CDPSession;
  readonly #maps = new Map<string, SourceMap>();

  private constructor(page: Page, session: CDPSession) {
    this.#page = page;
    this.#session = session;
  }

  static async of(page: Page): Promise<GarbageWatch> {
    const session = await page.context().newCDPSession(page);
    await session.send('HeapProfiler.enable');
    await page.evaluate('__drive()');
    // The frame that the display was asked for is the last of its own, and asks for the first driven one.
    await page.waitForFunction('__isAsked()', undefined, { polling: 20 });
    return new GarbageWatch(page, session);
  }

  async frames(count: number): Promise<void> {
    await this.#page.evaluate(`__frames(${count})`);
  }

  /** Whether something of the page's leaves an object in every frame from now on. */
  async litter(on: boolean): Promise<void> {
    await this.#page.evaluate(`__litter(${on})`);
  }

  /** What `count` frames make, the most first. What the browser's own functions make is their caller's. */
  async watch(count: number): Promise<Garbage[]> {
    const options = { includeObjectsCollectedByMajorGC: true, includeObjectsCollectedByMinorGC: true };
    await this.#session.send('HeapProfiler.startSampling', { samplingInterval: 1, ...options });
    await this.frames(count);
    const { profile } = await this.#session.send('HeapProfiler.stopSampling');
    const owners = new Map<number, CallFrame | undefined>();
    const visit = ({ id, callFrame, children }: ProfileNode, caller: CallFrame | undefined): void => {
      const owner = callFrame.url === '' ? caller : callFrame;
      owners.set(id, owner);
      for (const child of children) visit(child, owner);
    };
    visit(profile.head, undefined);
    const found = new Map<string, { -readonly [Key in keyof Garbage]: Garbage[Key] }>();
    for (const { size, nodeId } of profile.samples) {
      const place = await this.#placeOf(owners.get(nodeId));
      const key = Object.values(place).join(' ');
      const sum = found.get(key) ?? { ...place, bytes: 0, numbers: 0, objects: 0 };
      found.set(key, sum);
      sum.bytes += size / count;
      sum[size === NUMBER ? 'numbers' : 'objects'] += 1 / count;
    }
    return [...found.values()].sort((a, b) => b.bytes - a.bytes);
  }

  async #placeOf(frame: CallFrame | undefined): Promise<Pick<Garbage, 'file' | 'name' | 'line'>> {
    if (frame === undefined) return { file: 'browser', name: '', line: 0 };
    const { url, functionName, lineNumber, columnNumber } = frame;
    if (!url.startsWith('http')) return { file: 'driver', name: functionName, line: 0 };
    const map = await this.#mapOf(url);
    const entry = map.findEntry(lineNumber, columnNumber);
    const source = 'originalSource' in entry ? entry.originalSource : url;
    const line = 'originalLine' in entry ? entry.originalLine + 1 : lineNumber;
    const library = /node_modules\/(@[^/]+\/[^/]+|[^/]+)/.exec(source)?.[1];
    const file = library ?? source.replace(/^.*(?=packages\/|games\/)/, '');
    return { file, name: functionName, line };
  }

  async #mapOf(url: string): Promise<SourceMap> {
    let map = this.#maps.get(url);
    if (map === undefined) {
      map = new SourceMap(JSON.parse(await (await fetch(`${url}.map`)).text()));
      this.#maps.set(url, map);
    }
    return map;
  }
}
