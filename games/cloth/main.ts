/** A cloth that tears: filled and lit by three.js, thread by thread by pixi.js. */
import { startGame } from '@principia/shell';
import { settings } from './settings.ts';
import { applyValue, brokenThreads, createSim, threadCount } from './sim.ts';

await startGame({
  title: 'A cloth to tear',
  home: '../index.html',
  settings,
  create: createSim,
  apply: applyValue,
  report: (sim) => ({ broken: brokenThreads(sim), threads: threadCount(sim) }),
  renderers: {
    three: { label: '3D', dimensions: 3, open: async (context) => (await import('./view-3d.ts')).openView3D(context) },
    pixi: { label: '2D', dimensions: 2, open: async (context) => (await import('./view.ts')).openView(context) },
  },
  help: [
    ['Drag the cloth', 'pull and tear it; every finger can grab it'],
    ['Swipe from beside it', 'cut it'],
    ['Right button, two fingers', 'turn the view in 3D, move it in 2D'],
  ],
});
