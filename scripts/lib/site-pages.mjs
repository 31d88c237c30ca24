/** The pages of the games site: which games exist, their HTML, and the list that leads to them. */
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { WORDS_BY_LANGUAGE } from '../../games/front-page/words.mjs';
import { root } from './paths.mjs';

const gamesFolder = `${root}/games`;

/** Names of the folders `games/<name>` with a `main.ts`, in alphabetical order. */
export function gameNames() {
  if (!existsSync(gamesFolder)) return [];
  return readdirSync(gamesFolder, { withFileTypes: true })
    .filter((entry) => entry.isDirectory() && existsSync(`${gamesFolder}/${entry.name}/main.ts`))
    .map((entry) => entry.name)
    .sort();
}

/** The start page of the laboratory has no game of its own. @type {Record<string, string>} */
const EXAMPLE = { laboratory: '?example=ch17-diffusion&count=20000' };

/** The address on the site of a page that plays a game. @param {string} name */
export function gameAddress(name) {
  return `${name}/${EXAMPLE[name] ?? ''}`;
}

/**
 * The page of one game, as its author wrote it.
 * @param {string} name
 */
export function gamePage(name) {
  const file = `games/${name}/index.html`;
  if (!existsSync(`${root}/${file}`)) throw new Error(`${file} is missing: every game with a main.ts has a page.`);
  const html = readFileSync(`${root}/${file}`, 'utf8');
  if (!/src="(?:\.\/)?main\.js"/.test(html)) {
    throw new Error(`${file} does not load the game: add <script type="module" src="./main.js"></script>.`);
  }
  return html;
}

/**
 * The picture of a game on the front page, if its author has put one there: WebP, 560 by 350 pixels, 15 KB at most.
 * @param {string} name
 */
export function gamePicture(name) {
  const file = `${gamesFolder}/${name}/picture.webp`;
  return existsSync(file) ? readFileSync(file) : undefined;
}

/** Kinds of games, as in `<meta name="kind">`, in the order of the front page. */
const KINDS = /** @type {const} */ (['game', 'toy', 'lab']);

/** The front page: `games/index.html`; the lists of games by kind take the place of `<!-- games -->`. */
export function frontPage() {
  const file = `${gamesFolder}/index.html`;
  const template = existsSync(file) ? readFileSync(file, 'utf8') : plainFrontPage;
  const cards = gameNames().map((name) => ({ kind: metaOf(gamePage(name), 'kind') ?? 'toy', card: cardOf(name) }));
  const sections = KINDS.map((kind) => {
    const own = cards.filter((each) => each.kind === kind || (kind === 'toy' && !KINDS.some((k) => k === each.kind)));
    const list = own.map(({ card }) => card).join('\n');
    const heading = `<h2 data-de="{{de.${kind}}}">{{${kind}}}</h2>`;
    return own.length === 0 ? '' : `<section>${heading}\n<ul class="games">\n${list}\n</ul></section>`;
  });
  const list = cards.length > 0 ? sections.join('\n') : '<p data-de="{{de.none}}">{{none}}</p>';
  return withWords(template.replace('<!-- games -->', list));
}

/**
 * A page with its words: `{{lead}}` is one in English, and `{{de.lead}}` the same in German, for an attribute.
 * @param {string} template
 */
function withWords(template) {
  const { en, de } = WORDS_BY_LANGUAGE;
  return template.replace(/\{\{(de\.)?(\w+)\}\}/g, (found, german, name) => {
    if (!Object.hasOwn(en, name)) throw new Error(`games/front-page/words.mjs has no words for ${found}.`);
    const word = /** @type {keyof typeof en} */ (name);
    return german ? attribute(de[word]) : en[word];
  });
}

/** @param {string} text */
function attribute(text) {
  return text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');
}

/** @param {string} name */
function cardOf(name) {
  const html = gamePage(name);
  const about = metaOf(html, 'description');
  // Addresses and attributes of a page are already written as HTML.
  const live = metaOf(html, 'live');
  const picture = gamePicture(name)
    ? `<img src="./${name}/picture.webp" alt="" width="560" height="350" decoding="async" loading="lazy">`
    : '';
  const address = `./${name}/index.html`;
  const [title, german] = [titleOf(html) ?? name, metaOf(html, 'description', 'de')];
  const heading = `<b${inGerman(metaOf(html, 'title', 'de'))}>${title}</b>`;
  const liveAddress = live === undefined ? '' : ` data-live="${address}?${live}"`;
  return `<li${liveAddress}><a href="${address}">${picture}${heading}</a>${about ? ` <span${inGerman(german)}>${about}</span>` : ''}</li>`;
}

/** @param {string | undefined} text as it stands in another attribute; undefined where a game has none */
function inGerman(text) {
  return text === undefined ? ' lang="en"' : ` data-de="${text}"`;
}

/** @param {string} html */
function titleOf(html) {
  return html.match(/<title[^>]*>([^<]*)<\/title>/i)?.[1].trim() || undefined;
}

/**
 * @param {string} html
 * @param {string} name
 * @param {string} [language] of a translation
 */
function metaOf(html, name, language) {
  const lang = language === undefined ? '' : `lang="${language}"\\s+`;
  return html.match(new RegExp(`<meta\\s+name="${name}"\\s+${lang}content="([^"]*)"`, 'i'))?.[1];
}

/**
 * A page with Open Graph tags (ogp.me), from which networks make a preview of a link. Pictures in them need a whole
 * address, so there is one only where the address of the site is known.
 * @param {string} html
 * @param {{ site?: string | undefined, path?: string, picture?: string | undefined }} place address of the site, and what lies where below it
 */
export function withPreview(html, { site, path = '', picture }) {
  const tags = [
    ['og:type', 'website'],
    ['og:title', titleOf(html) ?? 'Principia games'],
    ['og:description', metaOf(html, 'description') ?? ''],
    ...(site === undefined ? [] : [['og:url', new URL(path, site).href]]),
    ...(site === undefined || picture === undefined ? [] : [['og:image', new URL(picture, site).href]]),
  ];
  const lines = tags.map(([property, content]) => `<meta property="${property}" content="${content}">`);
  if (site !== undefined) lines.push('<meta name="twitter:card" content="summary_large_image">');
  return html.replace('</head>', `${lines.join('\n')}\n</head>`);
}

const plainFrontPage = `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Principia games</title>
<link rel="icon" href="data:,">
<style>
body { font: 1rem/1.6 system-ui, sans-serif; max-width: 42rem; margin: 3rem auto; padding: 0 1rem }
span { color: #666 }
img { display: block; max-width: 100% }
</style>
</head>
<body>
<h1>Principia games</h1>
<!-- games -->
</body>
</html>
`;
