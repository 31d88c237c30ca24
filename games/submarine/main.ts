/** A submarine that brings up crates from a dark sea, drawn by pixi.js. */
import { FOUR_WAYS, startGame } from '@principia/shell';
import { outcomeOf, reportState } from './report.ts';
import { settings } from './settings.ts';
import { createGame } from './sim.ts';
import { WORDS } from './words.ts';

await startGame({
  title: WORDS.title,
  home: '../index.html',
  settings,
  create: createGame,
  apply: (_, name) => name !== 'level',
  outcome: outcomeOf,
  report: reportState,
  controls: {
    buttons: { ...FOUR_WAYS, action: { label: '●', keys: ['x', 'enter'], pad: [0] } },
    press: (sim, name) => sim.press(name),
    release: (sim, name) => sim.release(name),
  },
  renderers: {
    pixi: { label: '2D', dimensions: 2, open: async (context) => (await import('./view.ts')).openView(context) },
  },
  help: [
    ['▼, ▲', 'flood the tank, or blow it out with compressed air, which takes more of it the deeper you are'],
    ['◀, ▶', 'full astern, full ahead'],
    ['X, Enter, ●', 'sonar: the echo shows bed and crates for a while'],
    ['Goal', 'touch every crate, and come up beside the ship before the air to breathe is gone'],
    ['Danger', 'the depth crushes the hull, and rocks dent it'],
    ['Depth', 'presses the hull together: it carries less, so that the tank hovers with less water'],
    ['At the surface', 'the compressor fills the bottles'],
  ],
});
