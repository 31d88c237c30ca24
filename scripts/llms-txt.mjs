/** Writes llms.txt, the index of the documentation for language models, from the README and the pages. */
import { writeFileSync } from 'node:fs';
import { llmsTxt } from './lib/llms-txt.mjs';
import { root } from './lib/paths.mjs';

writeFileSync(`${root}/llms.txt`, llmsTxt());
