/** The part of `localStorage` that is needed. */
export type LocalStore = Pick<Storage, 'getItem' | 'setItem'>;

/** The browser's store; undefined in browsers that throw at the mere mention where pages may keep nothing. */
export function browserStore(): LocalStore | undefined {
  try {
    return globalThis.localStorage;
  } catch {
    return undefined;
  }
}

/** What is kept under a name; undefined where there is nothing, or what somebody else wrote there. */
export function readLocal(store: LocalStore | undefined, name: string): unknown {
  try {
    return JSON.parse(store?.getItem(name) ?? 'null') ?? undefined;
  } catch {
    return undefined;
  }
}

/** Keeps a value; where the store is full or closed to us it lasts as long as the page. */
export function writeLocal(store: LocalStore | undefined, name: string, value: unknown): void {
  try {
    store?.setItem(name, JSON.stringify(value));
  } catch {
    // Nothing the player could do about it, and nothing is lost now.
  }
}
