/** The reader's own version of an example: kept for this tab, and carried by links. */
import { packText, unpackText } from '@principia/shell';
import { WORDS } from './words.ts';

/** A version that the address carries, and the part of the address that names its moment. */
export interface LinkedCode {
  readonly source: string;
  readonly moment: string;
}

const keyOf = (id: string) => `laboratory-code:${id}`;

/** The version that the reader runs in this tab. */
export function ownCode(id: string): string | undefined {
  try {
    return sessionStorage.getItem(keyOf(id)) ?? undefined;
  } catch {
    // Browsers may refuse storage.
    return undefined;
  }
}

/** Keeps a version for this tab. @throws Error if the browser refuses storage */
export function keepOwnCode(id: string, source: string): void {
  try {
    sessionStorage.setItem(keyOf(id), source);
  } catch {
    throw new Error(WORDS.code.notKept);
  }
}

/** Removes the version of this tab, if there is one. */
export function forgetOwnCode(id: string): void {
  try {
    sessionStorage.removeItem(keyOf(id));
  } catch {
    // A browser that refuses storage keeps nothing.
  }
}

/** The address of the present page, with a version of its example. */
export async function linkWith(source: string): Promise<string> {
  const address = new URL(location.href);
  address.hash = await codeHash(source);
  return address.href;
}

/** What stands after the # of an address that carries a version. */
export async function codeHash(source: string): Promise<string> {
  return `code=${await packText(source)}`;
}

/**
 * The version that the address carries; it must not run before the reader has agreed.
 * @returns empty if what the address carries cannot be read
 */
export async function linkedCode(hash: string): Promise<string | undefined> {
  const text = new URLSearchParams(hash.replace(/^#/, '')).get('code');
  if (text === null) return undefined;
  try {
    return await unpackText(text);
  } catch {
    return '';
  }
}
