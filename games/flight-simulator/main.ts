/** A flight simulator, drawn by three.js. */
import { FOUR_WAYS, startGame } from '@principia/shell';
import { settings } from './settings.ts';
import { applyValue, createFlight, type Flight } from './sim.ts';

const TITLES = { landed: 'Landed!', crashed: 'Crashed' } as const;

function outcome({ log }: Flight) {
  if (log.phase === 'flying') return undefined;
  return { title: TITLES[log.phase], score: log.score, lines: [log.reason, `${log.score} points`] };
}

await startGame({
  title: 'Flight simulator',
  home: '../index.html',
  settings,
  create: createFlight,
  apply: applyValue,
  outcome,
  hasEnded: ({ log }) => log.phase !== 'flying',
  report: ({ log, attitude, height, climb, pilot }) => ({
    phase: log.phase,
    reason: log.reason,
    score: log.score,
    ring: log.ring,
    onGround: log.onGround,
    airspeed: attitude.airspeed,
    height,
    climb,
    throttle: pilot.throttle,
  }),
  renderers: {
    three: { label: '3D', dimensions: 3, open: async (context) => (await import('./view.ts')).openView(context) },
  },
  controls: {
    buttons: {
      ...FOUR_WAYS,
      more: { label: '⇧', keys: ['t', 'pageup'], pad: [7] },
      less: { label: '⇩', keys: ['g', 'pagedown'], pad: [6] },
      brake: { label: '■', keys: ['n'], pad: [0] },
      rudderLeft: { label: '↶', keys: ['a'], pad: [4], touch: false },
      rudderRight: { label: '↷', keys: ['d'], pad: [5], touch: false },
    },
    press: (flight, name) => flight.press(name, true),
    release: (flight, name) => flight.press(name, false),
    steer: (flight, x, y) => flight.stick(x, y),
  },
  help: [
    ['Arrow keys, stick', '← and → bank; ↓ pulls the stick and raises the nose, ↑ lowers it'],
    ['T and G, ⇧ and ⇩', 'more and less throttle'],
    ['N, ■', 'brake on the ground'],
    ['A and D', 'rudder, which also steers on the ground', 'keyboard'],
    ['C', 'cockpit or outside', 'keyboard'],
    ['K', 'assistant on or off: without it you move the control surfaces yourself', 'keyboard'],
    ['Drag, wheel', 'look around, come nearer'],
  ],
});
