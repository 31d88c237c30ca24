import { expect, test } from 'vitest';
import { packageImports, physicsLayers, simulationImports, typesForAll } from './layers.ts';
import { expectNone, importsOf, isTest, resolveImport, typescriptFiles } from './sources.ts';

const librarySources = typescriptFiles.filter((path) => /^packages\/[^/]+\/src\//.test(path) && !isTest(path));
const physics = 'packages/physics/src/';

test('there are sources to judge', () => {
  expect(librarySources.length).toBeGreaterThan(10);
});

test('packages import only the packages below them', () => {
  const violations = librarySources.flatMap((path) => {
    const name = path.split('/')[1];
    const allowed = packageImports[name];
    if (!allowed) return [`${path}: the package ${name} has no line in test/rules/layers.ts`];
    return foreignImports(path, `packages/${name}/src/`, allowed);
  });
  expectNone('Packages import each other one way only, by name (test/rules/layers.ts):', violations);
});

test('a game’s sim.ts reaches no renderer', () => {
  const simulations = typescriptFiles.filter((path) => /^games\/[^/]+\/sim\.ts$/.test(path));
  const violations = withOwnImports(simulations).flatMap((path) => foreignImports(path, 'games/', simulationImports));
  expectNone('A sim.ts runs without a screen, so it imports physics and scenes only:', violations);
});

test('games do not reach into each other or into packages', () => {
  const games = typescriptFiles.filter((path) => /^games\/[^/]+\//.test(path));
  const violations = games.flatMap((path) => {
    const own = path.split('/').slice(0, 2).join('/');
    return importsOf(path)
      .filter(({ source }) => source.startsWith('.'))
      .filter(({ source }) => !/^games\/shared\//.test(`${resolveImport(path, source)}`))
      .filter(({ source }) => !resolveImport(path, source)?.startsWith(`${own}/`))
      .map(({ source, line }) => `${path}:${line} imports ${source}`);
  });
  expectNone('A game imports its own files, games/shared, and packages by name:', violations);
});

test('folders of the physics package import only those above them', () => {
  const violations = librarySources
    .filter((path) => path.startsWith(physics))
    .flatMap((path) => importsOf(path).map((item) => upwardImport(path, item)))
    .filter((violation) => violation !== undefined);
  expectNone('Physics follows the order in test/rules/layers.ts:', violations);
});

test('nothing inside a package imports its index.ts', () => {
  const violations = typescriptFiles
    .filter((path) => /^packages\/[^/]+\/src\//.test(path))
    .flatMap((path) => {
      const index = path.replace(/\/src\/.*/, '/src/index.ts');
      const own = importsOf(path).filter(({ source }) => resolveImport(path, source) === index);
      return own.filter(() => !isTest(path)).map(({ line }) => `${path}:${line} imports its own index.ts`);
    });
  expectNone('index.ts is for users of the package; import the file that defines the thing:', violations);
});

test('relative imports carry their extension', () => {
  const violations = typescriptFiles
    .filter((path) => !/(^|\/)kernels\//.test(path) || isTest(path) || path.startsWith('packages/physics/src/'))
    .flatMap((path) => importsOf(path).map((item) => ({ path, ...item })))
    .filter(({ source }) => /^\.{1,2}\//.test(source) && !/\.(ts|mjs|js|json)$/.test(source))
    .map(({ path, source, line }) => `${path}:${line} imports ${source}`);
  expectNone('Node and strict resolvers find `./name.ts`, not `./name`:', violations);
});

test('no import cycles, types included', () => {
  const graph = new Map<string, string[]>();
  for (const path of librarySources) {
    const targets = importsOf(path).map(({ source }) => resolveImport(path, source));
    graph.set(
      path,
      targets.filter((target) => target !== undefined),
    );
  }
  expectNone('Files that import each other, be it for a type, cannot be read one after the other:', cycles(graph));
});

/** The files, and every file of a game that they import directly or through others. */
function withOwnImports(paths: readonly string[]): string[] {
  const reached = new Set(paths);
  for (const path of reached) {
    const targets = importsOf(path).map(({ source }) => resolveImport(path, source));
    for (const target of targets) if (target?.startsWith('games/')) reached.add(target);
  }
  return [...reached];
}

/** Imports that leave `home`, except the `allowed` packages and their sub-paths. */
function foreignImports(path: string, home: string, allowed: readonly string[]): string[] {
  return importsOf(path)
    .filter(({ source }) => !allowed.some((name) => source === name || source.startsWith(`${name}/`)))
    .filter(({ source }) => !(/^[.#]/.test(source) && resolveImport(path, source)?.startsWith(home)))
    .map(({ source, line }) => `${path}:${line} imports ${source}; allowed are ${allowed.join(', ')}`);
}

function upwardImport(path: string, { source, typeOnly, line }: ReturnType<typeof importsOf>[number]) {
  const target = resolveImport(path, source);
  if (!target?.startsWith(physics)) return undefined;
  const [from, to] = [path, target].map((file) => layerOf(file.slice(physics.length)));
  const [own, other] = [from, to].map((layer) => physicsLayers.indexOf(layer));
  if (own < 0) return `${path}: ${from} has no line in test/rules/layers.ts`;
  if (other < 0) return `${path}:${line} imports ${source}: ${to} has no line in test/rules/layers.ts`;
  if (other <= own || (typeOnly && typesForAll.includes(target.slice(physics.length)))) return undefined;
  return `${path}:${line} imports ${source}, but ${to} comes after ${from}`;
}

/** The longest line of the list that the file, or a folder that it is in, has. */
function layerOf(file: string): string {
  const candidates = physicsLayers.filter((layer) => file === layer || file.startsWith(`${layer}/`));
  return candidates.sort((a, b) => b.length - a.length)[0] ?? file.split('/')[0];
}

/** One closed path for each loop found by walking the graph depth first. */
function cycles(graph: ReadonlyMap<string, readonly string[]>): string[] {
  const found: string[] = [];
  const done = new Set<string>();
  const trail: string[] = [];
  const visit = (path: string): void => {
    const start = trail.indexOf(path);
    if (start >= 0) found.push([...trail.slice(start), path].join(' → '));
    if (start >= 0 || done.has(path)) return;
    trail.push(path);
    for (const target of graph.get(path) ?? []) visit(target);
    trail.pop();
    done.add(path);
  };
  for (const path of graph.keys()) visit(path);
  return found;
}
