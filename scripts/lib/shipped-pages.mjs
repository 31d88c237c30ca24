/** The pages of `docs` as a package ships them: comments in its declarations name them. */
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { posix } from 'node:path';
import { root } from './paths.mjs';

const REPOSITORY = 'https://github.com/principia-physics/principia';

/** Names of the pages, such as `step.md`; pictures are not among them. */
export const shippedPages = readdirSync(`${root}/docs`).filter((name) => name.endsWith('.md'));

/**
 * Writes the pages into a folder, which holds nothing else afterwards.
 * @param {string} folder
 */
export function shipPages(folder) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  for (const name of shippedPages) {
    writeFileSync(`${folder}/${name}`, shippedPage(readFileSync(`${root}/docs/${name}`, 'utf8')));
  }
}

/**
 * A page whose links to pictures, and to all that is outside of `docs`, lead to the repository. Those to other pages stay.
 * @param {string} markdown of a page of `docs`
 */
export function shippedPage(markdown) {
  return markdown.replace(/(!?\[[^\]]*)\]\(([^)\s#]+)/g, (link, text, path) => {
    const target = posix.join('docs', path);
    // What only looks like a link, such as code, leads to no file.
    if (/^https?:/.test(path) || shippedPages.includes(path) || !existsSync(`${root}/${target}`)) return link;
    const kind = text.startsWith('!') ? 'raw' : statSync(`${root}/${target}`).isDirectory() ? 'tree' : 'blob';
    return `${text}](${REPOSITORY}/${kind}/main/${target}`;
  });
}
