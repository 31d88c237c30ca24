/** The text of llms.txt (https://llmstxt.org): title, summary, and one line for each page and package. */
import { readdirSync, readFileSync } from 'node:fs';
import { manifestOf, packageNames } from './packages.mjs';
import { root } from './paths.mjs';

/** Pages in the order in which they are best read; others follow in the order of the alphabet. */
const FIRST = [
  'tour',
  'in-your-own-project',
  'making-a-game',
  'components',
  'forces',
  'integrators',
  'step',
  'presets',
];

/** @returns {string} */
export function llmsTxt() {
  const readme = readFileSync(`${root}/README.md`, 'utf8');
  const summary = paragraphsOf(readme)[0];
  const names = readdirSync(`${root}/docs`)
    .filter((name) => name.endsWith('.md'))
    .map((name) => name.replace(/\.md$/, ''));
  const ordered = [...FIRST, ...names.filter((name) => !FIRST.includes(name)).sort()];
  return [
    `# ${titleOf(readme)}`,
    '',
    `> ${summary}`,
    '',
    '## Documentation',
    '',
    ...ordered.map(pageLine),
    '',
    '## Packages',
    '',
    ...packageNames.map(
      (name) => `- [${manifestOf(name).name}](packages/${name}/README.md): ${manifestOf(name).description}`,
    ),
    '',
    '## Optional',
    '',
    '- [Changelog](CHANGELOG.md): what was added, changed, fixed and renamed',
    '- [Contributing](CONTRIBUTING.md): commands, rules, and where things are',
    '',
  ].join('\n');
}

/** @param {string} name */
function pageLine(name) {
  const text = readFileSync(`${root}/docs/${name}.md`, 'utf8');
  const [sentence] = /^.*?(?:\.(?= |$)|:$)/.exec(plain(paragraphsOf(text)[0])) ?? [''];
  return `- [${titleOf(text)}](docs/${name}.md): ${sentence.replace(/[.:]$/, '')}`;
}

/** @param {string} markdown */
function titleOf(markdown) {
  const [, title = ''] = /^# (.*)$/m.exec(markdown) ?? [];
  return title;
}

/**
 * The paragraphs of running text, each as one line.
 * @param {string} markdown
 */
function paragraphsOf(markdown) {
  const blocks = markdown.replaceAll(/```[\s\S]*?```/g, '').split(/\n{2,}/);
  return blocks.map((block) => block.replaceAll('\n', ' ').trim()).filter((block) => /^[\w`*[]/.test(block));
}

/**
 * Without links, whose targets are relative to another folder.
 * @param {string} text
 */
function plain(text) {
  return text.replaceAll(/\[([^\]]*)\]\([^)]*\)/g, '$1');
}
