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
import { sceneHashes } from '../support/scene-hashes.ts';

it('1 500 steps of chaotic scenes end where they always ended', { timeout: 30_000 }, () => {
  expect(chaosHashes()).toEqual({
    '2D f32': 'a5d19f9f2a538acd',
    '2D f64': '53ec76dd34e0b2ee',
    '3D f32': '392a4bd99888cfca',
    '3D f64': '74ea4dd9ad1713f5',
  });
});

it('240 steps of every scene end where they always ended', () => {
  expect(sceneHashes()).toMatchInlineSnapshot(`
    {
      "attractors": "2777c379c355bcec",
      "black-hole": "e70744aaf492d90f",
      "bouncing-balls": "c10de49e7693af71",
      "chains": "19a31649e3cc4b34",
      "circles": "6f26557c9b4c24bb",
      "cloth": "5dffac56cde82676",
      "crowd": "ec766ae71190bc3e",
      "discs": "a9585b3983d87ed6",
      "elastic-discs": "a0482616ed877149",
      "emitters": "ffc1284ca166769f",
      "fireworks": "221c65b03e030b93",
      "galaxy": "702381d7d241eebf",
      "gas": "8a5c399a04e77aea",
      "joint-grid": "1a459e9a071e74a3",
      "many-pyramids": "3047226f0f8a91c4",
      "molecules": "424002f2118ba0ce",
      "nbody-direct": "39ef8796d15dfc35",
      "nbody-tree": "a5795ad16a5a978e",
      "particles": "dcd8a69771fd17d6",
      "plasma": "8088946b47a727e0",
      "pyramid": "5122242b6ac39fc8",
      "rope": "dd59fcd83d628992",
      "smash": "34cb322af8cc9fa4",
      "solar-system": "629d39c213fda8a5",
      "spinner": "7d4a059b99047941",
      "springs": "2f827429c1ac197b",
      "tumbler": "6864d54f263f6609",
      "washer": "e3f9bd2d9d30568b",
    }
  `);
});

it('falling hinges come to rest as they always did, after as many steps', { timeout: 30_000 }, () => {
  expect(hingeHashes()).toEqual({
    f32: '305 361020fc8eaac118',
    f64: '308 e5b06a6ad12d8c00',
  });
});
