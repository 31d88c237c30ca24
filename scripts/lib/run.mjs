/** Runs another program of the project with its output shown as it comes. */
import { spawn } from 'node:child_process';
import { root } from './paths.mjs';

/**
 * @param {readonly string[]} args for Node
 * @param {NodeJS.ProcessEnv} [env] additions to the environment
 * @returns {Promise<number>} the exit code
 */
export function runNode(args, env = {}) {
  const child = spawn(process.execPath, args, { cwd: root, stdio: 'inherit', env: { ...process.env, ...env } });
  return new Promise((resolve, reject) => {
    child.on('error', reject);
    child.on('exit', (code) => resolve(code ?? 1));
  });
}
