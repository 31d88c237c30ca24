import { formatMessages } from 'esbuild';

/**
 * Ends a script: esbuild's errors with file, line and excerpt, anything else as its message, and exit code 1.
 * @param {unknown} error
 */
export async function reportFailure(error) {
  const { errors, message = String(error) } = /** @type {Partial<import('esbuild').BuildFailure>} */ (error);
  const messages = errors ? await formatMessages(errors, { kind: 'error', color: process.stderr.isTTY }) : [message];
  process.stderr.write(`${messages.join('')}\n`);
  process.exitCode = 1;
}
