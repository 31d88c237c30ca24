import { type Controller, GUI } from 'lil-gui';
import { addLogSlider } from './log-slider.ts';
import { decimalsOf, readField, speakNumbers } from './number-field.ts';
import type { NumberSetting, Setting, Settings } from './settings.ts';
import { words } from './words.ts';

/** Sliders and switches for a game's settings. */
export interface Panel {
  /** Shows the present values. */
  refresh(): void;
  /** Shows limits that the game has moved since; cheap if none was. */
  showLimits(): void;
  destroy(): void;
}

/**
 * Builds the panel from the declared settings.
 * @param values read for display; written only through `onChange`
 * @param onChange receives the name and the requested value
 */
export function createPanel(
  parent: HTMLElement,
  settings: Settings,
  values: Readonly<Record<string, unknown>>,
  onChange: (name: string, value: unknown) => void,
): Panel {
  const gui = new GUI({ container: parent, title: words().settings });
  const controllers = Object.entries(settings).flatMap(([name, setting]) => {
    const proxy = Object.defineProperty({} as Record<string, never>, name, {
      get: () => values[name],
      set: (value) => onChange(name, value),
      enumerable: true,
    });
    const controller = addController(gui, proxy, name, setting);
    const unit = setting.kind === 'number' && setting.unit !== '' ? `, ${setting.unit.replaceAll(' ', '\u00a0')}` : '';
    controller.name(`${setting.label}${unit}`);
    if (setting.lang !== undefined) controller.domElement.lang = setting.lang;
    if (setting.about !== undefined) controller.domElement.title = setting.about;
    if (setting.kind !== 'number' || setting.presets === undefined) return [controller];
    const named = addPresets(
      gui,
      setting.label,
      setting.presets,
      () => values[name] as number,
      (value) => onChange(name, value),
    );
    // The slider and the list of its named values follow each other.
    controller.onChange(() => named.updateDisplay());
    named.onChange(() => controller.updateDisplay());
    return [controller, named];
  });
  if (controllers.length > 0) addDefaults(gui, settings, values, onChange);
  const refresh = () => {
    for (const controller of controllers) controller.updateDisplay();
  };
  const numbers = Object.values(settings).filter((setting) => setting.kind === 'number');
  let limit = Number.NaN;
  return {
    refresh,
    showLimits() {
      // `max` may be a getter, as of levels that are reached while one plays.
      let sum = 0;
      for (const { max } of numbers) sum += max;
      if (sum !== limit) refresh();
      limit = sum;
    },
    destroy: () => gui.destroy(),
  };
}

/** A button that gives every setting the value that it begins with. */
function addDefaults(
  gui: GUI,
  settings: Settings,
  values: Readonly<Record<string, unknown>>,
  onChange: (name: string, value: unknown) => void,
): void {
  const restore = () => {
    for (const [name, { initial }] of Object.entries(settings)) if (values[name] !== initial) onChange(name, initial);
    for (const controller of gui.controllers) controller.updateDisplay();
  };
  const { domElement } = gui.add({ restore }, 'restore').name(words().defaults);
  domElement.title = words().defaultsHint;
}

/** A list of named values of a slider. @param label of the slider, which the list has only for screen readers */
function addPresets(
  gui: GUI,
  label: string,
  presets: Readonly<Record<string, number>>,
  read: () => number,
  write: (value: number) => void,
): Controller {
  /** Label of a value that has no name. */
  const own = words().asAbove;
  const proxy = {
    get named() {
      return Object.keys(presets).find((name) => presets[name] === read()) ?? own;
    },
    set named(name: string) {
      if (name !== own) write(presets[name]);
    },
  };
  const controller = gui.add(proxy, 'named', [own, ...Object.keys(presets)]).name('');
  const list = controller.domElement.querySelector('select') as HTMLSelectElement;
  list.removeAttribute('aria-labelledby');
  list.ariaLabel = label;
  return controller;
}

function addController(gui: GUI, proxy: Record<string, never>, name: string, setting: Setting): Controller {
  if (setting.kind === 'switch') return gui.add(proxy, name);
  if (setting.kind === 'choice') return gui.add(proxy, name, setting.choices);
  const controller = addSlider(gui, proxy, name, setting);
  const { integer: isWhole, min } = setting;
  const input = controller.domElement.querySelector('input') as HTMLInputElement;
  speakNumbers(input, { isWhole, min });
  tellRange(controller, input, () => ({ min, max: setting.max, now: proxy[name] as number }));
  return controller.updateDisplay();
}

/** Tells screen readers that the arrow keys change a field, its limits and its value. */
function tellRange(
  controller: Controller,
  input: HTMLInputElement,
  range: () => Readonly<Record<'min' | 'max' | 'now', number>>,
): void {
  input.role = 'spinbutton';
  const show = controller.updateDisplay.bind(controller);
  controller.updateDisplay = () => {
    show();
    for (const [name, value] of Object.entries(range())) input.setAttribute(`aria-value${name}`, String(value));
    return controller;
  };
}

function addSlider(gui: GUI, proxy: Record<string, never>, name: string, setting: NumberSetting): Controller {
  if (setting.scale === 'log') return addLogSlider(gui, proxy, name, setting);
  const step = stepOf(setting);
  const leastDecimals = Math.max(0, -Math.floor(Math.log10(step)));
  const controller = gui.add(proxy, name, setting.min, setting.max, step);
  const input = controller.domElement.querySelector('input') as HTMLInputElement;
  const read = () => proxy[name] as number;
  const show = controller.updateDisplay.bind(controller);
  controller.updateDisplay = () => {
    // A single value is no choice.
    controller.max(setting.max).enable(setting.max > setting.min);
    show();
    // A value need not lie on a step of the slider.
    if (document.activeElement !== input) input.value = read().toFixed(decimalsOf(read(), leastDecimals));
    return controller;
  };
  readField(controller.domElement, {
    read,
    write(value) {
      const whole = setting.integer ? Math.round(value) : value;
      controller.setValue(Math.min(setting.max, Math.max(setting.min, whole)));
    },
    moved: (value, steps) => Number((value + steps * step).toFixed(decimalsOf(value, leastDecimals))),
  });
  return controller;
}

/** About a hundredth of the range, rounded down to a power of ten, so that sliders stop at round numbers. */
function stepOf({ min, max, integer, step }: NumberSetting): number {
  if (step !== undefined) return step;
  return integer ? 1 : 10 ** Math.floor(Math.log10((max - min) / 100));
}
