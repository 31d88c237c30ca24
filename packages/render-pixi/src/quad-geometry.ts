import { Buffer, BufferUsage, Geometry } from 'pixi.js';

/** Corners of a quad in the order of its two triangles. */
const CORNERS = [0, 1, 2, 2, 1, 3];

/** An index buffer in which quad `i` uses vertices `4 i … 4 i + 3`, shared by all geometries that are small enough. */
interface QuadIndex {
  readonly quads: number;
  readonly buffer: Buffer;
  users: number;
}

/** The largest index so far, while it is in use. */
let largest: QuadIndex | undefined;

/**
 * Returns an index for at least `quads` quads. More quads get a new buffer instead of more data in the old one: pixi
 * keeps one update counter per buffer, which a WebGPU renderer resets under a WebGL renderer that shares it.
 */
function acquire(quads: number): QuadIndex {
  if (largest === undefined || largest.quads < quads) {
    const room = Math.max(1024, quads, 2 * (largest?.quads ?? 0));
    const usage = BufferUsage.INDEX | BufferUsage.COPY_DST;
    const buffer = new Buffer({ data: quadIndices(room), usage, shrinkToFit: false });
    buffer.autoGarbageCollect = false;
    largest = { quads: room, buffer, users: 0 };
  }
  largest.users++;
  return largest;
}

function release(index: QuadIndex): void {
  if (--index.users > 0) return;
  index.buffer.destroy();
  if (index === largest) largest = undefined;
}

function quadIndices(quads: number): Uint32Array {
  const indices = new Uint32Array(quads * 6);
  for (let quad = 0, i = 0; quad < quads; quad++) {
    for (let corner = 0; corner < 6; corner++) indices[i++] = 4 * quad + CORNERS[corner];
  }
  return indices;
}

/** Geometry of quads whose corners the vertex shader computes from the vertex index, without attributes. */
export class QuadGeometry {
  #index = acquire(1);
  #geometry = geometryOf(this.#index);

  /** The present geometry; replaced when `draw` needs a larger index. */
  get geometry(): Geometry {
    return this.#geometry;
  }

  /** Sets how many quads are drawn, at least one, `instances` times over. Returns true when `geometry` was replaced. */
  draw(quads: number, instances: number): boolean {
    const grown = quads > this.#index.quads;
    if (grown) {
      const { geometry } = this;
      const index = acquire(quads);
      this.#geometry = geometryOf(index);
      geometry.destroy(false);
      release(this.#index);
      this.#index = index;
    }
    this.#geometry.indexCount = quads * 6;
    this.#geometry.instanceCount = instances;
    return grown;
  }

  destroy(): void {
    this.#geometry.destroy(false);
    release(this.#index);
  }
}

function geometryOf(index: QuadIndex): Geometry {
  const geometry = new Geometry({ indexBuffer: index.buffer });
  geometry.autoGarbageCollect = false;
  return geometry;
}
