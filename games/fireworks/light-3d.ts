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
const KEPT = 'void paint(vec4 color) { finalColor = color; }\n';
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
  const target = () => new WebGLRenderTarget(8, 8, { type: HalfFloatType, depthBuffer: false });
  const [one, other, half, near, narrow, far] = Array.from({ length: 6 }, target);
  const screen = new Scene();
  const quad = new Mesh(new PlaneGeometry(2, 2));
  quad.frustumCulled = false;
  screen.add(quad);
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
  const fade = make(FADE, KEPT, { uLast: { value: null }, uFade: { value: 0 }, uThreshold: { value: 0.0004 } });
  const blur = make(BLUR, KEPT, { uLight: { value: null }, uStride: { value: new Vector2() } });
  const uniforms = { uLight: { value: one.texture }, uNear: { value: near.texture }, uFar: { value: far.texture } };
  const show = make(SHOW, DISPLAYED, { ...uniforms, uHorizon: { value: 0 }, uTime: { value: 0 } });
  Object.assign(show, {
    blending: CustomBlending,
    blendEquation: AddEquation,
    blendSrc: OneFactor,
    blendDst: OneFactor,
  });
  let [now, before] = [one, other];
  const run = (material: RawShaderMaterial, onto: WebGLRenderTarget | null) => {
    quad.material = material as never;
    renderer.setRenderTarget(onto);
    renderer.render(screen, camera);
  };
  const spread = (from: WebGLRenderTarget, onto: WebGLRenderTarget, across: number, up: number) => {
    blur.uniforms.uLight.value = from.texture;
    blur.uniforms.uStride.value.set(across / now.width, up / now.height);
    run(blur, onto);
  };
  return {
    resize(width, height) {
      for (const light of [one, other]) light.setSize(width, height);
      for (const small of [half, near]) small.setSize(Math.ceil(width / NEAR), Math.ceil(height / NEAR));
      for (const small of [narrow, far]) small.setSize(Math.ceil(width / FAR), Math.ceil(height / FAR));
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
      spread(now, half, 0.5 * NEAR, 0);
      spread(half, near, 0, 0.5 * NEAR);
      spread(near, narrow, 0.5 * FAR, 0);
      spread(narrow, far, 0, 0.5 * FAR);
      // A second pass: a single Gaussian is cut off where it is bright enough to show a square.
      spread(far, narrow, 0.5 * FAR, 0);
      spread(narrow, far, 0, 0.5 * FAR);
      renderer.setRenderTarget(null);
    },
    show() {
      show.uniforms.uLight.value = now.texture;
      run(show, null);
    },
    clear() {
      for (const light of [one, other]) {
        renderer.setRenderTarget(light);
        renderer.clear();
      }
      renderer.setRenderTarget(null);
    },
    destroy() {
      for (const light of [one, other, half, near, narrow, far]) light.dispose();
      for (const material of [fade, blur, show]) material.dispose();
      quad.geometry.dispose();
    },
  };
}
