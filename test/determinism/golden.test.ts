/**
 * The hashes of chaotic scenes, as they were when this file was last touched.
 *
 * They change whenever the arithmetic of any body changes by one bit: another order of additions, another formula,
 * another draw of the random numbers. That breaks every recording and replay made before. So update them only for a
 * change that is meant to change trajectories, in the same commit, and say so in CHANGELOG.md; for any other change a
 * new value here is a fault that was found. `test/browser/determinism.test.ts` holds browsers to the same scenes.
 */
import { expect, it } from 'vitest';
import { chaosHashes } from '../support/chaos.ts';
import { hingeHashes } from '../support/falling-hinges.ts';

it('1 500 steps of chaotic scenes end where they always ended', { timeout: 30_000 }, () => {
  expect(chaosHashes()).toEqual({
    '2D f32': 'a5d19f9f2a538acd',
    '2D f64': '53ec76dd34e0b2ee',
    '3D f32': '392a4bd99888cfca',
    '3D f64': '74ea4dd9ad1713f5',
  });
});

it('falling hinges come to rest as they always did, after as many steps', { timeout: 30_000 }, () => {
  expect(hingeHashes()).toEqual({
    f32: '352 bb3e4f1057cdb9ef',
    f64: '304 cc5b7d9c1f4a4086',
  });
});
