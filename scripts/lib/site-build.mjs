/** The games as a static site: files that any web server serves from any folder, with no other address in them. */
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, relative } from 'node:path';
import { build } from 'esbuild';
import { WORDS_BY_LANGUAGE } from '../../games/front-page/words.mjs';
import { scriptsByGame, startSooner } from './first-scripts.mjs';
import { serviceWorker, withServiceWorker } from './service-worker.mjs';
import { frontPageOptions, siteBundles } from './site-bundle.mjs';
import { siteAddress, siteFolder } from './site-folder.mjs';
import { frontPage, gameNames, gamePage, gamePicture, withPreview } from './site-pages.mjs';

/** Browsers run no modules that lie in a folder without a server: then the page says what to do. */
const fromDisk = `<script>
if (location.protocol === 'file:') {
  addEventListener('DOMContentLoaded', function () {
    var note = document.createElement('p');
    note.setAttribute('role', 'alert');
    note.style.cssText = 'position:fixed;left:0;right:0;bottom:0;margin:0;padding:14px 18px;background:#30142b;color:#ffdfe3;font:15px/1.5 system-ui,sans-serif;z-index:9';
    note.textContent = /^de/i.test(navigator.language) ? ${JSON.stringify(WORDS_BY_LANGUAGE.de.fromDisk)} : ${JSON.stringify(WORDS_BY_LANGUAGE.en.fromDisk)};
    document.body.appendChild(note);
  });
}
</script>`;

/**
 * Writes the site. What was in the folder goes, once everything has been built: a build that fails leaves a former site.
 * @param {string} out folder, new, empty or with a former site
 * @param {string} [address] at which the site will be, for previews of links
 * @returns {Promise<number>} how many games it has
 * @throws Error if the folder holds anything else, or the address is none
 */
export async function writeSite(out, address) {
  const folder = siteFolder(out);
  const site = address === undefined ? undefined : siteAddress(address);
  const names = gameNames();
  const options = { outdir: folder, write: false };
  const bundles = siteBundles({ ...options, minify: true, conditions: ['principia-source', 'production'] });
  const built = await Promise.all(bundles.map((bundle) => build(bundle)));
  const ownFront = await build(frontPageOptions(options));
  const files = Object.fromEntries(
    [...built, ownFront]
      .flatMap(({ outputFiles = [] }) => outputFiles)
      .map(({ path, contents }) => [relative(folder, path).replaceAll('\\', '/'), contents]),
  );
  Object.assign(files, pagesOf(names, site, scriptsByGame(built.map(({ metafile }) => metafile))));
  // The worker lists the files, so that what a build left that was ended here is known as a site.
  const worker = serviceWorker(files);
  rmSync(folder, { recursive: true, force: true });
  for (const [name, content] of [['sw.js', worker], ...Object.entries(files)]) {
    const path = `${folder}/${name}`;
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, content);
  }
  return names.length;
}

/**
 * The pages and pictures, by their paths in the site.
 * @param {readonly string[]} names of the games
 * @param {string | undefined} site
 * @param {ReturnType<typeof scriptsByGame>} scripts
 */
function pagesOf(names, site, scripts) {
  const first = names.find((name) => gamePicture(name));
  const front = withPreview(frontPage(), { site, picture: first && `${first}/picture.webp` });
  /** @type {Record<string, string | Uint8Array>} */
  const files = { 'index.html': withServiceWorker(withNote(front), './sw.js') };
  for (const name of names) {
    const picture = gamePicture(name);
    const place = { site, path: `${name}/`, picture: picture && `${name}/picture.webp` };
    const page = withPreview(startSooner(gamePage(name), scripts(name)), place);
    files[`${name}/index.html`] = withServiceWorker(withNote(page), '../sw.js');
    if (picture) files[`${name}/picture.webp`] = picture;
  }
  return files;
}

/** @param {string} html */
function withNote(html) {
  return html.replace('</head>', `${fromDisk}\n</head>`);
}
