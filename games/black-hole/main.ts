/** Black hole: a ship among black holes, drawn by pixi.js. */
import { FOUR_WAYS, startGame } from '@principia/shell';
import { outcomeOf, reportState } from './report.ts';
import { settings } from './settings.ts';
import { applyValue, createGame, type Input } from './sim.ts';

await startGame({
  title: 'Black hole',
  home: '../index.html',
  settings,
  create: createGame,
  apply: applyValue,
  replay: (sim) => sim.again(),
  controls: {
    buttons: { ...FOUR_WAYS, action: { label: '↻', keys: ['n'], pad: [2], touch: false } },
    press: (sim, name) => sim.press(name === 'action' ? 'redraw' : (name as Input)),
    release: (sim, name) => name !== 'action' && sim.press('release'),
    steer: (sim, x, y) => sim.steer(x, y),
  },
  outcome: outcomeOf,
  report: reportState,
  renderers: {
    pixi: { label: '2D', dimensions: 2, open: async (context) => (await import('./view.ts')).openView(context) },
  },
  help: [
    ['Arrow keys', 'thrust up, left, down or right. The last key counts. Releasing a key stops the engine', 'keyboard'],
    ['Mouse, touch', 'thrust towards the pointer, the harder the farther it is from the ship'],
    ['Stick', 'thrust as far as you push it, on the screen or on a gamepad; its d-pad gives full thrust'],
    ['Goal', 'cross the line at the top. A level has one more hole than the last and is worth as many points'],
    ['Danger', 'falling into a hole costs one of three lives'],
    ['N, New layout', 'other holes, as often as you like; the level then gives no bonus'],
    ['Daily challenge', 'the same holes for everybody on the same date, with a result to share'],
    ['Ghost', 'your fastest flight past the same holes flies beside you; it is kept in this browser'],
    ['Bonus', 'for unused fuel, and for every slingshot around a hole'],
  ],
});
