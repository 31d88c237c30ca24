/** Draws how many times our time other engines take as an SVG: a row a scene, a dot an engine, on a logarithmic axis. */
import { ENGINES } from './peers-table.mjs';

const WIDTH = 760;
const ROW = 30;
const PLOT = { left: 226, right: 24, top: 92 };
const TICKS = [1, 2, 5, 10, 20, 50, 100];
/** Right end of the axis. */
const MOST = 160;
const INK = '#111827';
const GREY = '#4b5563';
const OURS = '#111827';
/** Told apart by all eyes (Okabe and Ito), dark enough on white; as many as `ENGINES`. */
const COLOURS = ['#0072b2', '#009e73', '#d55e00', '#cc79a7'];

/** @param {number} ratio */
const x = (ratio) => PLOT.left + ((WIDTH - PLOT.left - PLOT.right) * Math.log(ratio / 0.9)) / Math.log(MOST / 0.9);

/**
 * @param {readonly import('./peers-table.mjs').Row[]} rows
 * @returns {string}
 */
export function peersChart(rows) {
  const bottom = PLOT.top + rows.length * ROW;
  const height = bottom + 34;
  const parts = [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${height}" width="${WIDTH}" height="${height}" ` +
      'font-family="system-ui, Helvetica, Arial, sans-serif" role="img" ' +
      'aria-label="Time of a step of rigid bodies in other engines, as multiples of ours">',
    `<rect width="${WIDTH}" height="${height}" fill="#ffffff"/>`,
    text(
      24,
      30,
      'Rigid bodies: how many times our time other engines take',
      `font-size="17" font-weight="600" fill="${INK}"`,
    ),
    text(24, 50, 'Each engine steps the same scene in turn with ours, on one thread, while nothing sleeps', note()),
    ...legend(),
    ...TICKS.flatMap((ratio) => grid(ratio, bottom)),
    ...rows.flatMap(({ title, ratios }, row) => dots(title, ratios, PLOT.top + (row + 0.5) * ROW)),
    '</svg>',
  ];
  return `${parts.join('\n')}\n`;
}

function legend() {
  let left = 24;
  const entries = [{ title: 'Principia', colour: OURS }, ...ENGINES.map(named)];
  return entries.flatMap(({ title, colour }, i) => {
    const at = left;
    left += 34 + 7.2 * title.length;
    return [mark(at + 5, 71, colour, i === 0), text(at + 16, 75, title, note())];
  });
}

/**
 * @param {{ title: string }} engine
 * @param {number} i
 */
function named({ title }, i) {
  // The table's column beside Box2D's own needs its name only here.
  return { title: title === 'with SIMD' ? 'Box2D 3 with SIMD' : title, colour: COLOURS[i] };
}

/**
 * @param {number} ratio
 * @param {number} bottom
 */
function grid(ratio, bottom) {
  const at = x(ratio).toFixed(1);
  return [
    `<path d="M${at} ${PLOT.top}V${bottom}" stroke="${ratio === 1 ? OURS : '#e5e7eb'}" stroke-width="${ratio === 1 ? 2 : 1}"/>`,
    text(Number(at), bottom + 20, ratio === 1 ? 'ours' : `${ratio} ×`, `${note()} text-anchor="middle"`),
  ];
}

/**
 * @param {string} title
 * @param {readonly number[]} ratios
 * @param {number} y
 */
function dots(title, ratios, y) {
  return [
    text(PLOT.left - 14, y + 4, title.replaceAll('`', ''), `${note()} text-anchor="end"`),
    `<path d="M${x(Math.min(1, ...ratios)).toFixed(1)} ${y}H${x(Math.max(...ratios)).toFixed(1)}" stroke="#d1d5db"/>`,
    ...ratios.map((ratio, i) => mark(x(ratio), y, COLOURS[i], false, `${ENGINES[i].title}: ${ratio} ×`)),
  ];
}

const note = () => `font-size="13" fill="${GREY}"`;

/**
 * @param {number} cx
 * @param {number} cy
 * @param {string} colour
 * @param {boolean} isLine
 * @param {string} [title]
 */
function mark(cx, cy, colour, isLine, title = '') {
  if (isLine) return `<path d="M${cx} ${cy - 8}v16" stroke="${colour}" stroke-width="2"/>`;
  const inside = title === '' ? '' : `<title>${title}</title>`;
  return `<circle cx="${cx.toFixed(1)}" cy="${cy}" r="6" fill="${colour}" stroke="#ffffff" stroke-width="1.2">${inside}</circle>`;
}

/**
 * @param {number} left
 * @param {number} baseline
 * @param {string} content
 * @param {string} attributes
 */
function text(left, baseline, content, attributes) {
  return `<text x="${left}" y="${baseline}" ${attributes}>${content}</text>`;
}
