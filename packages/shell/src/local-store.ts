import { isPreview } from './preview.ts';

/** The methods of `localStorage` that are used. */
export type LocalStore = Pick<Storage, 'getItem' | 'setItem'>;

/** The browser's storage; undefined where merely accessing it throws because storage is blocked. */
export function browserStore(): LocalStore | undefined {
  try {
    return globalThis.localStorage;
  } catch {
    return undefined;
  }
}

/** Reads a stored value; undefined if there is none or if it is not valid JSON. */
export function readLocal(store: LocalStore | undefined, name: string): unknown {
  try {
    return JSON.parse(store?.getItem(name) ?? 'null') ?? undefined;
  } catch {
    return undefined;
  }
}

/**
 * Stores a value; where the storage is full or blocked, and in a preview, the value lasts as long as the page.
 * @returns whether it was stored
 */
export function writeLocal(store: LocalStore | undefined, name: string, value: unknown): boolean {
  if (isPreview || store === undefined) return false;
  try {
    store.setItem(name, JSON.stringify(value));
    return true;
  } catch {
    // The player cannot change this, and the running page keeps the value.
    return false;
  }
}
