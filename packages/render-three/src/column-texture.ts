import { TEXTURE_WIDTH, textureRows } from '@principia/render-core';
import type { WebGLRenderer } from 'three';
import { ExternalTexture, requireThree } from './three-version.ts';

/** The content of a texel of a column texture. */
export type TexelKind = 'real' | 'uint' | 'uint4';

const lanesOf: Record<TexelKind, number> = { real: 1, uint: 1, uint4: 4 };

/** The GPU copy of a column for one renderer. */
interface GpuCopy {
  /** A restored context has another GL object, and its former textures are lost. */
  readonly properties: WebGLRenderer['properties'];
  readonly gl: WebGL2RenderingContext;
  /** Internal format of the storage. */
  readonly sizedFormat: number;
  /** Format of the uploaded data. */
  readonly format: number;
  readonly type: number;
  handle: WebGLTexture;
  rows: number;
  uploads: number;
}

/**
 * A data texture over an array that somebody else writes: nothing is copied on the CPU, and an upload sends only the
 * rows in use. The storage on the GPU is the column's own, not three's, which asks itself at every upload what
 * kind of texture it is, and makes objects on the way.
 */
export class ColumnTexture extends ExternalTexture {
  readonly #kind: TexelKind;
  readonly #copies: GpuCopy[] = [];
  #data: Float32Array | Uint32Array | undefined;
  #rows = 1;
  #used = 0;
  #uploads = 0;

  /** @throws Error when three is too old */
  constructor(kind: TexelKind) {
    requireThree();
    super();
    this.#kind = kind;
  }

  /** Number of leading texels that are up to date after the next upload. */
  get used(): number {
    return this.#used;
  }

  /** The array of the last `upload`. */
  get data(): Float32Array | Uint32Array | undefined {
    return this.#data;
  }

  /** Rows of the storage on the GPU. */
  get rows(): number {
    return this.#rows;
  }

  /** Incremented with every `upload`. */
  get uploads(): number {
    return this.#uploads;
  }

  /**
   * Has the array sent to the GPU with the next frame.
   *
   * @param data one or four values a texel, a whole number of rows
   * @param used number of leading texels that matter
   * @throws Error when `data` is not a whole number of rows
   */
  upload(data: Float32Array | Uint32Array, used: number): void {
    this.#rows = textureRows(used, this.#rows, data.length / lanesOf[this.#kind]);
    this.#data = data;
    this.#used = used;
    this.#uploads++;
  }

  /**
   * Replaces the array by another one with the values of the last `upload`, for renderers that use the texture later.
   */
  rename(data: Float32Array | Uint32Array): void {
    this.#data = data;
  }

  /** Uploads the data that this renderer lacks. Call it before each drawing, of shadows too. */
  send(renderer: WebGLRenderer): void {
    const copy = this.#copyOf(renderer);
    this.sourceTexture = copy.handle;
    if (copy.uploads === this.#uploads) return;
    copy.uploads = this.#uploads;
    bindForUpload(renderer, copy);
    if (copy.rows !== this.#rows) this.#replaceStorage(renderer, copy);
    const sent = Math.min(copy.rows, Math.ceil(this.#used / TEXTURE_WIDTH));
    if (this.#data === undefined || sent === 0) return;
    const { gl, format, type } = copy;
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, TEXTURE_WIDTH, sent, format, type, this.#data);
  }

  /** Frees the copies on GPUs. */
  override dispose(): void {
    for (const { gl, handle } of this.#copies) gl.deleteTexture(handle);
    this.#copies.length = 0;
    super.dispose();
  }

  #copyOf(renderer: WebGLRenderer): GpuCopy {
    const { properties } = renderer;
    for (let i = 0; i < this.#copies.length; i++) {
      if (this.#copies[i].properties === properties) return this.#copies[i];
    }
    return this.#makeCopy(renderer);
  }

  /** Separate from the search, because a function that contains a closure allocates in every call. */
  #makeCopy(renderer: WebGLRenderer): GpuCopy {
    const { properties } = renderer;
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const lost = this.#copies.findIndex((copy) => copy.gl === gl);
    if (lost >= 0) this.#copies.splice(lost, 1);
    const copy = { properties, gl, ...formatOf(gl, this.#kind), handle: gl.createTexture(), rows: 0, uploads: -1 };
    this.#copies.push(copy);
    return copy;
  }

  /** Immutable storage cannot be resized, so a new one is created. */
  #replaceStorage(renderer: WebGLRenderer, copy: GpuCopy): void {
    const { gl } = copy;
    if (copy.rows > 0) {
      gl.deleteTexture(copy.handle);
      copy.handle = gl.createTexture();
      this.sourceTexture = copy.handle;
      bindForUpload(renderer, copy);
    }
    copy.rows = this.#rows;
    gl.texStorage2D(gl.TEXTURE_2D, 1, copy.sizedFormat, TEXTURE_WIDTH, copy.rows);
    // Without mipmaps a texture is complete only with this filter.
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  }
}

/** Uses three.js' state cache, on a texture unit that no drawing uses. */
function bindForUpload({ state, capabilities }: WebGLRenderer, { gl, handle }: GpuCopy): void {
  const unit = gl.TEXTURE0 + capabilities.maxTextures - 1;
  state.activeTexture(unit);
  state.bindTexture(gl.TEXTURE_2D, handle, unit);
  state.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
  state.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  state.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
  state.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
}

function formatOf(gl: WebGL2RenderingContext, kind: TexelKind) {
  if (kind === 'real') return { sizedFormat: gl.R32F, format: gl.RED, type: gl.FLOAT };
  if (kind === 'uint') return { sizedFormat: gl.R32UI, format: gl.RED_INTEGER, type: gl.UNSIGNED_INT };
  return { sizedFormat: gl.RGBA32UI, format: gl.RGBA_INTEGER, type: gl.UNSIGNED_INT };
}
