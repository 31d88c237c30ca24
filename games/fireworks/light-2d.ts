/** The afterglow in pixi: what shines is drawn into a picture that fades, which is blurred, mirrored and shown. */
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

/** Bloom is worked out on pictures of a quarter and a sixteenth of the width. */
const NEAR = 4;
const FAR = 12;

export interface Light2D {
  /** Shows all light; add it over the sky. */
  readonly container: Container;
  resize(width: number, height: number, resolution: number): void;
  /** Lets the light fade by `fade` and adds what shines now. */
  add(shining: Container, fade: number): void;
  /** Brings the shown picture up to date. @param horizon height of the water's edge, 0 to 1 @param time of its waves, s */
  show(horizon: number, time: number): void;
  /** Forgets all light. */
  clear(): void;
  destroy(): void;
}

type Uniforms = Record<string, { value: number | Float32Array; type: 'f32' | 'vec2<f32>' }>;

export function createLight2D(renderer: WebGLRenderer): Light2D {
  const hasFloats = renderer.gl.getExtension('EXT_color_buffer_float') !== null;
  const format = hasFloats ? 'rgba16float' : 'rgba8unorm';
  const target = () =>
    RenderTexture.create({
      width: 8,
      height: 8,
      dynamic: true,
      format,
      scaleMode: 'linear',
      autoGarbageCollect: false,
    });
  const [one, other, half, near, narrow, far] = Array.from({ length: 6 }, target);
  const least = hasFloats ? 0.0004 : 1 / 255;
  const fades = [one, other].map((last) => pass(FADE, { uLast: last }, { uFade: f32(1), uLeast: f32(least) }));
  const shows = [other, one].map((light) =>
    pass(SHOW, { uLight: light, uNear: near, uFar: far }, { uHorizon: f32(0), uTime: f32(0) }),
  );
  const blurs = [one, other].map((light) => [
    { made: pass(BLUR, { uLight: light }, stride()), to: half, across: true, by: NEAR },
    { made: pass(BLUR, { uLight: half }, stride()), to: near, across: false, by: NEAR },
    { made: pass(BLUR, { uLight: near }, stride()), to: narrow, across: true, by: FAR },
    { made: pass(BLUR, { uLight: narrow }, stride()), to: far, across: false, by: FAR },
    // Once more: a single bell is cut off where it is still bright enough to show a square.
    { made: pass(BLUR, { uLight: far }, stride()), to: narrow, across: true, by: FAR },
    { made: pass(BLUR, { uLight: narrow }, stride()), to: far, across: false, by: FAR },
  ]);
  const nothing = new Group();
  const container = new Group();
  for (const { mesh } of shows) container.addChild(mesh);
  const passes = [...fades, ...shows, ...blurs.flatMap((chain) => chain.map(({ made }) => made))];
  let now = 0;
  const order: { container: Container; target: RenderTexture; clear: boolean; transform?: Matrix | undefined } = {
    container,
    target: one,
    clear: true,
  };
  const draw = (what: Container, onto: RenderTexture, clear: boolean) => {
    order.container = what;
    order.target = onto;
    order.clear = clear;
    // Pixi writes the container's own transform there, and would use it for the next one.
    order.transform = undefined;
    renderer.render(order as RenderOptions);
  };
  const clear = () => {
    // No program is needed to draw nothing.
    for (const light of [one, other]) draw(nothing, light, true);
    container.visible = false;
  };
  return {
    container,
    resize(width, height, resolution) {
      for (const light of [one, other]) light.resize(width, height, resolution);
      for (const [by, pair] of [
        [NEAR, [half, near]],
        [FAR, [narrow, far]],
      ] as const) {
        for (const small of pair)
          small.resize(Math.max(1, Math.ceil(width / by)), Math.max(1, Math.ceil(height / by)), 1);
      }
      for (const chain of blurs) {
        for (const { made, across, by } of chain) {
          const texel = 0.5 * by;
          made.group.uniforms.uStride = new Float32Array(across ? [texel / width, 0] : [0, texel / height]);
        }
      }
      clear();
    },
    add(shining, fade) {
      container.visible = true;
      const { mesh, group } = fades[now];
      now = 1 - now;
      const onto = now === 1 ? other : one;
      group.uniforms.uFade = fade;
      draw(mesh, onto, true);
      draw(shining, onto, false);
      const chain = blurs[now];
      for (let i = 0; i < chain.length; i++) draw(chain[i].made.mesh, chain[i].to, true);
    },
    show(horizon, time) {
      for (let i = 0; i < shows.length; i++) {
        const { mesh, group } = shows[i];
        // The picture drawn last.
        mesh.visible = i === 1 - now;
        group.uniforms.uHorizon = horizon;
        group.uniforms.uTime = time;
      }
    },
    clear,
    destroy() {
      container.destroy();
      nothing.destroy();
      for (const { mesh, geometry, shader } of passes) {
        mesh.destroy();
        geometry.destroy(true);
        shader.destroy();
      }
      for (const texture of [one, other, half, near, narrow, far]) texture.destroy(true);
    },
  };
}

function f32(value: number) {
  return { value, type: 'f32' } as const;
}

function stride(): Uniforms {
  return { uStride: { value: new Float32Array(2), type: 'vec2<f32>' } };
}

/** A rectangle over the whole target that runs `fragment`. */
function pass(fragment: string, textures: Record<string, RenderTexture>, uniforms: Uniforms) {
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
