/** The table of docs/rigid-bodies.md: how many times our time other engines take. */

/** The scenes, and what of them the table tells. Short steps are taken more often, until planck is compiled. */
export const SCENES = [
  { scene: 'pyramid', count: 1275, steps: 300, title: '`pyramid`, 1 275 boxes' },
  { scene: 'pyramid', count: 5050, steps: 120, title: '`pyramid`, 5 050 boxes' },
  { scene: 'many-pyramids', count: 22_000, steps: 120, title: '`many-pyramids`, 22 000 boxes' },
  { scene: 'discs', count: 10_000, steps: 120, title: '`discs`, 10 000' },
  { scene: 'smash', count: 9600, steps: 120, title: '`smash`, 9 600 boxes' },
  { scene: 'elastic-discs', count: 4000, steps: 300, title: '`elastic-discs`, 4 000' },
  { scene: 'tumbler', count: 2025, steps: 300, title: '`tumbler`, 2 025 boxes' },
  { scene: 'washer', count: 8100, steps: 60, title: '`washer`, 8 100 boxes' },
  { scene: 'chains', count: 2500, steps: 300, title: '`chains`, 2 500 links' },
  { scene: 'joint-grid', count: 2500, steps: 300, title: '`joint-grid`, 2 500 discs' },
];

/** Columns of the table, and how the bench calls these engines. */
export const ENGINES = [
  { title: 'Box2D 3', name: 'Box2D 3 (box2d3-wasm)' },
  { title: 'with SIMD', name: 'Box2D 3 with SIMD (box2d3-wasm, one thread)' },
  { title: 'Rapier 0.21', name: 'Rapier 0.21' },
  { title: 'planck 1.4', name: 'planck 1.4' },
];

const START = '<!-- made by scripts/peers-page.mjs -->';
const END = '<!-- end of the peers -->';

/** @typedef {{ title: string, ratios: number[] }} Row ratios of the times of `ENGINES` to ours */

/**
 * The page with its table made anew.
 * @param {string} page
 * @param {readonly Row[]} rows
 */
export function withPeers(page, rows) {
  const [start, end] = marksOf(page);
  return `${page.slice(0, start)}${START}\n${peersTable(rows)}\n${page.slice(end)}`;
}

/** @param {readonly Row[]} rows */
function peersTable(rows) {
  const head = [
    `| scene | ${ENGINES.map(({ title }) => title).join(' | ')} |`,
    `|---|${'--:|'.repeat(ENGINES.length)}`,
  ];
  const means = ENGINES.map((_, i) => geometricMean(rows.map(({ ratios }) => ratios[i])));
  const lines = [...rows, { title: 'geometric mean', ratios: means }].map(
    ({ title, ratios }) => `| ${title} | ${ratios.map(digits).join(' | ')} |`,
  );
  return [...head, ...lines].join('\n');
}

/**
 * The rows of the page's table, its means last.
 * @param {string} page
 * @returns {Row[]}
 */
export function readPeers(page) {
  const [start, end] = marksOf(page);
  const lines = page.slice(start, end).trim().split('\n').slice(3);
  return lines.map((line) => {
    const [title, ...ratios] = line
      .split('|')
      .slice(1, -1)
      .map((cell) => cell.trim());
    return { title, ratios: ratios.map(Number) };
  });
}

/** @param {string} page */
function marksOf(page) {
  const [start, end] = [page.indexOf(START), page.indexOf(END)];
  if (start < 0 || end < start) throw new Error('docs/rigid-bodies.md has lost the marks of its table of engines.');
  return [start, end];
}

/** @param {number} ratio */
const digits = (ratio) => (ratio < 9.95 ? ratio.toFixed(1) : ratio.toFixed(0));

/** @param {readonly number[]} values */
const geometricMean = (values) => Math.exp(values.reduce((sum, value) => sum + Math.log(value), 0) / values.length);
