import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';

const readme = readFileSync('README.md', 'utf8');

it('the README shows the first game as it is', () => {
  const game = readFileSync('games/first-game/main.ts', 'utf8').trimEnd();
  expect(readme).toContain(`\`\`\`ts\n${game}\n\`\`\``);
});

it('the page on making a game shows the game as it is', () => {
  const page = readFileSync('docs/making-a-game.md', 'utf8');
  const shown = [...page.matchAll(/`(games\/[^`]+)`\n\n```typescript\n([\s\S]*?)```/g)];
  expect(shown.map(([, path]) => path?.replace(/.*\//, ''))).toEqual(['sim.ts', 'settings.ts', 'view.ts', 'main.ts']);
  for (const [, path, code] of shown) expect(code, path).toBe(readFileSync(path as string, 'utf8'));
});
