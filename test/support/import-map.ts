/** The page with an import map that docs/in-your-own-project.md shows. */

/** The HTML block of the page. */
export function htmlOf(page: string): string {
  const [, html] = /```html\n([\s\S]*?)```/.exec(page) ?? [];
  if (html === undefined) throw new Error('The page shows no HTML.');
  return html;
}

/** Names and addresses of the import map in that block. */
export function importMapOf(page: string): Readonly<Record<string, string>> {
  const [, json] = /<script type="importmap">([\s\S]*?)<\/script>/.exec(htmlOf(page)) ?? [];
  if (json === undefined) throw new Error('The page shows no import map.');
  return JSON.parse(json).imports;
}

/** What the page adds to the map to draw with `renderer`: `render-pixi` or `render-three`. */
export function drawingMapOf(page: string, renderer: string): Readonly<Record<string, string>> {
  const blocks = [...page.matchAll(/```json\n([\s\S]*?)```/g)].map(([, json]) => json as string);
  const json = blocks.find((each) => each.includes(`"@principia/${renderer}"`));
  if (json === undefined) throw new Error(`The page shows no map for ${renderer}.`);
  return JSON.parse(json);
}
