/** @throws Error where an object was destroyed: updates would send its data to the GPU again. @param maker what made it */
export function assertLive(isLive: boolean, maker: string): void {
  if (isLive) return;
  throw new Error(`what ${maker} made was destroyed: do not update it any more`);
}
