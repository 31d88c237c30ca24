/** Draws energy errors over orbits as an SVG of small panels, all with the same logarithmic axes. */

const WIDTH = 960;
const COLUMNS = 2;
const HEAD = 78;
/** Of a panel, its plot within it, and the space its names have at the right. */
const PANEL = { width: 480, height: 300 };
const PLOT = { left: 64, top: 50, width: 250, height: 200 };
const LEAST = -16;
const MOST = 2;
const DECADES = 3;

/** Told apart by all eyes (Okabe and Ito), dark enough on white. */
const COLOURS = ['#0072b2', '#d55e00', '#008060', '#a8417f'];
const GREY = '#8b93a1';
const NARROW = 2;
/** Of a line that another one lies on, so that both are seen. */
const WIDE = 6;
const INK = '#111827';

/** @param {number} orbits */
const x = (orbits) => PLOT.left + (PLOT.width * Math.log10(orbits)) / DECADES;

/** @param {number} error */
function y(error) {
  const power = Math.min(MOST, Math.max(LEAST, Math.log10(error)));
  return PLOT.top + PLOT.height - (PLOT.height * (power - LEAST)) / (MOST - LEAST);
}

/**
 * @param {import('./energy-errors.mjs').Chart[]} charts
 * @returns {string}
 */
export function energyChart(charts) {
  const height = HEAD + Math.ceil(charts.length / COLUMNS) * PANEL.height;
  const parts = [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${height}" width="${WIDTH}" height="${height}" ` +
      'font-family="system-ui, Helvetica, Arial, sans-serif" role="img" ' +
      'aria-label="Energy error of each integrator over a thousand orbits">',
    `<rect width="${WIDTH}" height="${height}" fill="#ffffff"/>`,
    text(24, 34, 'Energy error over a thousand orbits', `font-size="20" font-weight="600" fill="${INK}"`),
    text(
      24,
      58,
      'Largest |ΔE / E| so far. 400 force evaluations an orbit for every scheme of fixed step; grey: to compare with',
      'font-size="13" fill="#4b5563"',
    ),
    ...charts.map((chart, i) => {
      const [left, top] = [(i % COLUMNS) * PANEL.width, HEAD + Math.floor(i / COLUMNS) * PANEL.height];
      return `<g transform="translate(${left} ${top})">\n${panel(chart).join('\n')}\n</g>`;
    }),
    '</svg>',
  ];
  return `${parts.join('\n')}\n`;
}

/** @param {import('./energy-errors.mjs').Chart} chart */
function panel({ title, note, lines }) {
  const own = lines.filter(({ beside }) => !beside);
  const styled = lines.map((line) => {
    const place = own.indexOf(line);
    if (place < 0) return { ...line, colour: GREY, width: 1.3 };
    const covered = own.slice(place + 1).some((later) => liesOn(later, line));
    return { ...line, colour: COLOURS[place], width: covered ? WIDE : NARROW };
  });
  return [
    text(PLOT.left, 20, title, `font-size="14" font-weight="600" fill="${INK}"`),
    text(PLOT.left, 38, note, 'font-size="12" fill="#4b5563"'),
    ...grid(),
    ...styled.map(path),
    ...labels(styled),
  ];
}

/**
 * @param {import('./energy-errors.mjs').Line} a
 * @param {import('./energy-errors.mjs').Line} b
 */
function liesOn(a, b) {
  const near = a.points.filter(([, error], i) => Math.abs(y(error) - y(b.points[i][1])) < NARROW);
  return 2 * near.length > a.points.length;
}

/** @returns {string[]} */
function grid() {
  const parts = [];
  const [right, bottom] = [PLOT.left + PLOT.width, PLOT.top + PLOT.height];
  for (let power = LEAST; power <= MOST; power += 2) {
    const at = y(10 ** power).toFixed(1);
    const strong = power % 4 === 0;
    parts.push(`<path d="M${PLOT.left} ${at}H${right}" stroke="${strong ? '#d1d5db' : '#eceff3'}"/>`);
    if (strong) parts.push(tick(PLOT.left - 8, Number(at) + 4, power));
  }
  for (let power = 0; power <= DECADES; power++) {
    const at = x(10 ** power).toFixed(1);
    const name = power === DECADES ? `${10 ** power} orbits` : String(10 ** power);
    parts.push(`<path d="M${at} ${PLOT.top}V${bottom}" stroke="#e5e7eb"/>`);
    parts.push(text(Number(at), bottom + 19, name, 'font-size="11" fill="#4b5563" text-anchor="middle"'));
  }
  return parts;
}

/** @typedef {import('./energy-errors.mjs').Line & { colour: string, width: number }} Styled */

/** @param {Styled} line */
function path({ key, points, beside, colour, width }) {
  const d = points.map(([orbits, error], i) => `${i === 0 ? 'M' : 'L'}${x(orbits).toFixed(1)} ${y(error).toFixed(1)}`);
  const dash = beside ? ' stroke-dasharray="4 3"' : '';
  return (
    `<path data-scheme="${key}" d="${d.join('')}" fill="none" stroke="${colour}" stroke-width="${width}" ` +
    `stroke-linejoin="round" stroke-linecap="round"${dash}/>`
  );
}

/**
 * Names at the ends of the lines, moved apart where they would overlap, each with a leader as wide as its line.
 * @param {Styled[]} lines
 */
function labels(lines) {
  const GAP = 17;
  const right = PLOT.left + PLOT.width;
  const ends = lines
    .map((line) => {
      const end = y((line.points.at(-1) ?? [1, 1])[1]);
      return { ...line, end, at: end };
    })
    .sort((a, b) => a.end - b.end);
  for (let pass = 0; pass < 200; pass++) {
    for (let i = 1; i < ends.length; i++) {
      const overlap = GAP - (ends[i].at - ends[i - 1].at);
      if (overlap <= 0) continue;
      ends[i - 1].at -= overlap / 2;
      ends[i].at += overlap / 2;
    }
  }
  return ends.flatMap(({ name, end, at, colour, width, beside }) => [
    `<path d="M${right + 2} ${end.toFixed(1)}L${right + 14} ${at.toFixed(1)}h12" stroke="${colour}" ` +
      `stroke-width="${Math.min(width, 4)}" fill="none"/>`,
    text(right + 31, at + 4, name, `font-size="12.5" fill="${beside ? '#6b7280' : INK}"`),
  ]);
}

/**
 * @param {number} right
 * @param {number} baseline
 * @param {number} power
 */
function tick(right, baseline, power) {
  const raised = `<tspan dy="-5" font-size="8.5">${String(power).replace('-', '−')}</tspan>`;
  return `<text x="${right}" y="${baseline}" font-size="11" fill="#4b5563" text-anchor="end">10${raised}</text>`;
}

/**
 * @param {number} left
 * @param {number} baseline
 * @param {string} content
 * @param {string} attributes
 */
function text(left, baseline, content, attributes) {
  return `<text x="${left.toFixed(1)}" y="${baseline.toFixed(1)}" ${attributes}>${content}</text>`;
}
