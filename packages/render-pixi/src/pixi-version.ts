/** Ids and styles of bodies are integer textures, which pixi's WebGL renderer uploads since this version. */
export const MIN_PIXI = '8.22.0';

/**
 * An older version draws nothing and reports no error, so each layer checks the version first.
 *
 * @param version of pixi.js
 * @throws Error when the version cannot draw layers
 */
export function requirePixi(version: string): void {
  const [major, minor] = version.split('.').map(Number);
  const [oldestMajor, oldestMinor] = MIN_PIXI.split('.').map(Number);
  if (major > oldestMajor || (major === oldestMajor && minor >= oldestMinor)) return;
  throw new Error(
    `@principia/render-pixi needs pixi.js ${MIN_PIXI} or newer, got ${version}, which cannot draw bodies: ` +
      `run npm install pixi.js@^${MIN_PIXI}`,
  );
}
