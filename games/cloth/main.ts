/** A cloth that tears: filled and lit by three.js, thread by thread by pixi.js. */
import { startGame } from '@principia/shell';
import { ClothPrint } from './cloth-print.ts';
import { settings } from './settings.ts';
import { applyValue, brokenThreads, createSim, threadCount } from './sim.ts';

const print = new ClothPrint();

await startGame({
  title: 'A cloth to tear',
  home: '../index.html',
  settings,
  create: createSim,
  apply: (sim, name, values) => name === 'sound' || applyValue(sim, name, values),
  report: (sim) => ({ broken: brokenThreads(sim), threads: threadCount(sim) }),
  renderers: {
    three: {
      label: '3D',
      dimensions: 3,
      open: async (context) => (await import('./view-3d.ts')).openView3D(context, print),
    },
    pixi: { label: '2D', dimensions: 2, open: async (context) => (await import('./view.ts')).openView(context, print) },
  },
  help: [
    ['Drag the cloth', 'pull and tear it; every finger can grab it'],
    ['Swipe from beside it', 'cut it'],
    ['Print your picture', 'choose a file or drop one on the page; it stays on your device'],
    ['Watch the tear slowly', 'the button appears after a tear'],
    ['Right button, two fingers', 'turn the view in 3D, move it in 2D'],
  ],
});
