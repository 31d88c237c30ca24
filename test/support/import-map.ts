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
