// Files that a page of the documentation shows, as they stand there: written to a folder of their own, in which they stand
// in the repository as far as their imports go.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { build, type Plugin } from 'esbuild';

/** The files of a page. */
export interface PageFiles {
  /** The page's text. */
  readonly page: string;
  /** The folder they were written to. */
  readonly copy: string;
  readonly files: readonly { readonly path: string; readonly code: string }[];
}

/** Writes the blocks of a page that begin with the path of a file. */
export function writeFilesOf(name: string): PageFiles {
  const page = readFileSync(`docs/${name}.md`, 'utf8');
  const copy = resolve('node_modules/.cache/principia', name);
  const blocks = page.matchAll(/^ *```\w+\n( *)\/\/ (packages\/\S+)\n([\s\S]*?)^ *```$/gm);
  const files = [...blocks].map(([, indent, path, code]) => ({
    path,
    code: code.replaceAll(new RegExp(`^${indent}`, 'gm'), ''),
  }));
  rmSync(copy, { recursive: true, force: true });
  for (const { path, code } of files) {
    mkdirSync(dirname(`${copy}/${path}`), { recursive: true });
    writeFileSync(`${copy}/${path}`, code);
  }
  return { page, copy, files };
}

/** Checks the files with the strict compiler, and returns its errors. */
export function typeErrorsOf({ copy, files }: PageFiles): string {
  const tsconfig = {
    extends: resolve('tsconfig.json'),
    compilerOptions: { rootDirs: [copy, resolve('.')], typeRoots: [resolve('node_modules/@types')] },
    include: files.map(({ path }) => path),
  };
  writeFileSync(`${copy}/tsconfig.json`, JSON.stringify(tsconfig));
  try {
    return execFileSync(process.execPath, ['node_modules/typescript/bin/tsc', '-p', copy], { encoding: 'utf8' });
  } catch (error) {
    return (error as { stdout: string }).stdout;
  }
}

/**
 * Bundles a module that imports the files, and imports it.
 * @param code its source, in which `COPY` stands for the folder of the files
 * @param aliases absolute paths of modules by the names in imports
 */
export async function importBundled(
  { copy }: PageFiles,
  code: string,
  aliases: Readonly<Record<string, string>> = {},
): Promise<Record<string, unknown>> {
  const entry = `${copy}/all.ts`;
  writeFileSync(entry, code.replaceAll('COPY', copy));
  const outfile = `${copy}/all.mjs`;
  await build({
    entryPoints: [entry],
    outfile,
    bundle: true,
    format: 'esm',
    platform: 'node',
    conditions: ['principia-source'],
    alias: aliases,
    plugins: [inRepository(copy)],
    logLevel: 'silent',
  });
  return (await import(outfile)) as Record<string, unknown>;
}

function inRepository(copy: string): Plugin {
  return {
    name: 'in-repository',
    setup({ onResolve }) {
      onResolve({ filter: /^\./ }, ({ path, importer }) => {
        if (!importer.startsWith(copy) || existsSync(resolve(dirname(importer), path))) return undefined;
        return { path: resolve(dirname(importer).slice(copy.length + 1), path) };
      });
    },
  };
}
