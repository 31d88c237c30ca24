import { parseArgs } from 'node:util';

/**
 * The options a script was given. One that it does not know ends it with exit code 2 and a sentence that lists those it
 * does.
 * @template {NonNullable<import('node:util').ParseArgsConfig['options']>} T
 * @param {T} options as for `parseArgs`
 */
export function commandOptions(options) {
  try {
    return parseArgs({ options }).values;
  } catch (error) {
    const names = Object.keys(options).map((name) => `--${name}`);
    const { message } = /** @type {Error} */ (error);
    process.stderr.write(`${message.split('. ')[0]}. The options are ${names.join(', ')}.\n`);
    process.exit(2);
  }
}
