import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { MIN_PIXI, requirePixi } from './pixi-version.ts';

it.each(['8.22.0', '8.22.0-dev.1a2b3c4', '8.22.7', '8.30.1', '9.0.0'])('takes pixi.js %s', (version) => {
  expect(() => requirePixi(version)).not.toThrow();
});

it.each(['7.4.2', '8.9.0', '8.13.0', '8.21.0'])('refuses pixi.js %s and says what to do', (version) => {
  expect(() => requirePixi(version)).toThrow(
    `needs pixi.js 8.22.0 or newer, got ${version}, which cannot draw bodies: run npm install pixi.js@^8.22.0`,
  );
});

it('asks for the version that the manifest asks for', () => {
  const { peerDependencies } = JSON.parse(readFileSync('packages/render-pixi/package.json', 'utf8'));
  expect(peerDependencies['pixi.js']).toBe(`^${MIN_PIXI}`);
});
