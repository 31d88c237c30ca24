/** Fireworks: one scene, drawn in 2D by pixi.js and in 3D by three.js. */
import { FOUR_WAYS, followPastedLinks, helpLines, startGame } from '@principia/shell';
import { KEYBOARD_POINTER, PlayerControls } from './controls.ts';
import { applyColors, reportState } from './report.ts';
import { settings } from './settings.ts';
import { applyValue, createGame, type Direction } from './sim.ts';
import { WORDS } from './words.ts';

const controls = new PlayerControls(location.hash);
followPastedLinks();

document.title = WORDS.title;

startGame({
  title: WORDS.title,
  home: '../index.html',
  settings,
  create: (options) => createGame({ ...options, opening: controls.opening, isDemo: controls.isDemo }),
  apply: applyValue,
  applyColors: (sim, { safeColors }) => applyColors(sim, safeColors),
  // The world holds the sparks of all pools, of which most wait.
  bodies: ({ scene }) => scene.alive + scene.flying,
  report: (sim) => reportState(sim, controls),
  controls: {
    buttons: { ...FOUR_WAYS, action: { label: '✦', keys: ['enter'], pad: [0] } },
    press: (sim, name) =>
      name === 'action'
        ? controls.startHold(sim, KEYBOARD_POINTER)
        : sim.press({ do: 'steer', way: name as Direction, on: true }),
    release: (sim, name) =>
      name === 'action'
        ? controls.fire(sim, KEYBOARD_POINTER, sim.crosshair)
        : sim.press({ do: 'steer', way: name as Direction, on: false }),
    letGo: (sim) => sim.letGo(),
  },
  renderers: {
    pixi: {
      label: '2D',
      dimensions: 2,
      open: async (context) => (await import('./view-2d.ts')).openView2D(context, controls),
    },
    three: {
      label: '3D',
      dimensions: 3,
      open: async (context) => (await import('./view-3d.ts')).openView3D(context, controls),
    },
  },
  help: helpLines(WORDS.help, ['aim', 'next', 'play']),
});
