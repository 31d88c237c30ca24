/** The table of docs/integrators.md, from the records of `INTEGRATORS`. */

/**
 * @typedef {{ code: string, name: string, order: number, orderWithVelocity: number, symplectic: boolean,
 *   reversible: boolean, evaluations: string, chooseWhen: string }} Facts
 * @param {Readonly<Record<string, Facts>>} records
 * @returns {string}
 */
export function integratorsTable(records) {
  const head = [
    '| integrator | order | with forces of velocity | symplectic | reversible | force evaluations | choose it when |',
    '|---|---|---|---|---|---|---|',
  ];
  const rows = Object.values(records).map((facts) => {
    const { code, order, orderWithVelocity, symplectic, reversible, evaluations, chooseWhen } = facts;
    const cells = [`\`${code}\``, order, orderWithVelocity, yes(symplectic), yes(reversible), evaluations, chooseWhen];
    return `| ${cells.join(' | ')} |`;
  });
  return [...head, ...rows].join('\n');
}

/** @param {boolean} value */
function yes(value) {
  return value ? 'yes' : 'no';
}

const START = '<!-- made by scripts/integrators-page.mjs -->';
const END = '<!-- end -->';

/**
 * The page with its table made anew.
 * @param {string} page
 * @param {Readonly<Record<string, Facts>>} records
 */
export function withTable(page, records) {
  const [start, end] = [page.indexOf(START), page.indexOf(END)];
  if (start < 0 || end < start) throw new Error('docs/integrators.md has lost the marks of its table.');
  return `${page.slice(0, start)}${START}\n${integratorsTable(records)}\n${page.slice(end)}`;
}
