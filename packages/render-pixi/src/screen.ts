// Layers are meshes; a page imports the other parts of pixi that it uses.
import 'pixi.js/mesh';
import { sizeToFill } from '@principia/render-core';
import {
  type AutoDetectOptions,
  autoDetectRenderer,
  Container,
  type Renderer,
  type RenderOptions,
  VERSION,
  type WebGLOptions,
  WebGLRenderer,
} from 'pixi.js';
import { requirePixi } from './pixi-version.ts';

/** A canvas with a pixi renderer. */
export interface Screen {
  /** Pixi's own, to be resized with the canvas: `renderer.resize(width, height, resolution)`, CSS pixels. */
  readonly renderer: Renderer;
  /** The canvas, the last child of `parent`. */
  readonly canvas: HTMLCanvasElement;
  /** The root of the drawn objects. */
  readonly stage: Container;
  /** Renders the stage without allocating. */
  render(): void;
  /** Frees everything on the stage and removes the canvas. Further calls do nothing. */
  destroy(): void;
}

/** Options of pixi's renderers, except those by which pixi would choose a renderer, a context or a canvas. */
export type ScreenOptions = Partial<
  Omit<
    WebGLOptions & AutoDetectOptions,
    'canvas' | 'context' | 'preference' | 'preferWebGLVersion' | 'webgl' | 'canvasOptions' | 'skipExtensionImports'
  >
>;

/**
 * Opens a canvas of the size of `parent`, at the display's pixel ratio but at most 2, with WebGL 2, or with WebGPU if there is
 * none; follow `parent` with `watchViewport`. Pixi's `Application` also creates a canvas, but tests WebGL on a second one, resizes the canvas, and
 * loads events, filters and other parts before the first picture. Here a page imports `pixi.js/graphics` and so on
 * itself.
 *
 * @throws Error when there is no parent, the browser has neither, or pixi.js is too old
 */
export async function openScreen(parent: HTMLElement, options: ScreenOptions = {}): Promise<Screen> {
  requirePixi(VERSION);
  if (typeof parent?.append !== 'function') {
    throw new Error('openScreen needs the element for its canvas: openScreen(document.body)');
  }
  const { width, height, resolution } = sizeToFill(parent);
  const size = { width: Math.max(1, width), height: Math.max(1, height), resolution };
  const wanted = { autoDensity: true, ...size, ...options, skipExtensionImports: true };
  const renderer = (await openWebGL(wanted)) ?? (await autoDetectRenderer({ ...wanted, preference: ['webgpu'] }));
  parent.append(renderer.canvas);
  const stage = new Container({ eventMode: 'none' });
  const order: { -readonly [Key in keyof RenderOptions]: RenderOptions[Key] | undefined } = { container: stage };
  let live = true;
  return {
    renderer,
    canvas: renderer.canvas,
    stage,
    render() {
      // Pixi writes these fields and would read them as options the next time.
      order.transform = undefined;
      order.clearColor = undefined;
      renderer.render(order as RenderOptions);
    },
    destroy() {
      if (!live) return;
      live = false;
      stage.destroy({ children: true });
      renderer.destroy({ removeView: true, releaseGlobalResources: false });
    },
  };
}

interface Size {
  readonly width: number;
  readonly height: number;
  readonly resolution: number;
}

async function openWebGL(options: ScreenOptions & Size): Promise<Renderer | undefined> {
  const canvas = document.createElement('canvas');
  // The size is set first: resizing the canvas of a context re-creates all its buffers.
  canvas.width = Math.round(options.width * options.resolution);
  canvas.height = Math.round(options.height * options.resolution);
  const context = canvas.getContext('webgl2', {
    alpha: (options.backgroundAlpha ?? 1) < 1,
    antialias: options.antialias ?? false,
    powerPreference: options.powerPreference ?? 'default',
    premultipliedAlpha: options.premultipliedAlpha ?? true,
    preserveDrawingBuffer: options.preserveDrawingBuffer ?? false,
    stencil: true,
  });
  if (context === null) return undefined;
  const renderer = new WebGLRenderer();
  await renderer.init({ ...options, canvas, context });
  return renderer as Renderer;
}
