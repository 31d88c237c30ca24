import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { MIN_THREE, requireThree } from './three-version.ts';

it.each(['184', '187', '190dev', '200'])('takes revision %s of three', (revision) => {
  expect(() => requireThree(revision)).not.toThrow();
});

it.each(['99', '170', '183', '183dev'])('refuses revision %s of three and says what to do', (revision) => {
  expect(() => requireThree(revision)).toThrow(
    `needs three 0.184.0 or newer, got 0.${revision}, which cannot draw bodies: run npm install three@latest`,
  );
});

it('takes the installed revision', () => expect(() => requireThree()).not.toThrow());

it('asks for the revision that the manifest asks for', () => {
  const { peerDependencies } = JSON.parse(readFileSync('packages/render-three/package.json', 'utf8'));
  expect(peerDependencies.three).toBe(`>=0.${MIN_THREE}.0`);
});
