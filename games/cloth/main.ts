/** A cloth that tears: filled and lit by three.js, thread by thread by pixi.js. */
import { helpLines, startGame } from '@principia/shell';
import { ClothPrint } from './cloth-print.ts';
import { settings } from './settings.ts';
import { applyValue, brokenThreads, createSim, threadCount } from './sim.ts';
import { WORDS } from './words.ts';

document.title = WORDS.title;
const print = new ClothPrint();

startGame({
  title: WORDS.title,
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
  help: helpLines(WORDS.help),
});
