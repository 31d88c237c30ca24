/** The page docs/joints.md, made from the declarations of the functions that describe joints, and the comments before these. */
import { readFileSync } from 'node:fs';
import { type LawOption, lawCall, marked, optionTypes } from './law-options.ts';

const source = 'packages/physics/src/joints';

/** The functions that describe joints, and their files. */
export const JOINT_FILES: Readonly<Record<string, string>> = {
  revolute: 'revolute.ts',
  distance: 'distance.ts',
  weld: 'weld.ts',
  prismatic: 'prismatic.ts',
  wheel: 'wheel.ts',
  motorJoint: 'motor-joint.ts',
  mouseJoint: 'motor-joint.ts',
  pulley: 'pulley.ts',
  gear: 'gear.ts',
  filterJoint: 'filter-joint.ts',
};

const types = optionTypes([source]);

const INTRODUCTION = `# Joints

Every joint with its options, units and defaults, made from the source. How joints are used, what they are exact about and how stiff
their springs are is on the page of [rigid bodies](rigid-bodies.md#joints); how one is added to the package in
[adding a joint](adding-a-joint.md).

\`createJoint(world, revolute({ … }))\` returns the id of the joint, an entity that \`despawn\` removes. Each option is checked when the
function is called, and what two of them say together, such as a lower limit above the upper one, as well as bodies, by \`createJoint\`. Afterwards everything is in [the columns of \`Joint\`](components.md#joint), which
may be changed at any time. A vector is \`{ x, y }\`, with 0 for what is left out. Points and directions are given in world coordinates as
the bodies are now.

| function | |
|---|---|
| \`createJoint(world, joint)\` | makes the joint, and returns its id |
| \`despawn(world, joint)\` | removes it |
| \`jointPosition(world, joint)\` | the angle of a hinge or a weld, rad; the way of a slider or a suspension, the length of a rod or a rope, m |
| \`jointForce(world, joint)\` | the largest force that it exerted in the last step, N |
| \`jointTorque(world, joint)\` | the largest torque, N m, about its anchor |
| \`endedJoints(world)\` | \`{ broken, removed }\`, two lists of ids that belong to the last step: joints that broke in it, and those that went before it because a body was gone |
`;

/** The whole page. */
export function jointPage(): string {
  const shared = ['JointOptions', 'JointLimits', 'JointSpring', 'JointMotor'];
  const titles = ['Options of every joint', 'limits', 'spring', 'motor'];
  const parts = shared.flatMap((type, i) => ['', `## ${titles[i]}`, '', ...table(optionsOf(type))]);
  return `${[INTRODUCTION, ...parts.slice(1), ...Object.keys(JOINT_FILES).flatMap(section)].join('\n')}\n`;
}

/** The options of a type, with those of the types that it extends. */
function optionsOf(type: string): LawOption[] {
  const { own = [], bases = [] } = types.get(type) ?? {};
  return [...own, ...bases.flatMap(optionsOf)];
}

function section(maker: string): string[] {
  const { call, options } = lawCall(maker, `${source}/${JOINT_FILES[maker]}`, types);
  const everyJoint = optionsOf('JointOptions');
  // A body that others may leave out is an option of its own.
  const isShared = ({ name, isOptional }: LawOption) =>
    everyJoint.some((each) => each.name === name && each.isOptional === isOptional);
  const own = options.filter((option) => !isShared(option));
  return [
    '',
    `## ${maker}`,
    '',
    purposeOf(maker),
    '',
    '```ts',
    call,
    '```',
    ...(own.length > 0 ? ['', ...table(own)] : []),
  ];
}

/** What the comment before the function says. */
function purposeOf(maker: string): string {
  const text = readFileSync(`${source}/${JOINT_FILES[maker]}`, 'utf8');
  const comment = new RegExp(`/\\*\\*((?:(?!\\*/).)*)\\*/\\nexport function ${maker}\\(`, 's').exec(text)?.[1] ?? '';
  return comment
    .replace(/\s*\n\s*\* ?/g, ' ')
    .replace(/@throws.*$/s, '')
    .trim();
}

function table(options: readonly LawOption[]): string[] {
  const rows = options.map((option) => `| \`${marked(option)}\` | ${typeName(option.type)} | ${option.meaning} |`);
  return ['| option | type | |', '|---|---|---|', ...rows];
}

const LINKED: Readonly<Record<string, string>> = {
  VectorInput: 'vector',
  JointLimits: '[limits](#limits)',
  JointSpring: '[spring](#spring)',
  JointMotor: '[motor](#motor)',
};

function typeName(type: string): string {
  return LINKED[type] ?? type;
}
