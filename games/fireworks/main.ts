/** Fireworks: one scene, drawn in 2D by pixi.js and in 3D by three.js. */
import { FOUR_WAYS, startGame } from '@principia/shell';
import { Desk, KEYS } from './desk.ts';
import { dress, tell } from './report.ts';
import { settings } from './settings.ts';
import { applyValue, createGame, type Way } from './sim.ts';

const desk = new Desk(location.hash);

await startGame({
  title: 'Fireworks',
  settings,
  create: (options) => createGame({ ...options, opening: desk.opening, isDemo: desk.isDemo }),
  apply: applyValue,
  dress: (sim, { safeColors }) => dress(sim, safeColors),
  tell: (sim) => tell(sim, desk),
  controls: {
    buttons: { ...FOUR_WAYS, action: { label: '✦', keys: ['enter'], pad: [0] } },
    press: (sim, name) =>
      name === 'action' ? desk.hold(sim, KEYS) : sim.press({ do: 'steer', way: name as Way, on: true }),
    release: (sim, name) =>
      name === 'action' ? desk.fire(sim, KEYS, sim.sight) : sim.press({ do: 'steer', way: name as Way, on: false }),
  },
  renderers: {
    pixi: { label: '2D', dimensions: 2, open: async (stage) => (await import('./view-2d.ts')).openView2D(stage, desk) },
    three: {
      label: '3D',
      dimensions: 3,
      open: async (stage) => (await import('./view-3d.ts')).openView3D(stage, desk),
    },
  },
  help: [
    ['Press, touch', 'sends a shell up to there; hold longer for a larger one; every finger may hold one'],
    ['Arrow keys, Enter', 'aim, and fire; the stick and the first button of a gamepad do the same'],
    ['K, C', 'next kind of shell, next colour'],
    ['A swarm', 'is lit where you let go: two stars for every whole second that you hold, each bursts into as many'],
    ['T', 'the timeline: every click adds a shell to your show; drag marks, Backspace takes back, Delete takes out'],
    ['L', 'play your show, or end it'],
    ['Drag, in 3D', 'turn the view; wheel and pinch come closer'],
  ],
});
