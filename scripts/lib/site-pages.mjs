/** The pages of the games site: which games exist, their HTML, and the list that leads to them. */
import { existsSync, readdirSync, readFileSync } from 'node:fs';
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
 * The picture of a game on the front page, if its author has put one there.
 * @param {string} name
 */
export function gamePicture(name) {
  const file = `${gamesFolder}/${name}/picture.png`;
  return existsSync(file) ? readFileSync(file) : undefined;
}

/** The front page: `games/index.html`, or a plain one; the list of games takes the place of `<!-- games -->`. */
export function frontPage() {
  const file = `${gamesFolder}/index.html`;
  const template = existsSync(file) ? readFileSync(file, 'utf8') : plainFrontPage;
  const items = gameNames().map((name) => {
    const html = gamePage(name);
    const title = html.match(/<title>([^<]*)<\/title>/i)?.[1].trim() || name;
    const about = html.match(/<meta\s+name="description"\s+content="([^"]*)"/i)?.[1];
    const picture = gamePicture(name)
      ? `<img src="./${name}/picture.png" alt="" width="880" height="550" decoding="async">`
      : '';
    const address = `./${name}/index.html`;
    return `<li><a href="${address}">${picture}<b>${title}</b></a>${about ? ` <span>${about}</span>` : ''}</li>`;
  });
  const list = items.length > 0 ? `<ul class="games">\n${items.join('\n')}\n</ul>` : '<p>There is no game yet.</p>';
  return template.replace('<!-- games -->', list);
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
