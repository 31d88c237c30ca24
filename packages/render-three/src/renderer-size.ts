import { type Viewport, type ViewportOptions, watchViewport } from '@principia/render-core';
import type { OrthographicCamera, PerspectiveCamera, WebGLRenderer } from 'three';

/**
 * Keeps a renderer as large as the parent element of its canvas, at the display's pixel ratio but at most 2, and the
 * camera's shape with it. A parallel camera keeps its height.
 *
 * @throws Error when there is no renderer or no camera, or the renderer's canvas is not on the page
 */
export function fitRendererToParent(
  renderer: WebGLRenderer,
  camera: PerspectiveCamera | OrthographicCamera,
  options: ViewportOptions & { onResize?(width: number, height: number): void } = {},
): Viewport {
  if (renderer?.domElement === undefined || typeof camera?.updateProjectionMatrix !== 'function') {
    throw new Error('fitRendererToParent needs a renderer and its camera: fitRendererToParent(renderer, camera)');
  }
  return watchViewport(
    renderer.domElement,
    (width, height, resolution) => {
      renderer.setPixelRatio(resolution);
      renderer.setSize(width, height);
      shapeCamera(camera, width / height);
      options.onResize?.(width, height);
    },
    options,
  );
}

function shapeCamera(camera: PerspectiveCamera | OrthographicCamera, aspect: number): void {
  if ('isPerspectiveCamera' in camera) {
    camera.aspect = aspect;
  } else {
    const middle = (camera.left + camera.right) / 2;
    const halfWidth = ((camera.top - camera.bottom) / 2) * aspect;
    camera.left = middle - halfWidth;
    camera.right = middle + halfWidth;
  }
  camera.updateProjectionMatrix();
}
