import { withLanguage } from './language.ts';
import { words } from './words.ts';

/**
 * Puts a link into the clipboard, or into the address bar where the browser refuses.
 * @returns a sentence for the player
 */
export async function copyLink(link: string, what: string): Promise<string> {
  try {
    await navigator.clipboard.writeText(link);
    return words().linkCopied(what);
  } catch {
    // Links leave out the language, for their readers may have another; this page keeps its own.
    history.replaceState(null, '', withLanguage(link));
    return words().linkInAddress(what);
  }
}
/**
 * Hands a text and a link to the system's share sheet, or copies both.
 * @returns a sentence for the player; empty where the sheet has said it all
 */
export async function shareText(text: string, link: string, useSheet: boolean): Promise<string> {
  if (useSheet && typeof navigator.share === 'function') {
    // A player who closes the sheet has changed their mind.
    await navigator.share({ text, url: link }).catch(() => {});
    return '';
  }
  try {
    await navigator.clipboard.writeText(`${text}\n${link}`);
    return words().resultCopied;
  } catch {
    return words().cannotCopy;
  }
}
