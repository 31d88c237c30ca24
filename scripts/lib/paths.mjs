/** The few places every script needs, so that no script depends on the folder it was started from. */
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';

/** The repository root, without a trailing slash. */
export const root = fileURLToPath(new URL('../..', import.meta.url)).replace(/[\\/]$/, '');

/** Throw-away files of the scripts: never committed, safe to delete. */
export const cacheFolder = `${root}/node_modules/.cache/principia`;

/** The path of a file inside an installed package (`import.meta.resolve` is missing inside vitest). */
export const resolveInstalled = createRequire(import.meta.url).resolve;
