import { expect, it } from 'vitest';
import type { LocalStore } from './local-store.ts';
import { Preferences } from './preferences.ts';

function store(text: string | null = null): LocalStore {
  let kept = text;
  return {
    getItem: () => kept,
    setItem(_, value) {
      kept = value;
    },
  };
}

it('is what the system asks for until somebody chooses, and remembers the choice', () => {
  const kept = store();
  const first = new Preferences(true, kept);
  expect([first.reducedMotion, first.safeColors]).toEqual([true, false]);
  first.set({ reducedMotion: false });
  first.set({ safeColors: true });
  expect([first.reducedMotion, first.safeColors]).toEqual([false, true]);
  const later = new Preferences(true, kept);
  expect([later.reducedMotion, later.safeColors]).toEqual([false, true]);
});

it('follows the system while nobody has chosen, another choice notwithstanding', () => {
  const kept = store();
  const preferences = new Preferences(false, kept);
  expect([preferences.follow(true), preferences.follow(true), preferences.reducedMotion]).toEqual([true, false, true]);
  preferences.set({ safeColors: true });
  expect([preferences.follow(false), preferences.reducedMotion]).toEqual([true, false]);
  expect(new Preferences(true, kept).reducedMotion).toBe(true);
  preferences.set({ reducedMotion: true });
  expect([preferences.follow(false), preferences.reducedMotion]).toEqual([false, true]);
});

it('survives whatever is in the store, and a store that refuses', () => {
  for (const text of ['', '{', 'null', '[1]', '{"reducedMotion":"yes"}']) {
    expect(new Preferences(false, store(text)).reducedMotion).toBe(false);
  }
  const closed: LocalStore = {
    getItem: () => {
      throw new Error('no');
    },
    setItem: () => {
      throw new Error('no');
    },
  };
  for (const kept of [closed, undefined]) {
    const preferences = new Preferences(false, kept);
    preferences.set({ reducedMotion: true });
    expect(preferences.reducedMotion).toBe(true);
  }
});
