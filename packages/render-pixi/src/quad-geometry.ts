import { Buffer, BufferUsage, Geometry } from 'pixi.js';

/** Corners of a quad in the order its two triangles use them. */
const CORNERS = [0, 1, 2, 2, 1, 3];

/** One index buffer for all layers: quad `i` uses vertices `4 i … 4 i + 3`, and no vertex has any attribute. */
let shared: Buffer | undefined;

function quadIndices(quads: number): Uint32Array {
  const indices = new Uint32Array(quads * 6);
  for (let quad = 0, i = 0; quad < quads; quad++) {
    for (let corner = 0; corner < 6; corner++) indices[i++] = 4 * quad + CORNERS[corner];
  }
  return indices;
}

/** Makes sure the shared index buffer holds `quads` quads; doubles, so that growth is rare. */
function quadIndexBuffer(quads: number): Buffer {
  if (shared === undefined) {
    const data = quadIndices(1024);
    shared = new Buffer({ data, usage: BufferUsage.INDEX | BufferUsage.COPY_DST, shrinkToFit: false });
    shared.autoGarbageCollect = false;
  }
  const present = shared.data.length / 6;
  if (present < quads) shared.data = quadIndices(Math.max(quads, 2 * present));
  return shared;
}

/** Geometry of `count` quads whose corners the vertex shader works out from the vertex number. */
export class QuadGeometry {
  readonly geometry: Geometry;

  constructor() {
    this.geometry = new Geometry({ indexBuffer: quadIndexBuffer(1), instanceCount: 1 });
    this.geometry.autoGarbageCollect = false;
  }

  /** Sets how many quads are drawn, `instances` times over. Zero quads must be hidden by the mesh instead. */
  draw(quads: number, instances = 1): void {
    quadIndexBuffer(quads);
    this.geometry.indexCount = quads * 6;
    this.geometry.instanceCount = instances;
  }

  destroy(): void {
    this.geometry.destroy(false);
  }
}
