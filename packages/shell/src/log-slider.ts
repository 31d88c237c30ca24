import type { GUI, NumberController } from 'lil-gui';
import type { NumberSetting } from './settings.ts';

/** Factor of one press of an arrow key or one notch of the wheel. */
const STEP_FACTOR = 1.1;

/**
 * A slider with a logarithmic scale. lil-gui's slider works on the exponent; the number beside it shows and accepts the
 * value itself.
 */
export function addLogSlider<Name extends string>(
  gui: GUI,
  values: Record<Name, number>,
  name: Name,
  setting: NumberSetting,
): NumberController {
  const { min, max, integer } = setting;
  const tidy = (value: number) => {
    const rounded = integer ? Math.round(value) : Number(value.toPrecision(3));
    return Math.min(max, Math.max(min, rounded));
  };
  const proxy = {
    get exponent() {
      return Math.log10(values[name]);
    },
    set exponent(value: number) {
      values[name] = tidy(10 ** value);
    },
  };
  const low = Math.log10(min);
  const high = Math.log10(max);
  const controller = gui.add(proxy, 'exponent', low, high, (high - low) / 500) as NumberController;
  const { domElement } = controller;
  const input = domElement.querySelector('input') as HTMLInputElement;
  const showFill = controller.updateDisplay.bind(controller);
  controller.updateDisplay = () => {
    showFill();
    if (document.activeElement !== input) input.value = String(values[name]);
    return controller;
  };
  const set = (value: number) => controller.setValue(Math.log10(tidy(value)));
  // Runs in the capture phase, before lil-gui's listener on the input, which would read the typed value as an exponent.
  domElement.addEventListener(
    'input',
    (event) => {
      event.stopPropagation();
      const typed = Number.parseFloat(input.value);
      if (Number.isFinite(typed)) set(typed);
    },
    true,
  );
  const nudge = (event: Event, up: boolean) => {
    event.stopPropagation();
    event.preventDefault();
    const value = values[name];
    set(
      up
        ? Math.max(value * STEP_FACTOR, value + (integer ? 1 : 0))
        : Math.min(value / STEP_FACTOR, value - (integer ? 1 : 0)),
    );
    input.value = String(values[name]);
  };
  domElement.addEventListener(
    'keydown',
    (event) => {
      if (event.code === 'ArrowUp' || event.code === 'ArrowDown') nudge(event, event.code === 'ArrowUp');
    },
    true,
  );
  domElement.addEventListener(
    'wheel',
    (event) => {
      if (document.activeElement === input) nudge(event, event.deltaY < 0);
    },
    { capture: true, passive: false },
  );
  return controller.updateDisplay() as NumberController;
}
