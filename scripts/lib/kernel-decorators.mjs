/**
 * AssemblyScript allows decorators on functions (`@inline export function …`), TypeScript's parsers do not: for tools
 * made for TypeScript they travel as comments of nearly the same length.
 */

/** @param {string} source */
export function hideDecorators(source) {
  return source.replace(/^(@\w+(?:\([^)]*\))?)(\s)/gm, '/*$1*/$2');
}

/** @param {string} source */
export function showDecorators(source) {
  return source.replace(/^\/\*(@\w+(?:\([^)]*\))?)\*\//gm, '$1');
}
