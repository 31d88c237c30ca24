/** The laboratory: without an example in the address it lists all examples, otherwise it opens one. */
import { EXAMPLES, type ExampleEntry } from '@principia/scenes/examples/list';

const query = new URLSearchParams(location.search);
const id = query.get('example');
const entry = EXAMPLES.find((candidate) => candidate.id === id);
// The first import is fetched at once by every page, so it is the smallest.
const openList = () => import('./start-page.ts');

/** Fetches what the page of an example imports later, one thing after the other. Who needs it reports what fails. */
function fetchAtOnce({ dimensions, load }: ExampleEntry): void {
  const view = dimensions === 3 ? import('./view-3d.ts') : import('./view-2d.ts');
  for (const part of [load(), view]) part.catch(() => {});
}

// Changed code is tried in a worker, which runs this script too.
if (typeof document === 'undefined') await import('./trial.ts');
else if (entry !== undefined) {
  fetchAtOnce(entry);
  const { openExample } = await import('./example-page.ts');
  await openExample(entry, query);
} else if (id === 'new') {
  const [{ openExample }, { NEW_ENTRY }] = await Promise.all([import('./example-page.ts'), import('./new-example.ts')]);
  await openExample(NEW_ENTRY, query);
} else {
  const { showStartPage } = await openList();
  showStartPage(document.body, query.get('search') ?? '', id);
}
