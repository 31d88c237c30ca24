/** The threads in 2D: a line for each. The lines follow the bodies; their list changes when threads break or are cut. */
import { rgba } from '@principia/physics';
import type { BodySource } from '@principia/render-core';
import { createLinkLayer } from '@principia/render-pixi';
import type { Picture } from '@principia/shell/pixi';
import { Container } from 'pixi.js';
import type { ClothPrint } from './cloth-print.ts';
import { colorAt } from './colors.ts';
import { CLOTH, type ClothRun, threadCount } from './sim.ts';
import type { TearFilm } from './tear-film.ts';
import { threadEnds } from './thread-ends.ts';

export interface ThreadOptions {
  readonly print: ClothPrint;
  readonly safeColors: boolean;
  /** The film of a tear, which is shown instead of the world while it runs. */
  film(): TearFilm | undefined;
}

export function paintThreads(sim: ClothRun, source: BodySource, { print, safeColors, film }: ThreadOptions): Picture {
  const slow = createFilmSource(source, sim.cloth.nodes[0]);
  const [live, past] = [source, slow.source].map((each) => createLinkLayer({ source: each, thickness: 1.6 }));
  const shown = { layer: live, threads: -1, print: -1 };
  return {
    container: new Container({ children: [live.container, past.container] }),
    update(alpha) {
      const time = film()?.time;
      const layer = time === undefined ? live : past;
      const threads = time === undefined ? threadCount(sim) : (film()?.threads ?? 0);
      if (layer !== shown.layer || threads !== shown.threads || print.version !== shown.print) {
        Object.assign(shown, { layer, threads, print: print.version });
        const ends = threadEnds(sim, time);
        const ids = ends.map((node) => node + sim.cloth.nodes[0]);
        layer.set(ids, ids.length / 2, threadColors(ends, print, safeColors));
      }
      live.container.visible = layer === live;
      past.container.visible = layer === past;
      if (time !== undefined) slow.show(film()?.positions ?? NOTHING);
      layer.update(alpha);
    },
    destroy() {
      live.destroy();
      past.destroy();
    },
  };
}

const NOTHING = new Float32Array(0);

/** Columns of a film: those of the world with other positions. @param first id of the first node */
function createFilmSource(source: BodySource, first: number) {
  const position = { ...source.position, x: new Float32Array(source.rows), y: new Float32Array(source.rows) };
  const versions = { pose: 0, style: 0, membership: 0 };
  return {
    source: { ...source, position, previousPosition: position, versions } satisfies BodySource,
    /** @param positions x, y and z of each node, m */
    show(positions: Float32Array) {
      for (let i = 0; 3 * i < positions.length; i++) {
        position.x[first + i] = positions[3 * i];
        position.y[first + i] = positions[3 * i + 1];
      }
      versions.pose++;
    },
  };
}

/** The colour of each thread: that of the player's picture at its first node, or the cloth's. */
function threadColors(ends: readonly number[], print: ClothPrint, safeColors: boolean): number[] {
  const { columns, rows } = CLOTH;
  return Array.from({ length: ends.length / 2 }, (_, i) => {
    const node = ends[2 * i];
    const depth = Math.floor(node / columns) / (rows - 1);
    return rgba(...(print.colorAt((node % columns) / (columns - 1), depth) ?? colorAt(depth, safeColors)), 0.9);
  });
}
