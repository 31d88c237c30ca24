import { createPhysicsWorld } from '@principia/physics';
import { checkAlpha, worldSource } from '@principia/render-core';
import { BufferGeometry, MeshBasicMaterial, PerspectiveCamera } from 'three';
import { expect, it } from 'vitest';
import { listenToBodyDragging } from './body-dragging.ts';
import { createBodyMesh } from './body-mesh.ts';
import { createOrbitCamera } from './orbit-camera.ts';
import { fitRendererToParent } from './renderer-size.ts';
import { createSegmentLines } from './segment-lines.ts';
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

it('names an option that does not exist, and those that do', () => {
  const source = worldSource(world);
  const wrong = { source, colour: 0xff0000 };
  expect(() => createBodyMesh(wrong)).toThrow(
    'createBodyMesh has no option “colour”: its options are source, defaultColor, material, form, segments',
  );
  const trail = { ...wrong, length: 8 };
  expect(() => createTrailLines(trail)).toThrow('createTrailLines has no option “colour”');
  const line = { thickness: 2 };
  expect(() => createSegmentLines(line as object)).toThrow('its options are color, width');
  expect(() => createOrbitCamera({ element: {}, target: 0 } as never)).toThrow(
    'createOrbitCamera has no option “target”',
  );
  expect(() => listenToBodyDragging({} as never, { source, onDrop() {} } as never)).toThrow('no option “onDrop”');
});

it('says which element and which opacity it needs', () => {
  expect(() => createOrbitCamera(undefined as never)).toThrow('createOrbitCamera({ element: canvas })');
  expect(() => createOrbitCamera({} as never)).toThrow('createOrbitCamera({ element: canvas })');
  const source = worldSource(world);
  for (const opacity of [-0.1, 1.1, Number.NaN]) {
    expect(() => createTrailLines({ source, length: 8, opacity })).toThrow('opacity must be a number from 0 to 1');
  }
  for (const maxSegment of [0, -1, Number.NaN]) {
    expect(() => createTrailLines({ source, length: 8, maxSegment })).toThrow(
      'maxSegment must be a distance above zero',
    );
  }
});

it('needs a number for the place between two steps', () => {
  const source = worldSource(world);
  const [mesh, trails] = [createBodyMesh({ source }), createTrailLines({ source, length: 8 })];
  for (const wrong of [Number.NaN, undefined, '0.5'] as number[]) {
    expect(() => mesh.update(wrong)).toThrow(
      /such as runner\.alpha: update\(1\) draws the last step; got (NaN|undefined|0.5)/,
    );
    expect(() => trails.update(wrong)).toThrow('update needs a number from 0 to 1');
  }
  expect(() => checkAlpha(1.5)).not.toThrow();
});

it.each(['mesh', 'impostor'] as const)('gives a material back when its bodies are destroyed: %s', (form) => {
  const source = worldSource(world);
  const material = new MeshBasicMaterial();
  const before = { ...material.toJSON(), uuid: '', key: material.customProgramCacheKey() };
  for (let i = 0; i < 2; i++) {
    const mesh = createBodyMesh({ source, form, material });
    expect(material.customProgramCacheKey()).not.toBe(before.key);
    expect(() => createBodyMesh({ source, form, material })).toThrow('this material draws the bodies of another mesh');
    mesh.destroy();
    expect({ ...material.toJSON(), uuid: '', key: material.customProgramCacheKey() }).toEqual(before);
  }
});

it('draws with one material', () => {
  const source = worldSource(world);
  const make = (material: unknown, form: 'mesh' | 'impostor') => () =>
    createBodyMesh({ source, form, material: material as MeshBasicMaterial });
  for (const form of ['mesh', 'impostor'] as const) {
    expect(make([new MeshBasicMaterial()], form)).toThrow('material must be one material of three');
    expect(make([new MeshBasicMaterial()], form)).toThrow('got an array: all bodies have the same');
    expect(make('red', form)).toThrow('got red');
  }
});

it('draws with a geometry that has positions', () => {
  const source = worldSource(world);
  for (const geometry of [5, 'box', null, new BufferGeometry()] as BufferGeometry[]) {
    expect(() => createBodyMesh({ source, geometry })).toThrow('geometry must be one of three with positions');
  }
});

it('says that what was destroyed is updated', () => {
  const source = worldSource(world);
  for (const [maker, made] of [
    ['createBodyMesh', createBodyMesh({ source })],
    ['createTrailLines', createTrailLines({ source, length: 8 })],
  ] as const) {
    made.update(1);
    made.destroy();
    expect(() => made.update(1)).toThrow(`what ${maker} made was destroyed: do not update it any more`);
  }
});
