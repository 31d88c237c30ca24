import * as three from 'three';

/** Column textures go through three's own record of how pixels are unpacked, which it has since this revision. */
export const MIN_THREE = 184;

/**
 * The class of textures whose storage is made elsewhere. A revision that has no such class could not even load an import of
 * its name, so that nobody would read why.
 */
export const ExternalTexture: typeof three.ExternalTexture = three.ExternalTexture ?? three.Texture;

/**
 * @param revision of three; for tests
 * @throws Error when the revision cannot draw bodies and lines
 */
export function requireThree(revision: string = three.REVISION): void {
  if (Number.parseInt(revision, 10) >= MIN_THREE) return;
  throw new Error(
    `@principia/render-three needs three 0.${MIN_THREE}.0 or newer, got 0.${revision}, which cannot draw bodies: ` +
      'run npm install three@latest',
  );
}
