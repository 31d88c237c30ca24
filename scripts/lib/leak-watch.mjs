/**
 * Counts what a page holds: bytes of its JavaScript heap, live objects of the graphics card, DOM nodes, worlds.
 *
 * Give `countInPage` to `page.addInitScript`, then `takeCounts` at moments that ought to be alike: what grows from one
 * to the next is a leak.
 */

/**
 * @typedef {import('playwright-core').Page} Page
 * @typedef {import('playwright-core').CDPSession} CDPSession
 * @typedef {{ heap: number, nodes: number, listeners: number, contexts: number, objects: Record<string, number>,
 *   memories: number }} Counts
 */

/**
 * A flag for the browser under which only what is held grows: compilers of JavaScript go on for minutes to add machine
 * code of functions that are seldom called, some 5 KB for every world that is made; and collections throw away the
 * bytecode of functions that were not called since, which comes back when they are.
 */
export const WITHOUT_COMPILERS = '--js-flags=--no-opt,--no-maglev,--no-sparkplug,--no-flush-bytecode';

/** What pixi keeps of every view: it names the programs of a new renderer anew, and files their sources by name. */
export const KEPT_BY_PIXI = 10e3;

/** Runs in the page before anything else: wraps what makes and deletes objects of the graphics card, and worlds. */
export function countInPage() {
  const kinds = 'Buffer Framebuffer Program Query Renderbuffer Sampler Shader Texture TransformFeedback VertexArray';
  /** @type {{ context: WeakRef<WebGL2RenderingContext>, live: Record<string, number> }[]} */
  const contexts = [];
  const known = new WeakMap();
  const prototype = /** @type {any} */ (WebGL2RenderingContext.prototype);
  /** @param {WebGL2RenderingContext} context */
  const liveOf = (context) => {
    let live = known.get(context);
    if (live === undefined) {
      live = {};
      known.set(context, live);
      contexts.push({ context: new WeakRef(context), live });
    }
    return live;
  };
  for (const kind of kinds.split(' ')) {
    const [create, remove] = [prototype[`create${kind}`], prototype[`delete${kind}`]];
    /** @type {WeakSet<object>} */
    const alive = new WeakSet();
    prototype[`create${kind}`] = function (/** @type {any[]} */ ...given) {
      const made = create.apply(this, given);
      if (made) alive.add(made);
      const live = liveOf(this);
      live[kind] = (live[kind] ?? 0) + (made ? 1 : 0);
      return made;
    };
    prototype[`delete${kind}`] = function (/** @type {object | null} */ object) {
      if (object && alive.delete(object)) liveOf(this)[kind]--;
      return remove.call(this, object);
    };
  }
  /** @type {WeakRef<WebAssembly.Memory>[]} */
  const memories = [];
  WebAssembly.Memory = new Proxy(WebAssembly.Memory, {
    construct(target, given) {
      const memory = Reflect.construct(target, given);
      memories.push(new WeakRef(memory));
      return memory;
    },
  });
  Object.assign(globalThis, {
    __counts() {
      const present = contexts.filter(({ context }) => context.deref()?.isContextLost() === false);
      /** @type {Record<string, number>} */
      const objects = {};
      for (const { live } of present) {
        for (const [kind, count] of Object.entries(live)) objects[kind] = (objects[kind] ?? 0) + count;
      }
      const held = memories.filter((memory) => memory.deref() !== undefined).length;
      return { contexts: present.length, objects, memories: held };
    },
  });
}

/**
 * Equal counts in a row that end the collection, and the most collections: some objects are freed only after those that
 * held them.
 */
const AGREEING = 4;
const MAX_COLLECTIONS = 30;

/**
 * Collects garbage until nothing more goes, and counts what is left.
 * @param {Page} page
 * @param {CDPSession} session of that page
 * @returns {Promise<Counts>}
 */
export async function takeCounts(page, session) {
  let [counted, agreeing] = ['', 0];
  for (let i = 0; i < MAX_COLLECTIONS && agreeing < AGREEING; i++) {
    await session.send('HeapProfiler.collectGarbage');
    await page.evaluate(() => new Promise((done) => setTimeout(done, 50)));
    const now = JSON.stringify(await page.evaluate(() => /** @type {any} */ (globalThis).__counts()));
    agreeing = now === counted ? agreeing + 1 : 1;
    counted = now;
  }
  const { usedSize } = await session.send('Runtime.getHeapUsage');
  const { nodes, jsEventListeners } = await session.send('Memory.getDOMCounters');
  return { heap: usedSize, nodes, listeners: jsEventListeners, ...JSON.parse(counted) };
}

/** @param {Counts} counts */
export function objectsOf({ objects }) {
  return Object.values(objects).reduce((sum, count) => sum + count, 0);
}

/**
 * Plays a game hard, some four seconds of its time: steps, ways back, new worlds, switches, and every renderer.
 * @param {Page} page
 * @param {number} round
 */
export async function playRound(page, round) {
  await page.evaluate(async (seed) => {
    const game = /** @type {any} */ (globalThis).__game;
    const frame = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const { values } = game.state();
    const switches = Object.keys(values).filter((name) => typeof values[name] === 'boolean');
    for (let i = 0; i < 2; i++) {
      game.step(120);
      await frame();
      game.rewind(0.6);
      await frame();
    }
    game.reset(seed);
    for (const name of switches) {
      game.set(name, !values[name]);
      await frame();
      game.set(name, values[name]);
    }
    const { renderer } = game.state();
    for (const name of [...game.renderers.filter((/** @type {string} */ each) => each !== renderer), renderer]) {
      await game.show(name);
      await frame();
    }
  }, round % 7);
}
