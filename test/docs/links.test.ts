// Links between pages of the repository lead to files, and to headings, that exist.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { posix } from 'node:path';
import { expect, test } from 'vitest';
import { packageNames } from '../../scripts/lib/packages.mjs';

const pages = [
  'README.md',
  'CONTRIBUTING.md',
  'CHANGELOG.md',
  ...readdirSync('docs')
    .filter((name) => name.endsWith('.md'))
    .map((name) => `docs/${name}`),
  ...packageNames.map((name) => `packages/${name}/README.md`),
];

/** Pages that npm shows, too, lead to others by the address of the repository: nothing else of it is in a package. */
const REPOSITORY = /^https:\/\/github\.com\/principia-physics\/principia\/(?:blob|tree)\/main\//;

/** The file that a link of a page leads to, undefined for one that leaves the repository. */
function targetOf(page: string, link: string): string | undefined {
  if (REPOSITORY.test(link)) return link.replace(REPOSITORY, '');
  if (/^https?:/.test(link)) return undefined;
  return link === '' ? page : posix.join(posix.dirname(page), link);
}

/** The anchors that a page has for its headings, by GitHub's rules. */
function anchorsOf(path: string): string[] {
  const text = readFileSync(path, 'utf8').replaceAll(/```[\s\S]*?```/g, '');
  return [...text.matchAll(/^#+ (.*)$/gm)].map(([, title]) =>
    title
      .toLowerCase()
      .replaceAll(/[^\p{L}\p{N} _-]/gu, '')
      .replaceAll(' ', '-'),
  );
}

test.each(pages)('links of %s lead somewhere', (page) => {
  const text = readFileSync(page, 'utf8').replaceAll(/```[\s\S]*?```/g, '');
  const links = [...text.matchAll(/\]\(([^)\s#]*)(?:#([^)]*))?\)/g)];
  for (const [link, path = '', anchor] of links) {
    const target = targetOf(page, path);
    if (target === undefined) continue;
    expect(existsSync(target), `${page}: ${link}`).toBe(true);
    if (anchor !== undefined) expect(anchorsOf(target), `${page}: ${link}`).toContain(anchor);
  }
});

test.each(packageNames)(
  'the front page of %s leads to the repository, and not to pages that are not in a package',
  (name) => {
    const links = [...readFileSync(`packages/${name}/README.md`, 'utf8').matchAll(/\]\(([^)]*)\)/g)].map(
      ([, link]) => link,
    );
    expect(links.filter((link = '') => REPOSITORY.test(link)).length).toBeGreaterThan(2);
    expect(links.filter((link = '') => !link.startsWith('https://'))).toEqual([]);
  },
);
