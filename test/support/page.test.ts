import { expect, test } from 'vitest';
import { servePage } from './page.ts';

const entry = new URL('./fixtures/page-entry.ts', import.meta.url);

test('serves the page and its bundle with the headers of an isolated page', async () => {
  const served = await servePage(entry, { html: '<canvas id="stage"></canvas>' });
  try {
    const page = await fetch(served.url);
    expect(page.headers.get('cross-origin-opener-policy')).toBe('same-origin');
    expect(await page.text()).toContain('<canvas id="stage"></canvas><script type="module" src="./main.js">');
    const script = await fetch(`${served.url}main.js`);
    expect(script.headers.get('content-type')).toMatch(/javascript/);
    expect(await script.text()).toContain('crossOriginIsolated');
    expect((await fetch(`${served.url}missing.js`)).status).toBe(404);
  } finally {
    await served.close();
  }
  await expect(fetch(served.url)).rejects.toThrow();
});

test('a broken entry names the file and the line', async () => {
  await expect(servePage('test/support/fixtures/missing.ts')).rejects.toThrow(/missing\.ts/);
});
