/** The games as a static site: files that any web server serves from any folder, with no other address in them. */
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { build } from 'esbuild';
import { WORDS_BY_LANGUAGE } from '../../games/front-page/words.mjs';
import { scriptsByGame, startSooner } from './first-scripts.mjs';
import { serviceWorker, withServiceWorker } from './service-worker.mjs';
import { frontPageOptions, siteBundles } from './site-bundle.mjs';
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
 * Writes the site; what was in the folder goes.
 * @param {string} folder
 * @param {string} [site] the address at which the site will be, for previews of links
 * @returns {Promise<number>} how many games it has
 */
export async function writeSite(folder, site) {
  const names = gameNames();
  rmSync(folder, { recursive: true, force: true });
  const bundles = siteBundles({ minify: true, outdir: folder, conditions: ['principia-source', 'production'] });
  const built = await Promise.all(bundles.map((bundle) => build(bundle)));
  await build(frontPageOptions({ outdir: folder }));
  const scripts = scriptsByGame(built.map(({ metafile }) => metafile));
  mkdirSync(folder, { recursive: true });
  const first = names.find((name) => gamePicture(name));
  const front = withPreview(frontPage(), { site, picture: first && `${first}/picture.webp` });
  writeFileSync(`${folder}/index.html`, withServiceWorker(withNote(front), './sw.js'));
  for (const name of names) {
    const picture = gamePicture(name);
    const place = { site, path: `${name}/`, picture: picture && `${name}/picture.webp` };
    const page = withPreview(startSooner(gamePage(name), scripts(name)), place);
    writeFileSync(`${folder}/${name}/index.html`, withServiceWorker(withNote(page), '../sw.js'));
    if (picture) writeFileSync(`${folder}/${name}/picture.webp`, picture);
  }
  writeFileSync(`${folder}/sw.js`, serviceWorker(folder));
  return names.length;
}

/** @param {string} html */
function withNote(html) {
  return html.replace('</head>', `${fromDisk}\n</head>`);
}
