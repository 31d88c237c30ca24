/** How a key is written. @param key value of `KeyboardEvent.key` in lower case */
export function keyName(key: string): string {
  const arrows: Record<string, string> = { arrowup: '↑', arrowdown: '↓', arrowleft: '←', arrowright: '→' };
  return arrows[key] ?? key.toUpperCase();
}
