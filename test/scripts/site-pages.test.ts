/** Previews of links, which networks make from the head of a page. */
import { expect, it } from 'vitest';
import { gameNames, gamePage, gamePicture, withPreview } from '../../scripts/lib/site-pages.mjs';

const tagsOf = (html: string) =>
  Object.fromEntries(
    [...html.matchAll(/<meta property="og:(\w+)" content="([^"]*)">/g)].map(([, name, text]) => [name, text]),
  );

it.each(gameNames())('a link to %s has a preview with its title, sentence and picture', (name) => {
  const place = { site: 'https://example.org/games/', path: `${name}/index.html`, picture: `${name}/picture.webp` };
  const tags = tagsOf(withPreview(gamePage(name), place));
  expect(tags).toMatchObject({
    type: 'website',
    url: `https://example.org/games/${name}/index.html`,
    image: `https://example.org/games/${name}/picture.webp`,
  });
  expect(tags.title).not.toBe('Principia games');
  expect(tags.description.length).toBeGreaterThan(20);
  expect(gamePicture(name)?.length).toBeLessThanOrEqual(15 * 1024);
});

it('has no picture where the address of the site is unknown, as networks need a whole address', () => {
  const html = withPreview(gamePage(gameNames()[0]), { picture: 'picture.webp' });
  expect(tagsOf(html)).not.toHaveProperty('image');
  expect(html).not.toContain('twitter:card');
});
