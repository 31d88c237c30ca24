/**
 * The layouts of the records that kernels and TypeScript share: every exported `@unmanaged` class of the kernels, and every
 * exported size of a block, which is no class. The offsets are the compiler's own: it compiles a file of
 * `offsetof<Class>('field')`, whose exports are read.
 */
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { relative } from 'node:path';
import { compile } from './compile-kernels.mjs';
import { cacheFolder } from './paths.mjs';

/**
 * @typedef {{ name: string, type: string }} Field
 * @typedef {{ name: string, place: string, fields: Field[] }} Class `place`: its file, in the folder of the kernels
 * @typedef {Class & { bytes: { f32: number, f64: number }, offsets: number[] }} Layout bytes, and offsets of the fields,
 *   in f64; fields after a `real` stand elsewhere in f32
 * @typedef {{ name: string, place: string }} Size an exported constant, in bytes
 * @typedef {Size & { bytes: { f32: number, f64: number } }} MeasuredSize
 */

/** Bytes of what a field can be in a record that TypeScript reads; those of `real` depend on the precision. */
const BYTES = { usize: 4, i32: 4, u32: 4, f32: 4, f64: 8 };

/**
 * The kernels' sources, by place.
 * @param {string} folder
 * @returns {(readonly [place: string, text: string])[]}
 */
function sourcesIn(folder) {
  return readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.ts'))
    .map((name) => name.replaceAll('\\', '/'))
    .sort()
    .map((place) => /** @type {const} */ ([place, readFileSync(`${folder}/${place}`, 'utf8')]));
}

/** A size that is more than that of one class, whose bytes are among the layouts. */
const SIZE_OF_A_BLOCK = /^(?:@inline )?export const (\w+_(?:SIZE|BLOCK)): usize = (?!\(?offsetof<\w+>\(\))/gm;

/**
 * @param {string} folder
 * @returns {Size[]}
 */
function sizesIn(folder) {
  return sourcesIn(folder).flatMap(([place, text]) =>
    [...text.matchAll(SIZE_OF_A_BLOCK)].map(([, name]) => ({ name, place })),
  );
}

/**
 * @param {string} folder
 * @returns {Class[]}
 */
function classesIn(folder) {
  const classes = sourcesIn(folder).flatMap(([place, text]) => {
    return [...text.matchAll(/^@unmanaged\nexport class (\w+) \{\n([\s\S]*?)^\}/gm)].map(([, name, body]) => {
      const fields = [...body.matchAll(/^ {2}(\w+): (\w+);/gm)].map(([, field, type]) => ({ name: field, type }));
      return { name, place, fields };
    });
  });
  for (const [i, { name, place }] of classes.entries()) {
    const earlier = classes.findIndex((other) => other.name === name);
    if (earlier === i) continue;
    throw new Error(`kernels/${place} and kernels/${classes[earlier].place} both export ${name}: rename one of them.`);
  }
  return classes;
}

/**
 * The layout of every shared class, and every exported size.
 * @param {string} folder the folder of the kernels
 * @returns {Promise<{ layouts: Layout[], sizes: MeasuredSize[] }>}
 */
export async function layoutsIn(folder) {
  const classes = classesIn(folder);
  const sizes = sizesIn(folder);
  if (classes.length === 0) return { layouts: [], sizes: [] };
  mkdirSync(cacheFolder, { recursive: true });
  const output = mkdtempSync(`${cacheFolder}/layouts-`);
  try {
    writeFileSync(`${output}/probe.ts`, probeOf(classes, sizes, relative(output, folder).replaceAll('\\', '/')));
    const entry = `${relative(folder, output)}/probe.ts`;
    const measure = async (/** @type {'f32' | 'f64'} */ precision) =>
      numbersOf((await compile(folder, entry, precision, output, ['--use', `real=${precision}`])).wasm);
    const [f32, f64] = await Promise.all([measure('f32'), measure('f64')]);
    const bytesOf = (/** @type {string} */ name) => ({ f32: f32(name), f64: f64(name) });
    const layouts = classes.map((each, c) => ({
      ...each,
      bytes: bytesOf(`bytes${c}`),
      offsets: each.fields.map((_, f) => f64(`offset${c}_${f}`)),
    }));
    return { layouts, sizes: sizes.map((size, s) => ({ ...size, bytes: bytesOf(`size${s}`) })) };
  } finally {
    rmSync(output, { recursive: true, force: true });
  }
}

/**
 * A record takes a multiple of its alignment, so that records can follow each other.
 * @param {Class[]} classes
 * @param {Size[]} sizes
 * @param {string} folder
 */
function probeOf(classes, sizes, folder) {
  const from = (/** @type {string} */ place) => `from '${folder}/${place.replace(/\.ts$/, '')}';`;
  const ofSizes = sizes.flatMap(({ name, place }, s) => [
    `import { ${name} } ${from(place)}`,
    `export const size${s}: usize = ${name};`,
  ]);
  const lines = classes.flatMap(({ name, place, fields }, c) => [
    `import { ${name} } ${from(place)}`,
    ...fields.map((field, f) => `export const offset${c}_${f}: usize = offsetof<${name}>('${field.name}');`),
    `const align${c}: usize = ${fields.map(({ type }) => `sizeof<${type}>()`).reduce((a, b) => `max<usize>(${a}, ${b})`)};`,
    `export const bytes${c}: usize = (offsetof<${name}>() + align${c} - 1) & ~(align${c} - 1);`,
  ]);
  return `${[...lines, ...ofSizes].join('\n')}\n`;
}

/** @param {Uint8Array<ArrayBuffer>} wasm */
function numbersOf(wasm) {
  const env = { memory: new WebAssembly.Memory({ initial: 1 }) };
  const { exports } = new WebAssembly.Instance(new WebAssembly.Module(wasm), { env });
  return (/** @type {string} */ name) => Number(/** @type {WebAssembly.Global} */ (exports[name]).value);
}

/**
 * The layouts in TypeScript.
 * @param {{ layouts: Layout[], sizes: MeasuredSize[] }} found
 */
export function layoutText({ layouts, sizes }) {
  return [...layouts.map(textOf), ...sizes.map(sizeText)].map((text) => `\n${text}`).join('');
}

/** @param {MeasuredSize} size */
function sizeText({ name, place, bytes }) {
  const value = bytes.f32 === bytes.f64 ? bytes.f64 : `{ f32: ${bytes.f32}, f64: ${bytes.f64} } as const`;
  return `/** Bytes, of kernels/${place}. */\nexport const ${name} = ${value};\n`;
}

/** @param {Layout} layout */
function textOf({ name, place, fields, bytes, offsets }) {
  const constant = name.replace(/(?<=.)(?=[A-Z])/g, '_').toUpperCase();
  const file = `kernels/${place}`;
  if (fields.some(({ type }) => type === 'real')) {
    const each = `{ f32: ${bytes.f32}, f64: ${bytes.f64} }`;
    return `/** Bytes of the class ${name} of ${file}, by precision. */\nexport const ${constant}_BYTES = ${each} as const;\n`;
  }
  const isNumber = (/** @type {Field} */ { type }) => type === 'f64';
  const members = (/** @type {boolean} */ numbers) =>
    fields.flatMap((field, f) => {
      const size = BYTES[/** @type {keyof typeof BYTES} */ (field.type)];
      if (size === undefined) {
        throw new Error(`${file}: ${name}.${field.name} is of the type ${field.type}, which TypeScript cannot share.`);
      }
      return isNumber(field) === numbers ? [`  ${field.name} = ${offsets[f] / size},\n`] : [];
    });
  const [words, numbers] = [members(false), members(true)];
  const texts = [`/** Bytes of the class ${name} of ${file}. */\nexport const ${constant}_BYTES = ${bytes.f64};\n`];
  if (words.length > 0) {
    texts.push(`/** The fields of four bytes of ${name}: indices into a Uint32Array over the record. */\n`);
    texts.push(`export const enum ${name}Word {\n${words.join('')}}\n`);
  }
  if (numbers.length > 0) {
    texts.push(`/** The f64 fields of ${name}: indices into a Float64Array over the record. */\n`);
    texts.push(`export const enum ${name}Number {\n${numbers.join('')}}\n`);
  }
  if (words.length === 0) {
    const names = fields.map((field) => `'${field.name}'`).join(', ');
    texts.push(
      `/** The fields of ${name}, all f64, in order. */\nexport const ${constant}_FIELDS = [${names}] as const;\n`,
    );
  }
  return texts.join('');
}
