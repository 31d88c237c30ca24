/**
 * The afterglow in pixi: glowing bodies are drawn into a texture that fades, which is then blurred, mirrored and shown.
 */
import {
  type Container,
  Geometry,
  GlProgram,
  Container as Group,
  type Matrix,
  Mesh,
  type RenderOptions,
  RenderTexture,
  Shader,
  UniformGroup,
  type WebGLRenderer,
} from 'pixi.js';
import { BLUR, FADE, SHOW } from './light-shaders.ts';

const vertex = `#version 300 es
in vec2 aPosition;
out vec2 vPlace;
void main() {
  vPlace = aPosition;
  gl_Position = vec4(2.0 * aPosition - 1.0, 0.0, 1.0);
}`;

const fragmentStart = `#version 300 es
precision highp float;
in vec2 vPlace;
out vec4 finalColor;
#define UP(place) vec2((place).x, 1.0 - (place).y)
void paint(vec4 color) { finalColor = color; }
`;

/** Bloom is computed at a quarter and a twelfth of the width. */
const NEAR = 4;
const FAR = 12;

export interface Light2D {
  /** Shows all light; add it over the sky. */
  readonly container: Container;
  resize(width: number, height: number, resolution: number): void;
  /** Fades the light by the factor `fade` and adds the light of `shining`. */
  add(shining: Container, fade: number): void;
  /**
   * Sets the parameters of the displayed light. @param horizon height of the waterline, 0 to 1 @param time of its
   * waves, s
   */
  show(horizon: number, time: number): void;
  /** Removes all light. */
  clear(): void;
  destroy(): void;
}

type Uniforms = Record<string, { value: number | Float32Array; type: 'f32' | 'vec2<f32>' }>;

export function createLight2D(renderer: WebGLRenderer): Light2D {
  const hasFloats = renderer.gl.getExtension('EXT_color_buffer_float') !== null;
  const textures = createTextures(hasFloats);
  const { lights } = textures;
  const { fades, shows, blurs } = createPasses(textures, hasFloats ? 0.0004 : 1 / 255);
  const empty = new Group();
  const container = new Group();
  for (const { mesh } of shows) container.addChild(mesh);
  const draw = createDraw(renderer);
  let now = 0;
  const clear = () => {
    // Clearing by drawing an empty container needs no shader program.
    for (const light of lights) draw(empty, light, true);
    container.visible = false;
  };
  return {
    container,
    resize(width, height, resolution) {
      resizeTextures(textures, width, height, resolution);
      setStrides(blurs, width, height);
      clear();
    },
    add(shining, fade) {
      container.visible = true;
      const { mesh, group } = fades[now];
      now = 1 - now;
      group.uniforms.uFade = fade;
      draw(mesh, lights[now], true);
      draw(shining, lights[now], false);
      const chain = blurs[now];
      for (let i = 0; i < chain.length; i++) draw(chain[i].pass.mesh, chain[i].target, true);
    },
    show(horizon, time) {
      for (let i = 0; i < shows.length; i++) {
        const { mesh, group } = shows[i];
        // The texture drawn last.
        mesh.visible = i === 1 - now;
        group.uniforms.uHorizon = horizon;
        group.uniforms.uTime = time;
      }
    },
    clear,
    destroy() {
      container.destroy();
      empty.destroy();
      for (const { mesh, geometry, shader } of [...fades, ...shows, ...blurs.flat().map(({ pass }) => pass)]) {
        mesh.destroy();
        geometry.destroy(true);
        shader.destroy();
      }
      for (const texture of [...lights, ...textures.near, ...textures.far]) texture.destroy(true);
    },
  };
}

/** The two light textures that alternate, and for each blur the results of its horizontal and vertical pass. */
interface Textures {
  readonly lights: readonly [RenderTexture, RenderTexture];
  readonly near: readonly [RenderTexture, RenderTexture];
  readonly far: readonly [RenderTexture, RenderTexture];
}

function createTextures(hasFloats: boolean): Textures {
  const format = hasFloats ? 'rgba16float' : 'rgba8unorm';
  const make = () =>
    RenderTexture.create({
      width: 8,
      height: 8,
      dynamic: true,
      format,
      scaleMode: 'linear',
      autoGarbageCollect: false,
    });
  const pair = () => [make(), make()] as const;
  return { lights: pair(), near: pair(), far: pair() };
}

function resizeTextures({ lights, near, far }: Textures, width: number, height: number, resolution: number): void {
  for (const light of lights) light.resize(width, height, resolution);
  const shrink = (texture: RenderTexture, factor: number) =>
    texture.resize(Math.max(1, Math.ceil(width / factor)), Math.max(1, Math.ceil(height / factor)), 1);
  for (const texture of near) shrink(texture, NEAR);
  for (const texture of far) shrink(texture, FAR);
}

interface BlurStep {
  readonly pass: Pass;
  readonly target: RenderTexture;
  readonly isHorizontal: boolean;
  /** Factor by which the target is smaller than the window. */
  readonly factor: number;
}

/** `fades[i]` and `blurs[i]` read `lights[i]`; `shows[i]` reads the other one. */
function createPasses({ lights, near, far }: Textures, threshold: number) {
  const [first, second] = lights;
  const fades = lights.map((last) => createPass(FADE, { uLast: last }, { uFade: f32(1), uThreshold: f32(threshold) }));
  const shows = [second, first].map((light) =>
    createPass(SHOW, { uLight: light, uNear: near[1], uFar: far[1] }, { uHorizon: f32(0), uTime: f32(0) }),
  );
  const blur = (source: RenderTexture, target: RenderTexture, isHorizontal: boolean, factor: number): BlurStep => {
    return { pass: createPass(BLUR, { uLight: source }, stride()), target, isHorizontal, factor };
  };
  const blurs = lights.map((light) => [
    blur(light, near[0], true, NEAR),
    blur(near[0], near[1], false, NEAR),
    blur(near[1], far[0], true, FAR),
    blur(far[0], far[1], false, FAR),
    // A second pass: a single Gaussian is cut off where it is bright enough to show a square.
    blur(far[1], far[0], true, FAR),
    blur(far[0], far[1], false, FAR),
  ]);
  return { fades, shows, blurs };
}

function setStrides(blurs: readonly (readonly BlurStep[])[], width: number, height: number): void {
  for (const { pass, isHorizontal, factor } of blurs.flat()) {
    const texel = 0.5 * factor;
    pass.group.uniforms.uStride = new Float32Array(isHorizontal ? [texel / width, 0] : [0, texel / height]);
  }
}

type Draw = (content: Container, target: RenderTexture, clear: boolean) => void;

/** Returns a function that renders a container to a texture without allocating. */
function createDraw(renderer: WebGLRenderer): Draw {
  const options: { container?: Container; target?: RenderTexture; clear?: boolean; transform?: Matrix | undefined } =
    {};
  return (content, target, clear) => {
    options.container = content;
    options.target = target;
    options.clear = clear;
    // Pixi stores the container's transform here and would apply it to the next one.
    options.transform = undefined;
    renderer.render(options as RenderOptions);
  };
}

function f32(value: number) {
  return { value, type: 'f32' } as const;
}

function stride(): Uniforms {
  return { uStride: { value: new Float32Array(2), type: 'vec2<f32>' } };
}

/** A rectangle over the whole target that runs `fragment`. */
function createPass(fragment: string, textures: Record<string, RenderTexture>, uniforms: Uniforms) {
  const group = new UniformGroup(uniforms);
  const sources = Object.fromEntries(Object.entries(textures).map(([name, { source }]) => [name, source]));
  const shader = new Shader({
    glProgram: GlProgram.from({ vertex, fragment: fragmentStart + fragment, preferredFragmentPrecision: 'highp' }),
    resources: { own: group, ...sources },
  });
  const geometry = new Geometry({
    attributes: { aPosition: new Float32Array([0, 0, 1, 0, 1, 1, 0, 1]) },
    indexBuffer: new Uint32Array([0, 1, 2, 0, 2, 3]),
  });
  const mesh = new Mesh({ geometry, shader });
  return { mesh, group, geometry, shader };
}

type Pass = ReturnType<typeof createPass>;
