/** The sky and the holes: with gravitational lensing where the renderer supports the shader, plain elsewhere. */
import 'pixi.js/sprite-tiling';
import type { Camera2D, ViewportSize } from '@principia/render-core';
import { Container, Geometry, Graphics, Mesh, Shader, type Texture, TilingSprite, UniformGroup } from 'pixi.js';
import { lensProgram, MAX_LENSES } from './lens-program.ts';
import { SKY_METRES } from './stars.ts';

/** For each hole x, y, radius and one unused value. */
export interface HoleTable {
  readonly values: Float32Array;
  count: number;
}

export interface SkyView {
  readonly container: Container;
  /** @param time one number, s */
  update(holes: HoleTable, camera: Camera2D, size: ViewportSize, time: Float64Array): void;
  destroy(): void;
}

export function createBentSky(sky: Texture): SkyView {
  const group = new UniformGroup({
    uHoles: { value: new Float32Array(4 * MAX_LENSES), type: 'vec4<f32>', size: MAX_LENSES },
    uCount: { value: 0, type: 'i32' },
    uCamera: { value: new Float32Array(3), type: 'vec3<f32>' },
    uSize: { value: new Float32Array(2), type: 'vec2<f32>' },
    uTime: { value: 0, type: 'f32' },
    uSkyMetres: { value: SKY_METRES, type: 'f32' },
  });
  const shader = new Shader({ glProgram: lensProgram(), resources: { own: group, uSky: sky.source } });
  const geometry = new Geometry({
    attributes: { aPosition: new Float32Array([0, 0, 1, 0, 1, 1, 0, 1]) },
    indexBuffer: new Uint32Array([0, 1, 2, 0, 2, 3]),
  });
  const mesh = new Mesh({ geometry, shader });
  const container = new Container({ children: [mesh] });
  const { uniforms } = group;
  return {
    container,
    update({ values, count }, camera, { width, height }, time) {
      uniforms.uHoles.set(values);
      uniforms.uCount = count;
      uniforms.uCamera[0] = camera.x;
      uniforms.uCamera[1] = camera.y;
      uniforms.uCamera[2] = camera.pixelsPerMetre;
      uniforms.uSize[0] = width;
      uniforms.uSize[1] = height;
      uniforms.uTime = time[0];
      group.update();
    },
    destroy() {
      container.destroy({ children: true, context: true });
      geometry.destroy(true);
      shader.destroy();
    },
  };
}

export function createPlainSky(sky: Texture): SkyView {
  const stars = new TilingSprite({ texture: sky, width: 1, height: 1 });
  const discs = new Graphics();
  const container = new Container({ children: [stars, discs] });
  return {
    container,
    update({ values, count }, { x, y, pixelsPerMetre }, { width, height }) {
      stars.width = width;
      stars.height = height;
      stars.tileScale.set((SKY_METRES * pixelsPerMetre) / sky.width);
      stars.tilePosition.set(width / 2 - x * pixelsPerMetre, height / 2 + y * pixelsPerMetre);
      discs.clear();
      discs.position.set(width / 2 - x * pixelsPerMetre, height / 2 + y * pixelsPerMetre);
      discs.scale.set(pixelsPerMetre, -pixelsPerMetre);
      for (let i = 0; i < count; i++) {
        const [hx, hy, r] = values.subarray(4 * i, 4 * i + 3);
        discs.circle(hx, hy, 1.5 * r).fill({ color: 0xff8a3c, alpha: 0.16 });
        discs.circle(hx, hy, r).fill(0x000000);
        discs.circle(hx, hy, 1.1 * r).stroke({ width: 0.12 * r, color: 0xffc27a });
      }
    },
    destroy: () => container.destroy({ children: true, context: true }),
  };
}
