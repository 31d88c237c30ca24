/** Bouncing balls: one scene, drawn in 2D by pixi.js and in 3D by three.js. */
import { helpLines, startGame } from '@principia/shell';
import { applyColors } from './colors.ts';
import { settings } from './settings.ts';
import { applyValue, clampToRoom, countContacts, createBalls } from './sim.ts';
import { WORDS } from './words.ts';

document.title = WORDS.title;

/** Settings that the world does not know. */
const PICTURE = ['trails', 'sound', 'magnet'];

startGame({
  title: WORDS.title,
  home: '../index.html',
  variesSeed: true,
  settings,
  create: createBalls,
  applyColors: (sim, { seed, safeColors }) => applyColors(sim, seed, safeColors),
  apply: (sim, name, values) => PICTURE.includes(name) || applyValue(sim, name, values),
  dragLimit: clampToRoom,
  contacts: countContacts,
  hasEnded: ({ time }) => time.isFrozen,
  renderers: {
    three: { label: '3D', dimensions: 3, open: async (context) => (await import('./view-3d.ts')).openView3D(context) },
    pixi: { label: '2D', dimensions: 2, open: async (context) => (await import('./view-2d.ts')).openView2D(context) },
  },
  controls: {
    buttons: { action: { label: WORDS.pour, keys: ['v'], pad: [0], title: WORDS.pour } },
    forMouse: true,
    press: ({ log }) => log.add({ kind: 'pour', isOpen: true }),
    release: ({ log }) => log.add({ kind: 'pour', isOpen: false }),
    letGo: (sim) => sim.letGo(),
  },
  help: helpLines(WORDS.help),
});
