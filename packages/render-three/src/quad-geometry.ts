import { BufferAttribute, BufferGeometry, Sphere, Vector3 } from 'three';

/** Indices per quad: two triangles. */
const INDICES = 6;

/**
 * Quads without any vertex attribute: the shader makes vertex `v` corner `v & 3` of quad `v >> 2`. A software renderer
 * draws them an order of magnitude faster than instances.
 */
export class QuadGeometry extends BufferGeometry {
  constructor() {
    super();
    // Asked for by three when it sorts; the vertices are not there to compute it from.
    this.boundingSphere = new Sphere(new Vector3(), Number.POSITIVE_INFINITY);
    this.setDrawRange(0, 0);
  }

  /**
   * Draws the first `count` quads. The index buffer grows by half its size, so that a growing population seldom
   * reallocates it.
   */
  setCount(count: number): void {
    if (count * INDICES > (this.index?.count ?? 0)) this.#grow(Math.ceil(count * 1.5) + 64);
    this.drawRange.count = count * INDICES;
  }

  #grow(quads: number): void {
    const indices = new Uint32Array(quads * INDICES);
    for (let quad = 0, i = 0; quad < quads; quad++) {
      const corner = quad * 4;
      indices[i++] = corner;
      indices[i++] = corner + 1;
      indices[i++] = corner + 2;
      indices[i++] = corner + 2;
      indices[i++] = corner + 1;
      indices[i++] = corner + 3;
    }
    this.dispose(); // lets go of the old index on the GPU
    this.setIndex(new BufferAttribute(indices, 1));
  }
}
