import {
  type BLEND_MODES,
  Container,
  GlProgram,
  GpuProgram,
  Shader,
  type TextureSource,
  UniformGroup,
  VERSION,
} from 'pixi.js';
import { type Measure, MeasuredMesh } from './measured-mesh.ts';
import { requirePixi } from './pixi-version.ts';
import { QuadGeometry } from './quad-geometry.ts';
import { glslHeader, gpuLayout, type PullProgram, type UniformType, wgslHeader } from './shaders/pull-program.ts';

type UniformValue = number | Float32Array;

/** A mesh without vertex attributes: its shader reads all data from textures (vertex pulling). */
export class PullMesh {
  /** The container for the application; it holds the mesh, whose transform converts metres to pixels. */
  readonly container: Container;
  /** Values of the program's uniforms, by name. */
  readonly uniforms: Record<string, UniformValue>;
  readonly #mesh: MeasuredMesh;
  readonly #quads = new QuadGeometry();
  readonly #shader: Shader;
  readonly #pixelsPerMetre: number;
  readonly #name: string;

  /**
   * @param textures one for each name in `program.textures`
   * @param measure finds the box of what is drawn, from the point that `place` was given last
   * @throws Error when `pixelsPerMetre` is not a positive number, or pixi.js is too old
   */
  constructor(
    program: PullProgram,
    textures: Readonly<Record<string, TextureSource>>,
    pixelsPerMetre: number,
    blendMode: BLEND_MODES,
    measure: Measure,
  ) {
    requirePixi(VERSION);
    if (!(pixelsPerMetre > 0 && Number.isFinite(pixelsPerMetre))) {
      throw new Error(`pixelsPerMetre must be a positive number, got ${pixelsPerMetre}`);
    }
    const group = uniformGroup(program);
    this.uniforms = group.uniforms as Record<string, UniformValue>;
    this.#shader = buildShader(program, group, textures);
    this.#mesh = new MeasuredMesh(this.#quads.geometry, this.#shader, measure);
    this.#mesh.blendMode = blendMode;
    this.#mesh.eventMode = 'none';
    this.#pixelsPerMetre = pixelsPerMetre;
    this.#name = program.name;
    this.container = new Container({ label: program.name, children: [this.#mesh] });
    this.container.eventMode = 'none';
    this.container.cullableChildren = false;
    this.#mesh.scale.set(pixelsPerMetre, -pixelsPerMetre);
    this.draw(0);
  }

  /**
   * Sets the world point (x, y), metres, of the shader's origin. Pixi adds it to the camera's offset in f64, so a
   * distant origin costs no precision. Call it whenever something drawn has moved.
   */
  place(originX: number, originY: number): void {
    const scale = this.#pixelsPerMetre;
    this.#mesh.position.set(originX * scale, -originY * scale);
    this.#mesh.changed();
  }

  /** Draws the first `quads` quads, `instances` times over. */
  draw(quads: number, instances = 1): void {
    this.#mesh.visible = quads > 0 && instances > 0;
    if (this.#mesh.visible && this.#quads.draw(quads, instances)) this.#mesh.geometry = this.#quads.geometry;
  }

  /** @throws Error when the layer was destroyed: its textures would be sent to the GPU again */
  assertDrawable(): void {
    if (!this.container.destroyed) return;
    throw new Error(`this layer (${this.#name}) was destroyed: do not update it any more`);
  }

  destroy(): void {
    this.container.destroy({ children: true });
    this.#shader.destroy();
    this.#quads.destroy();
  }
}

const ZEROS: Readonly<Record<UniformType, () => UniformValue>> = {
  f32: () => 0,
  i32: () => 0,
  'vec2<f32>': () => new Float32Array(2),
  'vec4<f32>': () => new Float32Array(4),
};

function uniformGroup(program: PullProgram): UniformGroup {
  const structures: Record<string, { value: UniformValue; type: UniformType }> = {};
  for (const [name, type] of Object.entries(program.uniforms)) structures[name] = { value: ZEROS[type](), type };
  return new UniformGroup(structures);
}

function buildShader(
  program: PullProgram,
  group: UniformGroup,
  textures: Readonly<Record<string, TextureSource>>,
): Shader {
  const { name } = program;
  const header = glslHeader(program);
  const source = wgslHeader(program) + program.wgsl;
  return new Shader({
    glProgram: GlProgram.from({
      name,
      vertex: header.vertex + program.glsl.vertex,
      fragment: header.fragment + program.glsl.fragment,
      preferredFragmentPrecision: 'highp',
    }),
    gpuProgram: GpuProgram.from({
      name,
      vertex: { source, entryPoint: 'mainVertex' },
      fragment: { source, entryPoint: 'mainFragment' },
      gpuLayout: gpuLayout(program),
    }),
    resources: { own: group, ...textures },
  });
}
