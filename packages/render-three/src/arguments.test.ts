import { createPhysicsWorld } from '@principia/physics';
import { worldSource } from '@principia/render-core';
import { PerspectiveCamera } from 'three';
import { expect, it } from 'vitest';
import { listenToBodyDragging } from './body-dragging.ts';
import { createBodyMesh } from './body-mesh.ts';
import { fitRendererToParent } from './renderer-size.ts';
import { createTrailLines } from './trail-lines.ts';

const world = createPhysicsWorld({ capacity: 10 });

it.each([
  { createBodyMesh },
  { createTrailLines },
  { listenToBodyDragging: (options: object) => listenToBodyDragging({} as never, options as never) },
])('says that it needs a source where it is given a world: %o', (named) => {
  const [[name, make]] = Object.entries(named) as [string, (options: unknown) => unknown][];
  const wanted = `${name} needs a source of bodies: ${name}({ source: worldSource(world) })`;
  for (const given of [undefined, {}, { world }, { source: world }]) {
    expect(() => make(given), JSON.stringify(Object.keys(given ?? {}))).toThrow(wanted);
  }
});

it('says that it needs a renderer and a camera to fit', () => {
  const wanted = 'fitRendererToParent(renderer, camera)';
  expect(() => fitRendererToParent(undefined as never, new PerspectiveCamera())).toThrow(wanted);
  expect(() => fitRendererToParent({ domElement: {} } as never, undefined as never)).toThrow(wanted);
});

it('says that a source is made from a world', () => {
  expect(() => worldSource(undefined as never)).toThrow('worldSource(world)');
  expect(() => worldSource({} as never)).toThrow('worldSource(world)');
});
