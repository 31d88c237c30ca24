/** Bouncing balls: one scene, drawn in 2D by pixi.js and in 3D by three.js. */
import { startGame } from '@principia/shell';
import { dress } from './looks.ts';
import { settings } from './settings.ts';
import { applyValue, countContacts, createBalls, keepInRoom } from './sim.ts';

await startGame({
  title: 'Bouncing balls',
  settings,
  create: createBalls,
  dress: (sim, { seed, safeColors }) => dress(sim, seed, safeColors),
  apply: (sim, name, values) => name === 'trails' || applyValue(sim, name, values),
  holdLimit: keepInRoom,
  contacts: countContacts,
  renderers: {
    pixi: { label: '2D', dimensions: 2, open: async (stage) => (await import('./view-2d.ts')).openView2D(stage) },
    three: { label: '3D', dimensions: 3, open: async (stage) => (await import('./view-3d.ts')).openView3D(stage) },
  },
  help: [
    ['Drag a ball', 'hold it, let go to throw it; every finger may hold one'],
    ['Drag beside', 'move the view (in 3D: turn it)'],
    ['Wheel, pinch', 'closer or farther'],
  ],
});
