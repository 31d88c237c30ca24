/** The list of all examples, without the code of any: a page that only lists them loads no physics. */
export { EXAMPLES, type ExampleEntry } from './examples.gen.ts';
