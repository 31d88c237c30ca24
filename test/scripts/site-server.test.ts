import { expect, test } from 'vitest';
import { serveSite } from '../../scripts/lib/site-server.mjs';

test('a page that is opened before the first build is told so, and then that there is something to play', async () => {
  const server = await serveSite({ ports: [0], host: '127.0.0.1' });
  try {
    const live = await fetch(new URL('/live', server.url));
    const events = (live.body as ReadableStream<Uint8Array>).getReader();
    const next = async () => {
      const { value } = await events.read();
      return JSON.parse(new TextDecoder().decode(value).slice('data: '.length));
    };
    expect(await next()).toEqual({ version: 0, news: expect.stringContaining('being built') });
    expect(await next()).toEqual({ version: expect.any(Number), problem: '' });
    expect((await fetch(new URL('/black-hole/main.js', server.url))).status).toBe(200);
    await events.cancel();
  } finally {
    await server.close();
  }
});
