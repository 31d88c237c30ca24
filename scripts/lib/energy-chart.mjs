/** Draws energy errors over orbits as an SVG: both axes logarithmic, every line named at its end. */

const WIDTH = 960;
const HEIGHT = 600;
const LEFT = 84;
const RIGHT = 790;
const TOP = 84;
const BOTTOM = 540;
const LEAST = -16;
const MOST = 1;
const DECADES = 3;

/** One colour for each order; dashes for what is not symplectic. */
const COLOURS = new Map([
  [1, '#c2410c'],
  [2, '#2563eb'],
  [4, '#7c3aed'],
  [5, '#0f766e'],
  [6, '#be185d'],
  [15, '#111827'],
]);

/** @param {number} orbits */
const x = (orbits) => LEFT + ((RIGHT - LEFT) * Math.log10(orbits)) / DECADES;

/** @param {number} error */
function y(error) {
  const power = Math.min(MOST, Math.max(LEAST, Math.log10(error)));
  return BOTTOM - ((BOTTOM - TOP) * (power - LEAST)) / (MOST - LEAST);
}

/**
 * @param {import('./energy-errors.mjs').Line[]} lines
 * @returns {string}
 */
export function energyChart(lines) {
  const parts = [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${HEIGHT}" width="${WIDTH}" height="${HEIGHT}" ` +
      'font-family="system-ui, Helvetica, Arial, sans-serif" role="img" ' +
      'aria-label="Energy error of each integrator over a thousand orbits">',
    `<rect width="${WIDTH}" height="${HEIGHT}" fill="#ffffff"/>`,
    text(LEFT, 34, 'Energy error over a thousand orbits', 'font-size="20" font-weight="600" fill="#111827"'),
    text(
      LEFT,
      58,
      'Eccentricity 0.3, 400 force evaluations an orbit for every scheme of fixed step; dashed: not symplectic',
      'font-size="13" fill="#4b5563"',
    ),
    ...grid(),
    ...lines.map(path),
    ...labels(lines),
    '</svg>',
  ];
  return `${parts.join('\n')}\n`;
}

/** @returns {string[]} */
function grid() {
  const parts = [];
  for (let power = LEAST; power <= MOST; power++) {
    const at = y(10 ** power).toFixed(1);
    const strong = power % 4 === 0;
    parts.push(`<path d="M${LEFT} ${at}H${RIGHT}" stroke="${strong ? '#d1d5db' : '#f1f3f5'}"/>`);
    if (strong) parts.push(tick(LEFT - 10, Number(at) + 4, power, 'end'));
  }
  for (let power = 0; power <= DECADES; power++) {
    const at = x(10 ** power).toFixed(1);
    parts.push(`<path d="M${at} ${TOP}V${BOTTOM}" stroke="#e5e7eb"/>`);
    parts.push(
      text(Number(at), BOTTOM + 22, String(10 ** power), 'font-size="12" fill="#4b5563" text-anchor="middle"'),
    );
  }
  const middle = (TOP + BOTTOM) / 2;
  parts.push(text((LEFT + RIGHT) / 2, BOTTOM + 46, 'orbits', 'font-size="13" fill="#374151" text-anchor="middle"'));
  parts.push(
    text(
      26,
      middle,
      'largest |ΔE / E| so far',
      `font-size="13" fill="#374151" text-anchor="middle" transform="rotate(-90 26 ${middle})"`,
    ),
  );
  return parts;
}

/** @param {import('./energy-errors.mjs').Line} line */
function path({ points, order, symplectic }) {
  const d = points.map(([orbits, error], i) => `${i === 0 ? 'M' : 'L'}${x(orbits).toFixed(1)} ${y(error).toFixed(1)}`);
  const dash = symplectic ? '' : ' stroke-dasharray="6 4"';
  const stroke = COLOURS.get(order) ?? '#111827';
  return `<path d="${d.join('')}" fill="none" stroke="${stroke}" stroke-width="2" stroke-linejoin="round"${dash}/>`;
}

/**
 * Names at the ends of the lines, moved apart where they would overlap, each with a thin leader.
 * @param {import('./energy-errors.mjs').Line[]} lines
 */
function labels(lines) {
  const GAP = 17;
  const ends = lines
    .map(({ name, order, points }) => {
      const end = y((points.at(-1) ?? [1, 1])[1]);
      return { name, order, end, at: end };
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
  return ends.flatMap(({ name, order, end, at }) => {
    const colour = COLOURS.get(order) ?? '#111827';
    return [
      `<path d="M${RIGHT} ${end.toFixed(1)}L${RIGHT + 14} ${at.toFixed(1)}" stroke="${colour}" stroke-width="0.8" fill="none"/>`,
      text(RIGHT + 18, at + 4, name, `font-size="13" fill="${colour}"`),
    ];
  });
}

/**
 * @param {number} left
 * @param {number} baseline
 * @param {number} power
 * @param {string} anchor
 */
function tick(left, baseline, power, anchor) {
  const raised = `<tspan dy="-5" font-size="9">${String(power).replace('-', '−')}</tspan>`;
  return `<text x="${left}" y="${baseline}" font-size="12" fill="#4b5563" text-anchor="${anchor}">10${raised}</text>`;
}

/**
 * @param {number} left
 * @param {number} baseline
 * @param {string} content
 * @param {string} attributes
 */
function text(left, baseline, content, attributes) {
  return `<text x="${left}" y="${baseline.toFixed(1)}" ${attributes}>${content}</text>`;
}
