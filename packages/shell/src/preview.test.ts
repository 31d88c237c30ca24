import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
  vi.resetModules();
});

/** The module as a page with this address has it. */
async function previewAt(search: string) {
  vi.stubGlobal('location', { search });
  return import('./preview.ts');
}

describe('a preview', () => {
  it('is asked for in the address', async () => {
    expect((await previewAt('?wind=4')).isPreview).toBe(false);
    vi.resetModules();
    expect((await previewAt('?wind=4&preview')).isPreview).toBe(true);
  });

  it('plays again some time after the end, once', async () => {
    const { restartAtEnd } = await previewAt('?preview');
    const again = vi.fn();
    const card = restartAtEnd(again);
    const passes = (seconds: number, outcome?: object) => {
      for (let i = 0; i < 10 * seconds; i++) {
        card.show(outcome);
        vi.advanceTimersByTime(100);
      }
    };
    passes(5);
    expect(again).not.toHaveBeenCalled();
    passes(5, {});
    expect(again).toHaveBeenCalledTimes(1);
    passes(1);
    passes(3, {});
    expect(again).toHaveBeenCalledTimes(2);
  });

  it('tells the page around it, and presses the buttons that there are, until the game begins anew', async () => {
    const { startPreview, PICTURE_READY } = await previewAt('?preview=right,jump');
    const postMessage = vi.fn();
    vi.stubGlobal('window', {});
    vi.stubGlobal('parent', { postMessage });
    const done: string[] = [];
    const controls = {
      buttons: { right: { label: '', keys: [] } },
      press: (sim: string, name: string) => void done.push(`${sim} ${name}`),
      release: (_: string, name: string) => void done.push(`no ${name}`),
    };
    startPreview(
      controls,
      () => 'boat',
      () => void done.push('again'),
    );
    expect(postMessage).toHaveBeenCalledWith(PICTURE_READY, '*');
    vi.advanceTimersByTime(24_000);
    const once = ['boat right', 'no right'];
    expect(done).toEqual([...once, ...once, ...once, ...once, ...once, 'again', 'boat right']);
  });
});
