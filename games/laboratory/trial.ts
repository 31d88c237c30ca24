/** Runs in a worker: tries the source of an example, so that a loop without end does not stop the page. */
import { step } from '@principia/physics';
import { codeError, exampleFrom } from './run-code.ts';

/** Milliseconds of steps that are tried. */
const BUDGET = 700;
const MAX_STEPS = 600;

/** What the worker answers: first that it is ready, then how the trial ended. */
export type TrialMessage =
  | { readonly kind: 'ready' }
  | { readonly kind: 'passed' }
  | { readonly kind: 'failed'; readonly message: string; readonly line: number | undefined };

const answer = (message: TrialMessage) => (globalThis as unknown as Worker).postMessage(message);

globalThis.addEventListener('message', ({ data }: MessageEvent<string>) => {
  tryExample(data).then(
    () => answer({ kind: 'passed' }),
    (error) => {
      const { message, line } = codeError(error);
      answer({ kind: 'failed', message, line });
    },
  );
});
answer({ kind: 'ready' });

async function tryExample(source: string): Promise<void> {
  const example = await exampleFrom(source);
  const run = example.start();
  const deadline = performance.now() + BUDGET;
  for (let i = 0; i < MAX_STEPS && performance.now() < deadline; i++) {
    step(run.world, run.dt);
    run.observe();
  }
  for (const { x, series } of run.plots) for (const { value } of [x, ...series]) value();
}
