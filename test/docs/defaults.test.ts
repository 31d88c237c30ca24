/** Every optional field of the interfaces that packages export says what it is when it is left out. */
import { expect, it } from 'vitest';
import { expectNone, isTest, lineOf, type Node, parse, typescriptFiles, walk } from '../rules/sources.ts';

const files = typescriptFiles.filter((path) => /^packages\/[^/]+\/src\//.test(path) && !isTest(path));

/** The words of the front page of each package, among them the names that it exports. */
const exported = new Map(
  files
    .filter((path) => /^packages\/[^/]+\/src\/index\.ts$/.test(path))
    .map((path) => [path.split('/')[1], new Set(parse(path).text.match(/\w+/g))]),
);

/** What users read and never write. */
const READ_ONLY = new Set(['Fault', 'FaultDetails', 'Law', 'SceneRun', 'Shape', 'ShellKind']);

/** The optional fields of a file's exported options, with their docstrings. */
function optionalFields(path: string) {
  const { text, tree } = parse(path);
  const found: { where: string; doc: string }[] = [];
  walk(tree, (node) => {
    if (node.type !== 'ExportNamedDeclaration') return;
    const declaration = node.declaration as Node | null;
    if (declaration?.type !== 'TSInterfaceDeclaration') return;
    const name = (declaration.id as unknown as { name: string }).name;
    if (!exported.get(path.split('/')[1])?.has(name) || READ_ONLY.has(name)) return;
    walk(declaration, (field) => {
      if (field.type !== 'TSPropertySignature' || field.optional !== true) return;
      const key = (field.key as unknown as { name: string }).name;
      const doc = /\/\*\*((?:(?!\*\/)[\s\S])*)\*\/\s*$/.exec(text.slice(0, field.start))?.[1] ?? '';
      found.push({ where: `${path}:${lineOf(text, field.start)} ${name}.${key}`, doc });
    });
  });
  return found;
}

it('every optional field of exported options names its default', () => {
  const fields = files.flatMap(optionalFields);
  expect(fields.length).toBeGreaterThan(150);
  expectNone(
    'Say it in the docstring as “Default …”:',
    fields.filter(({ doc }) => !/\b[Dd]efault/.test(doc)).map(({ where }) => where),
  );
});
