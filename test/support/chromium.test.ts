import { expect, test } from 'vitest';
import { chromiumFlags, findChromium } from './chromium.ts';

test('the path in CHROMIUM comes first', () => {
  const path = process.execPath; // any program will do
  expect(findChromium({ install: false, env: { CHROMIUM: path, PATH: '' } })).toBe(path);
  expect(findChromium({ install: false, env: { PRINCIPIA_CHROMIUM: path, PATH: '' } })).toBe(path);
});

test('a wrong path in CHROMIUM is named in the error', () => {
  expect(() => findChromium({ install: false, env: { CHROMIUM: '/nowhere/chromium' } })).toThrow(/\/nowhere\/chromium/);
});

test('the flags draw WebGL and WebGPU in software', () => {
  expect(chromiumFlags).toContain('--use-angle=swiftshader');
  expect(chromiumFlags).toContain('--use-webgpu-adapter=swiftshader');
});
