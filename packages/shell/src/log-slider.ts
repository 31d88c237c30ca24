import type { GUI, NumberController } from 'lil-gui';
import { readField } from './number-field.ts';
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
  readField(domElement, {
    read: () => values[name],
    write: set,
    moved: (value, steps) =>
      steps > 0
        ? Math.max(value * STEP_FACTOR, value + (integer ? 1 : 0))
        : Math.min(value / STEP_FACTOR, value - (integer ? 1 : 0)),
  });
  return controller.updateDisplay() as NumberController;
}
