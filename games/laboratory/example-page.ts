/** The page of one example: a game of the shell whose settings are the parameters of the example. */
import { destroyWorld } from '@principia/physics';
import type { Example } from '@principia/scenes/examples';
import { type Controls, type Renderer, type Settings, startGame, type Value } from '@principia/shell';
import { createAboutCard } from './about-card.ts';
import { createChecksCard } from './checks-card.ts';
import { chosenIntegrator, parameterValues, SHOWN_SETTINGS, settingsOf } from './example-settings.ts';
import type { Ghosts } from './ghosts.ts';
import type { LabRun } from './lab-run.ts';
import { makeGhosts } from './make-ghosts.ts';
import { writeAddress } from './page-address.ts';
import { createPlotsCard } from './plots-card.ts';
import { addLaboratoryStyles } from './styles.ts';

/** Lengths of the view's diagonal that a thrown body crosses in a second at most. */
const THROW_SPEED = 2;

/** @param query of the address, with the name of the example */
export async function openExample(example: Example, query: URLSearchParams): Promise<void> {
  addLaboratoryStyles();
  document.title = `${example.title} – the laboratory`;
  const probe = example.start();
  const settings: Settings = settingsOf(example, probe);
  destroyWorld(probe.world);
  let ghosts: Ghosts | undefined;
  const rest = new URLSearchParams(query);
  rest.delete('example');
  const remember = (values: Readonly<Record<string, Value>>, seed: number) =>
    writeAddress(example.id, settings, values, seed);
  await startGame<Settings, LabRun>(
    {
      title: example.title,
      settings,
      create({ values, seed }) {
        const integrator = chosenIntegrator(values);
        const options = { values: parameterValues(example, values), seed };
        const run = example.start(integrator === undefined ? options : { ...options, integrator });
        ghosts?.destroy();
        ghosts = makeGhosts(String(values.ghosts), example, options, run.world.integrator.name);
        remember(values, seed);
        return { ...run, ghosts };
      },
      apply: (_, name) => SHOWN_SETTINGS.includes(name),
      dragSpeed: ({ picture: { view } }) => THROW_SPEED * Math.hypot(view.maxX - view.minX, view.maxY - view.minY),
      hasEnded: ({ world, dt }) => example.ends && world.time > example.duration - dt / 2,
      cards: (parent) => [
        createAboutCard(parent, example),
        createChecksCard(parent, example),
        // Before the plots, which record them.
        { record: (run) => run.ghosts.follow(run.world.tick), show() {} },
        ...createPlotsCard(parent, example),
      ],
      report: (run) => ({ checks: run.checkStates() }),
      renderers: rendererOf(example),
      ...controlsOf(example),
      help: [
        ...Object.values(example.actions).map(({ key, about }) => [keyName(key), about] as const),
        ['Drag a body', 'move it, release to throw it'],
      ],
    },
    rest.toString(),
  );
  addListLink();
}

function rendererOf({ dimensions }: Example): Readonly<Record<string, Renderer<Settings, LabRun>>> {
  return dimensions === 3
    ? {
        three: { label: '3D', dimensions, open: async (context) => (await import('./view-3d.ts')).openView3D(context) },
      }
    : { pixi: { label: '2D', dimensions, open: async (context) => (await import('./view-2d.ts')).openView(context) } };
}

/** The actions of an example as keys and buttons of the shell. */
function controlsOf({ actions }: Example): { readonly controls?: Controls<LabRun> } {
  const entries = Object.entries(actions);
  if (entries.length === 0) return {};
  const buttons = Object.fromEntries(entries.map(([name, { label, key }]) => [name, { label, keys: [key] }]));
  return {
    controls: { buttons, press: (run, name) => run.act(name, true), release: (run, name) => run.act(name, false) },
  };
}

function keyName(key: string): string {
  const arrows: Record<string, string> = { arrowup: '↑', arrowdown: '↓', arrowleft: '←', arrowright: '→' };
  return arrows[key] ?? key.toUpperCase();
}

/** The way back to the list, before the title. */
function addListLink(): void {
  const link = document.createElement('a');
  link.href = location.pathname;
  link.className = 'lab-back';
  link.textContent = 'All examples';
  document.querySelector('.game-bar')?.prepend(link);
}
