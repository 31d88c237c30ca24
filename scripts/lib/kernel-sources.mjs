/** Which sources a kernel module is made of, so that only the modules that a change concerns are compiled again. */
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

/**
 * The file that is compiled and all that it imports, directly or not, in a fixed order: paths within the folder.
 * @param {string} folder
 * @param {string} entry
 */
export function sourcesOf(folder, entry) {
  const found = new Set([entry]);
  for (const file of found) {
    for (const path of importsIn(readFileSync(`${folder}/${file}`, 'utf8'))) found.add(`${join(file, '..', path)}.ts`);
  }
  return [...found].sort();
}

/** @param {string} source */
function importsIn(source) {
  return [...source.matchAll(/^(?:import|export)\b[^;]*?\bfrom\s+'(\.[^']+)';/gm)].map((match) => match[1]);
}

/**
 * @param {string} folder
 * @param {readonly string[]} files in the folder
 * @param {readonly string[]} others texts on which the result depends too
 */
export function hashOf(folder, files, others) {
  const hash = createHash('sha256');
  for (const text of others) hash.update(text).update('\n');
  for (const file of files) hash.update(`\n${file}\n`).update(readFileSync(`${folder}/${file}`));
  return hash.digest('hex').slice(0, 32);
}
