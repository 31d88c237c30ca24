/** A sandbox of rigid bodies, drawn by pixi.js. */
import { bodies } from '@principia/physics';
import { dragByJoints, followPastedLinks, helpLines, startGame } from '@principia/shell';
import { applyColors } from './colors.ts';
import { readScene } from './scene-link.ts';
import { settings } from './settings.ts';
import { applyValue, blast, createSim, dropBlock, report, throwBall } from './sim.ts';
import { WORDS } from './words.ts';

document.title = WORDS.title;
followPastedLinks();

const ACTIONS = { action: throwBall, up: dropBlock, down: blast } as const;

const [, text] = /^#scene=(.*)$/s.exec(location.hash) ?? [];
let problem = '';
/** The scene of the link; a player who chooses a build leaves it. */
let scene = await readScene(text ?? '').catch((error: Error) => {
  if (text !== undefined) problem = error.message;
  return undefined;
});

startGame({
  title: WORDS.title,
  home: '../index.html',
  settings,
  create: (options) => createSim({ ...options, scene }),
  apply(sim, name, values) {
    if (name === 'build' || name === 'count') scene = undefined;
    return applyValue(sim, name, values);
  },
  // A scene from a link has the colours that it was saved with.
  applyColors: (sim, { seed, safeColors }) => scene === undefined && applyColors(sim, seed, safeColors),
  report,
  // The ground is none of those that the setting counts.
  bodies: ({ world }) => bodies(world).count - 1,
  drag: dragByJoints,
  renderers: {
    pixi: {
      label: '2D',
      dimensions: 2,
      async open(context) {
        const { openView } = await import('./view.ts');
        if (problem !== '') context.showMessage(problem);
        problem = '';
        return openView(context);
      },
    },
  },
  controls: {
    buttons: {
      action: { label: '●', keys: ['c'], title: WORDS.help.ball[1] },
      up: { label: '■', keys: ['n'], title: WORDS.help.block[1] },
      down: { label: '✶', keys: ['t'], title: WORDS.help.blast[1] },
    },
    forMouse: true,
    press: (sim, name) => ACTIONS[name as keyof typeof ACTIONS](sim),
    release() {},
  },
  help: helpLines(WORDS.help),
});
