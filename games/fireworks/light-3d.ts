/** The afterglow in three.js: glowing bodies are drawn into a texture that fades, which is then blurred and shown. */
import {
  AddEquation,
  type Camera,
  CustomBlending,
  GLSL3,
  HalfFloatType,
  Mesh,
  NoBlending,
  OneFactor,
  PlaneGeometry,
  RawShaderMaterial,
  Scene,
  Vector2,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { BLUR, FADE, SHOW } from './light-shaders.ts';

const vertexShader = `in vec3 position;
out vec2 vPlace;
void main() {
  vPlace = 0.5 * position.xy + 0.5;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}`;

const fragmentStart = `precision highp float;
in vec2 vPlace;
out vec4 finalColor;
#define UP(place) (place)
`;
const LINEAR = 'void paint(vec4 color) { finalColor = color; }\n';
/** three.js adds light in linear values; the display needs sRGB. */
const DISPLAYED = 'void paint(vec4 color) { finalColor = vec4(pow(color.rgb, vec3(1.0 / 2.2)), color.a); }\n';

const NEAR = 4;
const FAR = 12;

export interface Light3D {
  resize(width: number, height: number): void;
  /** Fades the light by the factor `fade` and adds the light that `draw` renders. */
  add(fade: number, draw: () => void): void;
  /** Adds the light to the content of the screen. */
  show(): void;
  clear(): void;
  destroy(): void;
}

export function createLight3D(renderer: WebGLRenderer, camera: Camera): Light3D {
  const targets = createTargets();
  const { lights, near, far } = targets;
  const { fade, blur, show } = createMaterials(near[1], far[1]);
  const { quad, run } = createScreenPass(renderer, camera);
  let [now, before] = lights;
  const blurInto = (source: WebGLRenderTarget, target: WebGLRenderTarget, across: number, up: number) => {
    blur.uniforms.uLight.value = source.texture;
    blur.uniforms.uStride.value.set(across / now.width, up / now.height);
    run(blur, target);
  };
  return {
    resize(width, height) {
      for (const light of lights) light.setSize(width, height);
      for (const target of near) target.setSize(Math.ceil(width / NEAR), Math.ceil(height / NEAR));
      for (const target of far) target.setSize(Math.ceil(width / FAR), Math.ceil(height / FAR));
      this.clear();
    },
    add(share, draw) {
      const last = now;
      now = before;
      before = last;
      fade.uniforms.uLast.value = before.texture;
      fade.uniforms.uFade.value = share;
      run(fade, now);
      draw();
      blurInto(now, near[0], 0.5 * NEAR, 0);
      blurInto(near[0], near[1], 0, 0.5 * NEAR);
      blurInto(near[1], far[0], 0.5 * FAR, 0);
      blurInto(far[0], far[1], 0, 0.5 * FAR);
      // A second pass: a single Gaussian is cut off where it is bright enough to show a square.
      blurInto(far[1], far[0], 0.5 * FAR, 0);
      blurInto(far[0], far[1], 0, 0.5 * FAR);
      renderer.setRenderTarget(null);
    },
    show() {
      show.uniforms.uLight.value = now.texture;
      run(show, null);
    },
    clear() {
      for (const light of lights) {
        renderer.setRenderTarget(light);
        renderer.clear();
      }
      renderer.setRenderTarget(null);
    },
    destroy() {
      for (const target of [...lights, ...near, ...far]) target.dispose();
      for (const material of [fade, blur, show]) material.dispose();
      quad.geometry.dispose();
    },
  };
}

/** The two light targets that alternate, and for each blur the results of its horizontal and vertical pass. */
function createTargets() {
  const make = () => new WebGLRenderTarget(8, 8, { type: HalfFloatType, depthBuffer: false });
  const pair = () => [make(), make()] as const;
  return { lights: pair(), near: pair(), far: pair() };
}

function createMaterials(near: WebGLRenderTarget, far: WebGLRenderTarget) {
  const make = (fragment: string, paint: string, uniforms: Record<string, { value: unknown }>) =>
    new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader: fragmentStart + paint + fragment,
      uniforms,
      blending: NoBlending,
      depthTest: false,
      depthWrite: false,
    });
  const fade = make(FADE, LINEAR, { uLast: { value: null }, uFade: { value: 0 }, uThreshold: { value: 0.0004 } });
  const blur = make(BLUR, LINEAR, { uLight: { value: null }, uStride: { value: new Vector2() } });
  const blooms = { uNear: { value: near.texture }, uFar: { value: far.texture } };
  const show = make(SHOW, DISPLAYED, {
    ...blooms,
    uLight: { value: null },
    uHorizon: { value: 0 },
    uTime: { value: 0 },
  });
  Object.assign(show, {
    blending: CustomBlending,
    blendEquation: AddEquation,
    blendSrc: OneFactor,
    blendDst: OneFactor,
  });
  return { fade, blur, show };
}

/** A rectangle over the whole target, and a function that runs a material on it. */
function createScreenPass(renderer: WebGLRenderer, camera: Camera) {
  const screen = new Scene();
  const quad = new Mesh(new PlaneGeometry(2, 2));
  quad.frustumCulled = false;
  screen.add(quad);
  const run = (material: RawShaderMaterial, target: WebGLRenderTarget | null) => {
    quad.material = material as never;
    renderer.setRenderTarget(target);
    renderer.render(screen, camera);
  };
  return { quad, run };
}
