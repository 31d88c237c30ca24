/** Actions that last as long as their key is held. */
import type { ExampleAction } from '../define-example.ts';

/**
 * @param key value of `KeyboardEvent.key` in lower case
 * @param act gets `amount` when the key goes down, and 0 when it goes up
 */
export function held<Run>(
  label: string,
  key: string,
  about: string,
  act: (run: Run, amount: number) => void,
  amount = 1,
): ExampleAction<Run> {
  return { label, key, about, press: (run) => act(run, amount), release: (run) => act(run, 0) };
}
