import { type PhysicsWorld, type Shape, shapeAt, shapeCount } from '@principia/physics';
import { OUTLINE_TEXELS, type Outlines } from './body-source.ts';
import { TEXTURE_WIDTH } from './column-upload.ts';

/** The shapes of a world as numbers for a texture. Where one is no longer used, another may take its place. */
export class OutlineTable implements Outlines {
  texels = new Float32Array(TEXTURE_WIDTH);
  used = OUTLINE_TEXELS;
  version = 0;
  #style = 0;
  #restored = 0;
  readonly #shapes: (Shape | undefined)[] = [];

  /** Brings the table up to date with the world, and returns it. */
  refresh(world: PhysicsWorld): Outlines {
    // What bodies look like changes whenever one gets a shape.
    const { style, restored } = world.versions;
    if (style === this.#style && restored === this.#restored) return this;
    this.#style = style;
    this.#restored = restored;
    const count = shapeCount(world);
    this.used = count * OUTLINE_TEXELS;
    if (this.texels.length < this.used) {
      const longer = new Float32Array(Math.ceil((2 * this.used) / TEXTURE_WIDTH) * TEXTURE_WIDTH);
      longer.set(this.texels);
      this.texels = longer;
    }
    for (let i = 1; i < count; i++) this.#write(i, shapeAt(world, i));
    return this;
  }

  #write(index: number, shape: Shape | undefined): void {
    if (shape === undefined || shape === this.#shapes[index]) return;
    this.#shapes[index] = shape;
    this.version++;
    const { vertices, radius, extent, minExtent } = shape;
    const at = index * OUTLINE_TEXELS;
    this.texels.fill(0, at, at + OUTLINE_TEXELS);
    this.texels.set([vertices.length / 2, radius, extent, minExtent], at);
    this.texels.set(vertices, at + 4);
  }
}
