import { TEXTURE_WIDTH, type TrailHistory } from '@principia/render-core';
import { BufferImageSource } from 'pixi.js';
import { ColumnTexture } from './column-texture.ts';

/** Rows that every WebGPU device and practically every WebGL 2 one allows in a texture. */
const MAX_ROWS = 8192;

/** A trail history on the GPU: the whole ring is there, and a recording uploads its own slice of rows. */
export class TrailTextures {
  readonly x: BufferImageSource;
  readonly y: BufferImageSource;
  readonly birth = new ColumnTexture('whole');
  /** The ids of the chosen bodies; zeros when every body has a trail. */
  readonly bodies = new ColumnTexture('whole');
  /** 0, 1, 2, …: which slots to draw when only chosen bodies have trails. */
  readonly slots = new ColumnTexture('whole');
  readonly #history: TrailHistory;
  #birthVersion = -1;
  #resetVersion = 0;

  /** @throws Error when the history has more rows than a texture may have */
  constructor(history: TrailHistory) {
    this.#history = history;
    const rows = history.rowsPerSlice * history.length;
    if (rows > MAX_ROWS) {
      const most = Math.floor(MAX_ROWS / history.rowsPerSlice);
      throw new Error(
        `trails of ${history.length} points for ${history.birth.length} bodies do not fit into a texture: ` +
          `keep at most ${most} points, or name the bodies that leave trails`,
      );
    }
    this.x = historySource(history.x, rows);
    this.y = historySource(history.y, rows);
    if (history.bodies !== undefined) {
      const slots = history.birth.length;
      const ids = new Uint32Array(slots);
      ids.set(history.bodies);
      this.bodies.upload(ids, slots);
      this.slots.upload(
        Uint32Array.from({ length: slots }, (_, i) => i),
        slots,
      );
    }
  }

  /** Uploads the slice that was just recorded. */
  recorded(): void {
    const history = this.#history;
    const texels = history.rowsPerSlice * TEXTURE_WIDTH;
    const start = history.newestSlice * texels;
    this.x.update(start, start + texels);
    this.y.update(start, start + texels);
  }

  /** Uploads what changed for other reasons than a recording. */
  sync(): void {
    const history = this.#history;
    if (history.birthVersion !== this.#birthVersion) {
      this.#birthVersion = history.birthVersion;
      this.birth.upload(history.birth, history.birth.length);
    }
    if (history.resetVersion !== this.#resetVersion) {
      this.#resetVersion = history.resetVersion;
      this.x.update();
      this.y.update();
    }
  }

  destroy(): void {
    for (const texture of [this.x, this.y, this.birth, this.bodies, this.slots]) texture.destroy();
  }
}

function historySource(data: Float32Array, rows: number): BufferImageSource {
  return new BufferImageSource({
    resource: data,
    width: TEXTURE_WIDTH,
    height: rows,
    format: 'r32float',
    alphaMode: 'no-premultiply-alpha',
    scaleMode: 'nearest',
    autoGarbageCollect: false,
  });
}
