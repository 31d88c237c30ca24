/** The page of one example: a game of the shell whose settings are the parameters of the example. */
import { destroyWorld } from '@principia/physics';
import type { Example, ExampleOptions, ExampleRun } from '@principia/scenes/examples';
import type { ExampleEntry } from '@principia/scenes/examples/list';
import {
  type Controls,
  element,
  followPastedLinks,
  type Renderer,
  type Settings,
  type SimulationOptions,
  startGame,
  type Value,
  withLanguage,
} from '@principia/shell';
import type { CodePanel } from './code-panel.ts';
import { chosenIntegrator, parameterValues, SHOWN_SETTINGS, settingsOf } from './example-settings.ts';
import { unitsOf } from './example-units.ts';
import type { Ghosts } from './ghosts.ts';
import { keyName } from './key-name.ts';
import type { LabRun } from './lab-run.ts';
import { makeGhosts } from './make-ghosts.ts';
import { carryCode, goTo, momentAddress, momentOf, takeMoment } from './moment.ts';
import { actOn, presenting } from './on-display.ts';
import { codeHash, type LinkedCode, linkedCode, ownCode } from './own-code.ts';
import { writeAddress } from './page-address.ts';
import { takeShownPlots } from './shown-plots.ts';
import { addLaboratoryStyles } from './styles.ts';
import { WORDS } from './words.ts';

/** Lengths of the view's diagonal that a thrown body crosses in a second at most. */
const THROW_SPEED = 2;

/** Simulated seconds that can be rewound: at least, where a run does not end, and at most. */
const REWIND = [20, 120] as const;

const rewindSeconds = ({ duration, ends }: Example) =>
  Math.min(ends ? duration : Math.max(duration, REWIND[0]), REWIND[1]);

/** @param query of the address, with the name of the example */
export async function openExample(entry: ExampleEntry, query: URLSearchParams): Promise<void> {
  addLaboratoryStyles();
  followPastedLinks();
  const carried = await linkedCode(location.hash);
  const { example, problem, own } = await chosenVersion(entry);
  // An empty version says nothing, and the one that runs nothing new.
  const isNews = carried !== undefined && carried !== '' && carried !== own;
  const linked = isNews ? { source: carried, moment: momentOf(query) } : undefined;
  if (own !== undefined) carryCode(await codeHash(own));
  document.title = WORDS.pageTitle(example.title);
  const probe = example.start();
  const settings: Settings = settingsOf(example, probe);
  const rest = new URLSearchParams(query);
  rest.delete('example');
  const moment = takeMoment(rest, example.dimensions);
  const problems = [...moment.problems, ...takeShownPlots(rest, probe.plots.length + probe.histograms.length)];
  if (linked !== undefined || problem !== '') rest.set('code', 'on');
  const code = codeSwitch(example.id, linked);
  await startGame<Settings, LabRun>(
    {
      title: example.title,
      hasSheet: true,
      hasTimeline: true,
      units: unitsOf(probe.plots),
      // A whole run, so that each moment of it can be seen again.
      rewindSeconds: () => rewindSeconds(example),
      settings,
      ...simulationOf(example, probe, settings, code.show),
      cards: async (parent) => (await import('./side-cards.ts')).createSideCards(parent, example),
      link: momentAddress,
      report: (run) => ({ checks: run.checkStates() }),
      renderers: rendererOf(example, code.closeBy),
      ...controlsOf(example),
      help: [
        ...Object.values(example.actions).map(({ key, about, label }) => [keyName(key), about, label] as const),
        ...(example.pointer === undefined ? [] : [[WORDS.press, example.pointer.about] as const]),
        [WORDS.drag[0], WORDS.drag[1]],
      ],
    },
    {
      query: rest.toString(),
      problems: [
        ...problems,
        ...(carried === '' ? [WORDS.code.unreadable] : []),
        ...(problem === '' ? [] : [WORDS.code.fails(problem)]),
      ],
    },
  ).ready;
  addListLink();
  document.querySelector('.game-title')?.setAttribute('lang', 'en');
  await goTo(moment);
}

/** The example as the reader changed it, or as it is. `own` is the source of the former. */
async function chosenVersion(
  entry: ExampleEntry,
): Promise<{ example: Example; problem: string; own?: string | undefined }> {
  const source = ownCode(entry.id);
  if (source !== undefined) {
    try {
      const { exampleFrom } = await import('./run-code.ts');
      return { example: await exampleFrom(source), problem: '', own: source };
    } catch (error) {
      return { example: await entry.load(), problem: (error as Error).message };
    }
  }
  return { example: await entry.load(), problem: '' };
}

/** The panel with the code, which is loaded when it is first shown. */
interface CodeSwitch {
  show(isShown: boolean): void;
  /** @param turnOff turns the setting off that shows it: on a phone the panel covers those */
  closeBy(turnOff: () => void): void;
}

function codeSwitch(id: string, linked: LinkedCode | undefined): CodeSwitch {
  let panel: Promise<CodePanel> | undefined;
  let close = () => {};
  return {
    show(isShown) {
      if (!isShown && panel === undefined) return;
      const parent = document.querySelector('.game') as HTMLElement;
      panel ??= import('./code-panel.ts').then(({ createCodePanel }) =>
        createCodePanel(parent, id, linked, () => close()),
      );
      void panel.then(({ show }) => show(isShown));
    },
    closeBy(turnOff) {
      close = turnOff;
    },
  };
}

/** How runs are made and changed. @param first a run with the default values, which is the first one if they are asked for */
function simulationOf(example: Example, first: ExampleRun, settings: Settings, code: (isShown: boolean) => void) {
  let unused: ExampleRun | undefined = first;
  const start = (options: ExampleOptions): ExampleRun => {
    const { seed, integrator, values = {} } = options;
    const ready = unused;
    unused = undefined;
    const isDefault = Object.entries(values).every(([name, value]) => value === example.parameters[name].initial);
    if (ready !== undefined && isDefault && seed === 1 && integrator === undefined) return ready;
    if (ready !== undefined) destroyWorld(ready.world);
    return example.start(options);
  };
  let ghosts: Ghosts | undefined;
  let seedNow = 1;
  const remember = (values: Readonly<Record<string, Value>>, seed: number) => {
    seedNow = seed;
    writeAddress(example.id, settings, values, seed);
  };
  return {
    create({ values, seed }: SimulationOptions<Settings>): LabRun {
      const integrator = chosenIntegrator(values);
      const options = { values: parameterValues(example, values), seed };
      const run = start(integrator === undefined ? options : { ...options, integrator });
      ghosts?.destroy();
      ghosts = makeGhosts(String(values.ghosts), example, options, run.world.integrator.name);
      remember(values, seed);
      code((values as Readonly<Record<string, Value>>).code === true);
      return presenting({ ...run, ghosts });
    },
    apply(_: LabRun, name: string, values: Readonly<Record<string, Value>>): boolean {
      if (name === 'code') code(values.code === true);
      const isShownOnly = SHOWN_SETTINGS.includes(name);
      if (isShownOnly) remember(values, seedNow);
      return isShownOnly;
    },
    dragSpeed: ({ picture: { view } }: LabRun) =>
      THROW_SPEED * Math.hypot(view.maxX - view.minX, view.maxY - view.minY),
    hasEnded: ({ world, dt }: LabRun) => example.ends && world.time > example.duration - dt / 2,
  };
}

function rendererOf(
  { dimensions, pointer }: Example,
  closeBy: CodeSwitch['closeBy'],
): Readonly<Record<string, Renderer<Settings, LabRun>>> {
  type Context = Parameters<Renderer<Settings, LabRun>['open']>[0];
  const withClose = (context: Context) => {
    closeBy(() => context.toggle('code'));
    return context;
  };
  return dimensions === 3
    ? {
        three: {
          label: '3D',
          dimensions,
          open: async (context) => (await import('./view-3d.ts')).openView3D(withClose(context), pointer),
        },
      }
    : {
        pixi: {
          label: '2D',
          dimensions,
          open: async (context) => (await import('./view-2d.ts')).openView(withClose(context), pointer),
        },
      };
}

/** The actions of an example as keys and buttons of the shell. */
function controlsOf({ actions }: Example): { readonly controls?: Controls<LabRun> } {
  const entries = Object.entries(actions);
  if (entries.length === 0) return {};
  const buttons = Object.fromEntries(entries.map(([name, { label, key }]) => [name, { label, keys: [key] }]));
  return {
    controls: {
      buttons,
      press: (run, name) => actOn(run, name, true),
      release: (run, name) => actOn(run, name, false),
    },
  };
}

/** The way back to the list, before the title; where there is little room it is a sign only. */
function addListLink(): void {
  const words = element('span', '', {}, WORDS.allExamples);
  const link = element(
    'a',
    'lab-back',
    { href: withLanguage(location.pathname), 'aria-label': WORDS.allExamples },
    '☰ ',
    words,
  );
  document.querySelector('.game-bar')?.prepend(link);
}
