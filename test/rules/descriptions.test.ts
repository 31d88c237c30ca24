// Editors show what stands above a declaration: whatever a package exports is described there, before any tag.
import { relative } from 'node:path/posix';
import { expect, test } from 'vitest';
import { packageNames, sourcesByImport } from '../../scripts/lib/packages.mjs';
import { root } from '../../scripts/lib/paths.mjs';
import { expectNone, type Node, parse, resolveImport } from './sources.ts';

type Named = { readonly name: string };
type Specifier = Node & { readonly local: Named; readonly exported?: Named; readonly imported?: Named };

interface Declared {
  readonly path: string;
  readonly start: number;
}

const indexes = packageNames.flatMap(sourcesByImport).map(([, source]) => relative(root, source));

/** Where a module declares a name, or what it exports by that, through any modules that hand it on. */
function declarationOf(path: string, name: string): Declared | undefined {
  for (const node of statementsOf(path)) {
    for (const specifier of specifiersOf(node)) {
      const [here, there] =
        node.type === 'ImportDeclaration'
          ? [specifier.local, specifier.imported]
          : [specifier.exported, specifier.local];
      const from = sourceOf(path, node);
      const isElsewhere = from !== path || there?.name !== name;
      if (here?.name === name && there !== undefined && isElsewhere) return declarationOf(from, there.name);
    }
    if (namesOf((node.declaration ?? node) as Node).includes(name)) return { path, start: node.start };
  }
  return undefined;
}

function statementsOf(path: string): readonly Node[] {
  return parse(path).tree.body as Node[];
}

function specifiersOf(node: Node): readonly Specifier[] {
  return (node.specifiers ?? []) as Specifier[];
}

function sourceOf(path: string, node: Node): string {
  const source = node.source as { value: string } | null | undefined;
  return source ? (resolveImport(path, source.value) ?? path) : path;
}

function namesOf(node: Node): readonly string[] {
  const declared = node.type === 'VariableDeclaration' ? (node.declarations as Node[]) : [node];
  return declared.map(({ id }) => (id as { name?: string } | null | undefined)?.name ?? '');
}

/** What the comment above a declaration says before its first tag. */
function descriptionOf({ path, start }: Declared): string {
  const above = parse(path).text.slice(0, start).trimEnd();
  if (!above.endsWith('*/')) return '';
  const comment = above.slice(above.lastIndexOf('/**') + 3, -2);
  return comment
    .replaceAll(/^\s*\* ?/gm, '')
    .split(/^\s*@/m)[0]
    .trim();
}

const exported = indexes.flatMap((path) =>
  statementsOf(path).flatMap((node) =>
    specifiersOf(node).map(({ exported: name, local }) => ({
      name: `${path}: ${name?.name}`,
      declared: declarationOf(sourceOf(path, node), local.name),
    })),
  ),
);

test('the declaration of every export is found', () => {
  expect(exported.length).toBeGreaterThan(600);
  expect(exported.filter(({ declared }) => declared === undefined).map(({ name }) => name)).toEqual([]);
});

test('whatever a package exports is described', () => {
  const violations = exported
    .filter(({ declared }) => declared !== undefined && descriptionOf(declared).length < 10)
    .map(({ name }) => name);
  expectNone('Say above the declaration what it is or does, a force with its formula and units:', violations);
});
