/**
 * What the engine knows, drawn over the bodies: contacts with their normals, contacts that are solved side by side, boxes
 * and which bodies sleep, or islands.
 */
import type { PhysicsWorld } from '@principia/physics';
import { createBoxLayer, createContactLayer } from '@principia/render-pixi';
import { Container } from 'pixi.js';

export interface InsideLayers {
  readonly container: Container;
  /** Shows one of the layers, or none, and brings it up to date. */
  update(shown: string): void;
  destroy(): void;
}

export function createInsideLayers(world: PhysicsWorld): InsideLayers {
  const layers = {
    contacts: createContactLayer({ world }),
    colors: createContactLayer({ world, byColor: true, normalLength: 0, pointSize: 9 }),
    boxes: createBoxLayer({ world }),
    islands: createBoxLayer({ world, byIsland: true, thickness: 2 }),
  };
  const container = new Container({ children: Object.values(layers).map((layer) => layer.container) });
  return {
    container,
    update(shown) {
      for (const [name, layer] of Object.entries(layers)) {
        layer.container.visible = name === shown;
        if (name === shown) layer.update();
      }
    },
    destroy() {
      for (const layer of Object.values(layers)) layer.destroy();
      container.destroy();
    },
  };
}
