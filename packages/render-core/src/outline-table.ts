import { type PhysicsWorld, type Shape, shapeAt, shapeCount } from '@principia/physics';
import { OUTLINE_TEXELS, type Outlines } from './body-source.ts';
import { TEXTURE_WIDTH } from './column-upload.ts';

/** The shapes of a world as numbers for a texture. Shapes are only added, except when a snapshot is brought back. */
export class OutlineTable implements Outlines {
  texels = new Float32Array(TEXTURE_WIDTH);
  used = OUTLINE_TEXELS;
  version = 0;
  #count = 1;
  #restored = 0;

  /** Brings the table up to date with the world, and returns it. */
  refresh(world: PhysicsWorld): Outlines {
    const { restored } = world.versions;
    const count = shapeCount(world);
    if (count === this.#count && restored === this.#restored) return this;
    const first = restored === this.#restored ? this.#count : 1;
    this.#count = count;
    this.#restored = restored;
    this.used = count * OUTLINE_TEXELS;
    this.version++;
    if (this.texels.length < this.used) {
      const longer = new Float32Array(Math.ceil((2 * this.used) / TEXTURE_WIDTH) * TEXTURE_WIDTH);
      longer.set(this.texels);
      this.texels = longer;
    }
    for (let i = first; i < count; i++) this.#write(i, shapeAt(world, i));
    return this;
  }

  #write(index: number, shape: Shape | undefined): void {
    if (shape === undefined) return;
    const { vertices, radius, extent, minExtent } = shape;
    const at = index * OUTLINE_TEXELS;
    this.texels.fill(0, at, at + OUTLINE_TEXELS);
    this.texels.set([vertices.length / 2, radius, extent, minExtent], at);
    this.texels.set(vertices, at + 4);
  }
}
