/**
 * Puts a link into the clipboard, or into the address bar where the browser refuses.
 * @returns a sentence for the player
 */
export async function copyLink(link: string, what: string): Promise<string> {
  try {
    await navigator.clipboard.writeText(link);
    return `The link to ${what} was copied.`;
  } catch {
    history.replaceState(null, '', link);
    return `The link to ${what} is in the address bar. Copy it from there.`;
  }
}
