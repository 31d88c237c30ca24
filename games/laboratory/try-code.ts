import { withLanguage } from '@principia/shell';
import { CodeError } from './run-code.ts';
import type { TrialMessage } from './trial.ts';
import { WORDS } from './words.ts';

/** Milliseconds after which code that runs is taken not to come to an end. */
const TIMEOUT = 4000;

/**
 * Tries the source of an example in a worker of its own.
 * @throws CodeError if it fails, or does not come to an end
 */
export async function tryCode(source: string): Promise<void> {
  // The script of this page runs the trial where there is no page.
  const worker = new Worker(new URL(withLanguage('./main.js'), document.baseURI), { type: 'module' });
  try {
    await new Promise<void>((resolve, reject) => {
      const stop = () => reject(new CodeError(WORDS.code.endless(TIMEOUT / 1000), undefined));
      worker.addEventListener('error', ({ message }) => reject(new CodeError(message, undefined)));
      worker.addEventListener('message', ({ data }: MessageEvent<TrialMessage>) => {
        if (data.kind === 'ready') {
          worker.postMessage(source);
          setTimeout(stop, TIMEOUT);
        } else if (data.kind === 'passed') resolve();
        else reject(new CodeError(data.message, data.line));
      });
    });
  } finally {
    worker.terminate();
  }
}
