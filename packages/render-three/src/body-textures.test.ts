import { SHAPES } from '@principia/render-core';
import { expect, test } from 'vitest';
import { createTestBodySource, type TestBodySource } from '../../../test/support/body-source.ts';
import { colorBytes } from './body-color.ts';
import { BodyTextures } from './body-textures.ts';
import type { ColumnTexture } from './column-texture.ts';

function textures(source: TestBodySource) {
  const held = new BodyTextures(source, colorBytes(0x102030), false);
  const of = (name: string) => held.uniforms[name].value as ColumnTexture;
  return { held, of, versions: (...names: string[]) => names.map((name) => of(name).uploads) };
}

test('colours of three become bytes in memory order', () => {
  expect(colorBytes(0x102030)).toBe(0xff302010);
  expect(colorBytes('red')).toBe(0xff0000ff);
});

test('the columns of an f32 world are the textures themselves', () => {
  const source = createTestBodySource(2048, 3);
  source.show([5, 1500]);
  const { held, of } = textures(source);
  held.refresh(1);
  expect(of('positionX').data).toBe(source.position.x);
  expect(of('previousZ').data).toBe(source.previousPosition.z);
  expect(of('positionX').rows).toBe(2);
});

test('only what the source says has changed is sent', () => {
  const source = createTestBodySource(1024, 3);
  source.show([1, 2]);
  const { held, versions } = textures(source);
  held.refresh(1);
  const names = ['positionX', 'bodyStyle', 'bodyIds', 'turnX'];
  const before = versions(...names);
  held.refresh(1);
  expect(versions(...names)).toEqual(before);
  source.versions.pose++;
  held.refresh(1);
  expect(versions(...names)).toEqual([before[0] + 1, before[1], before[2], before[3]]);
  source.versions.style++;
  held.refresh(1);
  expect(versions(...names)).toEqual([before[0] + 1, before[1] + 1, before[2], before[3]]);
});

test('a step sends the new poses alone, and what was new becomes what was before', () => {
  const source = createTestBodySource(1024, 3);
  source.versions.steps = 0;
  source.show([1, 2]);
  const { held, of, versions } = textures(source);
  held.refresh(0.25);
  expect(held.uniforms.poseAlpha.value).toBe(0.25);
  const before = versions('positionX', 'previousX');
  source.versions.pose++;
  source.versions.steps++;
  held.refresh(0.25);
  expect(versions('positionX', 'previousX')).toEqual([before[0], before[1] + 1]);
  // The halves have changed roles, also for a renderer that comes anew.
  expect([of('previousX').data, of('positionX').data]).toEqual([source.position.x, source.previousPosition.x]);
  expect(held.uniforms.poseAlpha.value).toBe(0.75);
  // Somebody moved a body by hand: there may be more than one reason why the poses are others.
  source.versions.pose += 2;
  source.versions.steps++;
  held.refresh(1);
  expect(versions('positionX', 'previousX')).toEqual([before[0] + 1, before[1] + 2]);
});

test('rotations are sent once a body shows them', () => {
  const source = createTestBodySource(1024, 3);
  source.radius[1] = 1;
  source.show([1]);
  const { held, of } = textures(source);
  held.refresh(1);
  expect(of('turnX').data).not.toBe(source.orientation.x);
  source.shape[1] = SHAPES.box;
  source.versions.style++;
  held.refresh(1);
  expect(of('turnX').data).toBe(source.orientation.x);
});

test('an id beyond those sent before is sent even if no version of its columns moved', () => {
  const source = createTestBodySource(4096, 2, 'f64');
  source.position.x[3000] = 8;
  source.show([1]);
  const { held, of } = textures(source);
  held.refresh(1);
  source.ids[1] = 3000;
  source.count = 2;
  source.lastId = 3000;
  source.versions.membership++;
  held.refresh(1);
  const { data, rows } = of('positionX');
  expect([(data as Float32Array)[3000], rows]).toEqual([8, 3]);
});

test('the style holds drawn radius, colour and shape, with the defaults filled in', () => {
  const source = createTestBodySource(1024, 2, 'f64');
  source.radius.set([1, 2], 1);
  source.size[2] = 0.25;
  source.color[2] = 0xff00ff00;
  source.shape[2] = SHAPES.glow;
  source.show([1, 2]);
  const { held } = textures(source);
  held.refresh(1);
  const radius = new Float32Array(held.style.data.buffer);
  expect([radius[4], radius[8]]).toEqual([1, 0.25]);
  expect(Array.from(held.style.data.slice(5, 7))).toEqual([0xff302010, SHAPES.disc]);
  expect(Array.from(held.style.data.slice(9, 11))).toEqual([0xff00ff00, SHAPES.glow]);
  expect([held.style.hasSolids, held.style.hasFlats, held.style.hasTurning]).toEqual([true, true, false]);
});

test('an origin is subtracted before f64 is rounded, and ignored for f32', () => {
  for (const precision of ['f64', 'f32'] as const) {
    const source = createTestBodySource(1024, 3, precision);
    source.position.x[1] = 1e9 + 0.125;
    source.show([1]);
    const { held, of } = textures(source);
    held.centres.setOrigin(1e9, 0, 0);
    held.refresh(1);
    const sent = (of('positionX').data as Float32Array)[1];
    expect(sent + held.centres.origin.x).toBe(precision === 'f64' ? 1e9 + 0.125 : 1e9);
  }
});

test('a column of another length is refused', () => {
  const source = createTestBodySource(1024, 2);
  source.angle = new Float32Array(1000);
  expect(() => textures(source)).toThrow(/1024 rows, got one of 1000/);
});

test('a world with few enough textures for every WebGL 2: sixteen in a vertex shader', () => {
  const { held } = textures(createTestBodySource(1024, 3));
  // The outlines are read in the fragment shader, which has sixteen of its own.
  const { bodyOutlines: _, ...inVertexShader } = held.uniforms;
  const samplers = Object.values(inVertexShader).filter(({ value }) => typeof value === 'object');
  expect(samplers.length).toBeLessThanOrEqual(16);
});
