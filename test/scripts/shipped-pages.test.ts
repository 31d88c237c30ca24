import { existsSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { shippedPage, shippedPages } from '../../scripts/lib/shipped-pages.mjs';

const repository = 'https://github.com/principia-physics/principia';

test('pages lead to each other as before, and to pictures and files of the repository by its address', () => {
  const page = [
    '[the step](step.md#events) and [a picture below](#here), [pixi](https://pixijs.com)',
    '![Errors](images/integrators.svg)',
    '[the source](../packages/scenes/src/examples/ch17/water.ts), [the game](../games/laboratory)',
    '`list[0](value)`',
  ];
  expect(shippedPage(page.join('\n')).split('\n')).toEqual([
    page[0],
    `![Errors](${repository}/raw/main/docs/images/integrators.svg)`,
    `[the source](${repository}/blob/main/packages/scenes/src/examples/ch17/water.ts), ` +
      `[the game](${repository}/tree/main/games/laboratory)`,
    page[3],
  ]);
});

test.each(shippedPages)('%s leads to nothing that is not in the package', (name) => {
  const text = shippedPage(readFileSync(`docs/${name}`, 'utf8')).replaceAll(/```[\s\S]*?```|`[^`\n]*`/g, '');
  const links = [...text.matchAll(/\]\(([^)\s#]+)/g)].map(([, path]) => path as string);
  expect(links.filter((path) => !path.startsWith('https://') && !shippedPages.includes(path))).toEqual([]);
  const ours = links.filter((path) => path.startsWith(`${repository}/`));
  const files = ours.map((path) => path.slice(repository.length).replace(/^\/(blob|tree|raw)\/main\//, ''));
  expect(files.filter((file) => !existsSync(file))).toEqual([]);
});
