/** What the functions that make forces take, read from their declarations and the comments before these. */
import { type Node, parse, typescriptFiles } from '../rules/sources.ts';

/** An argument of a function, or an option of one. */
export interface LawOption {
  readonly name: string;
  readonly isOptional: boolean;
  readonly type: string;
  /** What the comment says, in one line. */
  readonly meaning: string;
}

/** How a function is called, and what it takes. */
export interface LawCall {
  /** As in `wing({ area, span? })`. */
  readonly call: string;
  readonly options: readonly LawOption[];
}

/** An interface, with those that it extends. */
interface OptionType {
  readonly bases: readonly string[];
  readonly own: readonly LawOption[];
}

export type OptionTypes = ReadonlyMap<string, OptionType>;

type Named = Node & { readonly name: string };

/** The interfaces that the files in some folders and those below export, by their names. */
export function optionTypes(folders: readonly string[]): OptionTypes {
  const types = new Map<string, OptionType>();
  for (const file of typescriptFiles.filter((path) => folders.some((folder) => path.startsWith(`${folder}/`)))) {
    const { text } = parse(file);
    for (const { declaration } of exportsOf(file)) {
      if (declaration.type !== 'TSInterfaceDeclaration') continue;
      const bases = (declaration.extends as { expression: Named }[]).map(({ expression }) => expression.name);
      const own = (declaration.body as { body: Node[] }).body.filter(({ type }) => type === 'TSPropertySignature');
      types.set((declaration.id as Named).name, { bases, own: own.map((member) => optionOf(member, text)) });
    }
  }
  return types;
}

/** The declarations that a file exports, with the places where they start. */
function exportsOf(file: string): { declaration: Node; start: number }[] {
  const found = parse(file).tree.body as Node[];
  return found.flatMap(({ declaration, start }) => (declaration ? [{ declaration: declaration as Node, start }] : []));
}

function optionOf(member: Node, text: string): LawOption {
  const meaning = oneLine(commentBefore(member.start, text));
  return {
    name: (member.key as Named).name,
    isOptional: member.optional === true,
    type: typeOf(member, text),
    meaning,
  };
}

/** The type that stands at a name. */
function typeOf({ typeAnnotation }: Node, text: string): string {
  const { start, end } = (typeAnnotation as { typeAnnotation: Node }).typeAnnotation;
  return text.slice(start, end);
}

function commentBefore(start: number, text: string): string {
  return /\/\*\*((?:(?!\*\/).)*)\*\/\s*$/s.exec(text.slice(0, start))?.[1] ?? '';
}

function oneLine(comment: string): string {
  return comment.replace(/\s*\n\s*\* ?/g, ' ').trim();
}

/**
 * How a function of a file is called.
 * @throws Error where the file exports no such function, or says nothing about an option
 */
export function lawCall(maker: string, file: string, types: OptionTypes): LawCall {
  const { text } = parse(file);
  const found = exportsOf(file).find(({ declaration }) => (declaration.id as Named | null)?.name === maker);
  if (found === undefined) throw new Error(`${file} exports no function ${maker}.`);
  const comment = commentBefore(found.start, text);
  const parts = (found.declaration.params as Node[]).map((argument) => {
    const option = argumentOf(argument, text, comment);
    const options = optionsOf(option.type, types);
    return { call: options === undefined ? marked(option) : `{ ${options.map(marked).join(', ')} }`, options, option };
  });
  const options = parts.flatMap((part) => part.options ?? [part.option]);
  for (const { name, meaning } of options) {
    if (meaning === '') throw new Error(`Say what ${name} of ${maker} is: in a comment, or as \`@param ${name}\`.`);
  }
  return { call: `${maker}(${parts.map(({ call }) => call).join(', ')})`, options };
}

function argumentOf(argument: Node, text: string, comment: string): LawOption {
  const isOptional = argument.type === 'AssignmentPattern';
  const target = (isOptional ? argument.left : argument) as Named;
  const type = target.typeAnnotation ? typeOf(target, text) : typeof (argument.right as { value: unknown }).value;
  const meaning = new RegExp(`@param ${target.name} ((?:(?!\\n \\* @).)*)`, 's').exec(comment)?.[1] ?? '';
  return { name: target.name, isOptional, type, meaning: oneLine(meaning) };
}

/** The options of a type and of those that it extends, undefined if it is no type of options. */
function optionsOf(type: string, types: OptionTypes): LawOption[] | undefined {
  const found = types.get(type);
  return found && [...found.own, ...found.bases.flatMap((base) => optionsOf(base, types) ?? [])];
}

/** The name of an option, with a question mark where it may be left out. */
export function marked({ name, isOptional }: LawOption): string {
  return isOptional ? `${name}?` : name;
}
