import { Box3, BoxGeometry, MeshLambertMaterial, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { createTestBodySource } from '../../../test/support/body-source.ts';
import { createBodyMesh } from './body-mesh.ts';
import { createBoxFrame } from './box-frame.ts';
import { createSegmentLines } from './segment-lines.ts';
import { createTrailLines } from './trail-lines.ts';

test('segments are counted, grow past their first memory and are cleared', () => {
  const lines = createSegmentLines();
  for (let i = 0; i < 3000; i++) lines.add(i, 0, 0, i, 1, 0);
  expect(lines.count).toBe(3000);
  lines.clear();
  expect(lines.count).toBe(0);
});

test('bad options say what to do', () => {
  const source = createTestBodySource(1024, 3);
  expect(() => createSegmentLines({ width: 0 })).toThrow(/width of lines must be a positive number/);
  expect(() => createBoxFrame(new Box3())).toThrow(/min below max/);
  expect(() => createTrailLines({ source, length: 5000 })).toThrow(/at most 2048/);
  expect(() => createTrailLines({ source, length: 1 })).toThrow(/at least 2/);
  expect(() => createBodyMesh({ source, segments: 2 })).toThrow(/at least 3/);
  expect(() => createBodyMesh({ source, form: 'impostor', geometry: new BoxGeometry() })).toThrow(/have no geometry/);
  const material = new MeshLambertMaterial();
  createBodyMesh({ source, material });
  expect(() => createBodyMesh({ source, material })).toThrow(/give each its own/);
  createBodyMesh({ source, material: material.clone() });
});

test('a trail draws a segment less than it has points, for each body', () => {
  const source = createTestBodySource(1024, 2);
  source.show([1, 2, 3]);
  const trails = createTrailLines({ source, length: 10 });
  trails.update(1);
  trails.update(0.5);
  expect(trails.history.recordings).toBe(1);
  const drawn = () => trails.object.children.map((mesh) => Object(mesh).geometry.drawRange.count as number);
  expect(drawn()).toEqual([3 * 9 * 6]);
  expect(trails.object.children[0].position).toEqual(new Vector3());
});
