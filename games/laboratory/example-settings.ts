/** The parameters of an example as settings of the panel, and back. */
import { bodies, INTEGRATORS, type PhysicsWorld } from '@principia/physics';
import type { Example, ExampleParameter, ExampleRun } from '@principia/scenes/examples';
import { type ChoiceSetting, type Setting, switchSetting, type Value } from '@principia/shell';
import { ghostsSetting } from './make-ghosts.ts';
import { WORDS } from './words.ts';

const { settings: words } = WORDS;

/** The choice of the integrator that the example has by default. */
export const OWN_INTEGRATOR = 'own';

/** Schemes of fixed steps that apply to any force; others need options that belong to an example. */
const COMPARABLE = [
  'explicitEuler',
  'semiImplicitEuler',
  'positionFirstEuler',
  'midpoint',
  'heun',
  'positionVerlet',
  'velocityVerlet',
  'rungeKutta4',
  'yoshida4',
] as const;

type Comparable = (typeof COMPARABLE)[number];

/** Settings that change what is shown, and not the run. */
export const SHOWN_SETTINGS = ['arrows', 'trails', 'code'];

/** The settings of an example: its parameters, the integrator, and what is shown of what its picture has. */
export function settingsOf({ parameters }: Example, { picture, world }: ExampleRun): Record<string, Setting> {
  const own = Object.entries(parameters).map(([name, parameter]) => [name, settingOf(parameter)]);
  return {
    ...Object.fromEntries(own),
    ...(bodies(world).count > 0 && isComparable(world) ? { integrator: integratorSetting, ghosts: ghostsSetting } : {}),
    ...(picture.arrows === undefined ? {} : { arrows: switchSetting(words.arrows, true, { key: 'v' }) }),
    ...(picture.trails === undefined ? {} : { trails: switchSetting(words.trails, true, { key: 't' }) }),
    code: switchSetting(words.code, false, { key: 'k' }),
  };
}

/** Whether another integrator could take the place of the present one: rigid bodies have a solver of their own. */
function isComparable({ integrator }: PhysicsWorld): boolean {
  return COMPARABLE.some((name) => INTEGRATORS[name].name === integrator.name);
}

function settingOf(parameter: ExampleParameter): Setting {
  const { label, unit = '', initial, min, max, integer = false, scale, about, choices } = parameter;
  const more = { lang: 'en', ...(about === undefined ? {} : { about }), ...(scale === undefined ? {} : { scale }) };
  if (choices === undefined) return { kind: 'number', label, unit, initial, min, max, integer, ...more };
  const named = Object.fromEntries(choices.map((word) => [word, word]));
  return { kind: 'choice', label, initial: choices[initial], choices: named, ...more };
}

const integratorSetting: ChoiceSetting = {
  kind: 'choice',
  label: words.integrator[0],
  initial: OWN_INTEGRATOR,
  choices: {
    [WORDS.ownIntegrator]: OWN_INTEGRATOR,
    ...Object.fromEntries(COMPARABLE.map((name) => [WORDS.integrators[name], name])),
  },
  about: words.integrator[1],
};

/** The values of the parameters: a choice becomes the index of its word. */
export function parameterValues({ parameters }: Example, values: Readonly<Record<string, Value>>) {
  const entries = Object.entries(parameters).map(([name, { choices }]) => {
    const value = values[name];
    return [name, choices === undefined ? (value as number) : choices.indexOf(value as string)];
  });
  return Object.fromEntries(entries) as Record<string, number>;
}

/** The integrator that was chosen; undefined for the example's own. */
export function chosenIntegrator({ integrator }: Readonly<Record<string, Value>>) {
  return integrator === undefined || integrator === OWN_INTEGRATOR
    ? undefined
    : INTEGRATORS[integrator as Comparable].create();
}
