/**
 * Finds out who makes objects while a game runs: V8's sampling heap profiler, told to look at every object, over
 * frames that follow each other without a display. Objects that were collected meanwhile count too.
 *
 * Give `takeOverFrames` to `page.addInitScript`; when the game is ready, call `allocations`.
 */
import { SourceMap } from 'node:module';

/**
 * @typedef {import('playwright-core').Page} Page
 * @typedef {import('playwright-core').CDPSession} CDPSession
 * @typedef {{ functionName: string, url: string, lineNumber: number, columnNumber: number }} CallFrame
 * @typedef {{ id: number, callFrame: CallFrame, selfSize: number, children: ProfileNode[] }} ProfileNode
 * @typedef {{ head: ProfileNode, samples: { size: number, nodeId: number }[] }} Profile
 * @typedef {{ place: string, isOurs: boolean, objects: number, bytes: number, numbers: number }} Site a place in the
 *   sources, and per frame the objects made there, their bytes, and the bytes of boxed numbers
 */

/** A number on the heap of Chromium, bytes; no object is as small. */
const NUMBER = 12;

/**
 * Runs in the page before anything else. Later `__frames(n)` runs `n` frames at once, a sixtieth of a second each,
 * and the graphics card is told nothing of what it would draw: its work is none of the heap's.
 */
export function takeOverFrames() {
  const real = requestAnimationFrame.bind(globalThis);
  /** Callbacks of the next frame and of the present one, in places that stay: the list makes no garbage either. */
  /** @type {(FrameRequestCallback | undefined)[]} */
  let waiting = new Array(16).fill(undefined);
  /** @type {(FrameRequestCallback | undefined)[]} */
  let running = new Array(16).fill(undefined);
  let count = 0;
  let isOurs = false;
  let now = 0;
  const wait = (/** @type {FrameRequestCallback} */ callback) => {
    waiting[count++] = callback;
    return count;
  };
  const ask = (/** @type {FrameRequestCallback} */ callback) =>
    real((time) => {
      now = time;
      if (isOurs) wait(callback);
      else callback(time);
    });
  globalThis.requestAnimationFrame = (callback) => {
    return isOurs ? wait(callback) : ask(callback);
  };
  const prototype = /** @type {any} */ (WebGL2RenderingContext.prototype);
  Object.assign(globalThis, {
    __takeFrames() {
      isOurs = true;
      for (const name of ['drawElements', 'drawArrays', 'drawElementsInstanced', 'drawArraysInstanced', 'clear']) {
        prototype[name] = () => {};
      }
    },
    __waiting: () => count > 0,
    __frames(/** @type {number} */ frames) {
      for (let i = 0; i < frames; i++) {
        now += 1000 / 60;
        const called = count;
        const list = waiting;
        waiting = running;
        running = list;
        count = 0;
        for (let c = 0; c < called; c++) list[c]?.(now);
      }
    },
  });
}

/**
 * The places that make objects in `frames` frames, after `warm` others in which compilers and caches come to rest.
 * @param {Page} page with a game that is ready
 * @param {CDPSession} session of that page
 * @param {{ warm: number, frames: number, sourceMap: string }} options `sourceMap` of the page's script, as JSON
 * @returns {Promise<Site[]>} the worst first
 */
export async function allocations(page, session, { warm, frames, sourceMap }) {
  const run = (/** @type {number} */ count) => page.evaluate((n) => /** @type {any} */ (globalThis).__frames(n), count);
  await page.evaluate(() => /** @type {any} */ (globalThis).__takeFrames());
  // The frame that the display still owes.
  await page.waitForFunction(() => /** @type {any} */ (globalThis).__waiting());
  await run(warm);
  await session.send('HeapProfiler.enable');
  await session.send('HeapProfiler.collectGarbage');
  const collected = { includeObjectsCollectedByMajorGC: true, includeObjectsCollectedByMinorGC: true };
  await session.send('HeapProfiler.startSampling', { samplingInterval: 1, ...collected });
  await run(frames);
  const { profile } = await session.send('HeapProfiler.stopSampling');
  return sitesOf(/** @type {any} */ (profile), new SourceMap(JSON.parse(sourceMap)), frames);
}

/**
 * @param {Profile} profile
 * @param {SourceMap} map
 * @param {number} frames
 */
function sitesOf({ head, samples }, map, frames) {
  /** @type {Map<string, Site>} */
  const sites = new Map();
  /** @type {Map<number, Site>} */
  const byNode = new Map();
  /** @type {(node: ProfileNode, caller: string) => void} */
  const visit = (node, caller) => {
    const place = placeOf(node.callFrame, map);
    // What the browser's own functions make counts for who called them.
    const name = place === '' ? caller : `${node.callFrame.functionName || '(anonymous)'} ${place}`;
    const site = sites.get(name) ?? {
      place: name,
      isOurs: /^\S+ (packages|games)\//.test(name),
      objects: 0,
      bytes: 0,
      numbers: 0,
    };
    sites.set(name, site);
    byNode.set(node.id, site);
    for (const child of node.children) visit(child, name);
  };
  visit(head, '(the browser)');
  for (const { size, nodeId } of samples) {
    const site = byNode.get(nodeId);
    if (site === undefined) continue;
    if (size === NUMBER) site.numbers += size / frames;
    else {
      site.objects += 1 / frames;
      site.bytes += size / frames;
    }
  }
  return [...sites.values()].filter(({ bytes, numbers }) => bytes + numbers > 0).sort((a, b) => b.bytes - a.bytes);
}

/**
 * File and line in the sources; empty for what is built in.
 * @param {CallFrame} callFrame
 * @param {SourceMap} map
 */
function placeOf({ url, lineNumber, columnNumber }, map) {
  if (!url.startsWith('http')) return '';
  const entry = /** @type {{ originalSource?: string, originalLine?: number }} */ (
    map.findEntry(lineNumber, columnNumber)
  );
  const file = (entry.originalSource ?? url)
    .replace(/^.*node_modules\//, '')
    .replace(/^.*?\/(?=(packages|games)\/)/, '');
  return `${file}:${(entry.originalLine ?? 0) + 1}`;
}
