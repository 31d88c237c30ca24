/**
 * Makes the picture of docs/rigid-bodies.md from its table of engines; with `--measure` the table first, by the bench, in
 * a quarter of an hour on a quiet machine.
 */
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { commandOptions } from './lib/command-options.mjs';
import { root } from './lib/paths.mjs';
import { peersChart } from './lib/peers-chart.mjs';
import { ENGINES, readPeers, SCENES, withPeers } from './lib/peers-table.mjs';
import { reportFailure } from './lib/report-failure.mjs';
import { runNode } from './lib/run.mjs';

const values = commandOptions({ measure: { type: 'boolean', default: false } });
const page = `${root}/docs/rigid-bodies.md`;
const folder = mkdtempSync(join(tmpdir(), 'principia-peers-'));

try {
  if (values.measure) {
    const rows = [];
    for (const scene of SCENES) rows.push(await measure(scene));
    writeFileSync(page, withPeers(readFileSync(page, 'utf8'), rows));
  }
  writeFileSync(`${root}/docs/images/rigid-peers.svg`, peersChart(readPeers(readFileSync(page, 'utf8'))));
} catch (error) {
  await reportFailure(error);
} finally {
  rmSync(folder, { recursive: true, force: true });
}

/**
 * @param {typeof SCENES[number]} scene
 * @returns {Promise<import('./lib/peers-table.mjs').Row>}
 */
async function measure({ scene, count, steps, title }) {
  const file = join(folder, 'result.json');
  const code = await runNode([
    'scripts/bench.mjs',
    scene,
    '--count',
    `${count}`,
    '--steps',
    `${steps}`,
    '--peers',
    '--json',
    file,
  ]);
  if (code !== 0) throw new Error(`The bench of ${scene} failed.`);
  /** @type {{ peers: { name: string, ratio: number }[] }} */
  const { peers } = JSON.parse(readFileSync(file, 'utf8'));
  const ratios = ENGINES.map(({ name }) => {
    const peer = peers.find((each) => each.name === name);
    if (peer === undefined) throw new Error(`The bench of ${scene} did not measure ${name}.`);
    return peer.ratio;
  });
  return { title, ratios };
}
