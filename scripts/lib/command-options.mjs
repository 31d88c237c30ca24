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
    return refuse(`${message.split('. ')[0]}. The options are ${names.join(', ')}.`);
  }
}

/**
 * The number that an option was given. Anything else ends the script with exit code 2 and a sentence.
 * @param {string} name of the option, without dashes
 * @param {string} text
 * @param {{ min: number, max?: number, whole?: boolean }} range `whole` is the default
 */
export function numberOption(name, text, { min, max = Number.MAX_SAFE_INTEGER, whole = true }) {
  const value = text.trim() === '' ? Number.NaN : Number(text);
  if (value >= min && value <= max && (!whole || Number.isInteger(value))) return value;
  const range = max === Number.MAX_SAFE_INTEGER ? `from ${min}` : `from ${min} to ${max}`;
  return refuse(`--${name} must be a ${whole ? 'whole ' : ''}number ${range}, not "${text}".`);
}

/**
 * The games that an option names. One that there is not ends the script with exit code 2 and a sentence.
 * @param {readonly string[] | undefined} names
 * @param {readonly string[]} games that there are, the choice where none is named
 */
export function gamesOption(names, games) {
  const unknown = names?.find((name) => !games.includes(name));
  return unknown === undefined
    ? (names ?? games)
    : refuse(`There is no game "${unknown}": they are ${games.join(', ')}.`);
}

/**
 * Ends the script for what it was given.
 * @param {string} sentence
 * @returns {never}
 */
export function refuse(sentence) {
  process.stderr.write(`${sentence}\n`);
  process.exit(2);
}
