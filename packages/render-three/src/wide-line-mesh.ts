import {
  BufferGeometry,
  DoubleSide,
  type IUniform,
  Mesh,
  ShaderMaterial,
  Sphere,
  Vector3,
  type WebGLRenderer,
} from 'three';
import { wideLineFragment, wideLineMain, wideLinePars } from './shaders/wide-line.ts';
import { TargetPixels } from './target-pixels.ts';

/** Vertices per segment: two triangles without shared vertices, so that no index buffer is needed. */
const VERTICES = 6;

/** A mesh whose shader builds line segments from data textures. */
export interface WideLineMesh {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  /** Draws segments `0 … count - 1`. */
  setCount(count: number): void;
  destroy(): void;
}

/**
 * Makes the mesh of lines `width` CSS pixels wide.
 *
 * @param segmentEnds GLSL declarations and the function `segmentEnds`, see `wideLineMain`
 * @param prepare called before each drawing, when changed textures can still be marked for upload
 * @throws Error when `width` is not positive
 */
export function createWideLineMesh(
  segmentEnds: string,
  uniforms: Record<string, IUniform>,
  width: number,
  prepare: (renderer: WebGLRenderer) => void,
): WideLineMesh {
  if (!(width > 0)) throw new Error(`the width of lines must be a positive number of pixels, got ${width}`);
  const target = new TargetPixels();
  const lineWidth = { value: width };
  const geometry = new BufferGeometry();
  geometry.boundingSphere = new Sphere(new Vector3(), Number.POSITIVE_INFINITY);
  geometry.setDrawRange(0, 0);
  const material = new ShaderMaterial({
    uniforms: { ...uniforms, targetSize: target.size, lineWidth },
    vertexShader: wideLinePars + segmentEnds + wideLineMain,
    fragmentShader: wideLineFragment,
    side: DoubleSide,
    transparent: true,
    depthWrite: false,
    toneMapped: false,
  });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.raycast = () => {};
  mesh.onBeforeRender = (renderer: WebGLRenderer) => {
    target.read(renderer);
    lineWidth.value = width * renderer.getPixelRatio();
    prepare(renderer);
  };
  return {
    mesh,
    setCount(count) {
      geometry.drawRange.count = count * VERTICES;
    },
    destroy() {
      geometry.dispose();
      material.dispose();
    },
  };
}
