/** Who may import whom: the one place to edit when a package or a folder joins. Imports point towards the top. */

/** What each package may import: other packages of the project, then installed ones. */
export const packageImports: Record<string, readonly string[]> = {
  physics: ['bitecs'],
  scenes: ['@principia/physics', 'bitecs'],
  'render-core': ['@principia/physics', 'bitecs'],
  'render-pixi': ['@principia/physics', '@principia/render-core', 'bitecs', 'pixi.js'],
  'render-three': ['@principia/physics', '@principia/render-core', 'bitecs', 'three'],
  shell: [
    '@principia/physics',
    '@principia/scenes',
    '@principia/render-core',
    '@principia/render-pixi',
    '@principia/render-three',
    'bitecs',
    'pixi.js',
    'three',
    'lil-gui',
    'uplot',
  ],
};

/** A game's `sim.ts` is headless, so that tests and the bench can run it; its other files may use every package. */
export const simulationImports: readonly string[] = ['@principia/physics', '@principia/scenes', 'bitecs'];

/**
 * Folders and single files of `packages/physics/src`, in the order of the step: each imports from those above it. A file
 * that has a line of its own stands there and not where its folder does.
 */
export const physicsLayers: readonly string[] = [
  'errors',
  'kernels',
  'math',
  'components',
  'development',
  'memory/layouts.gen.ts',
  'world/phases.ts',
  'world/name-system.ts',
  'laws',
  'memory',
  'ecs',
  'memory/resource.ts',
  'memory/force-memory.ts',
  'world/execution-plan.ts',
  'world/event-handlers.ts',
  'world/profile.ts',
  'world/read-clock.ts',
  'world/run-phase.ts',
  'world/is-soft-step.ts',
  'dynamics',
  'forces/support',
  'collision/shapes',
  'bodies',
  'forces',
  'integrators/support',
  'integrators',
  'integrators/support/integrator-list.ts',
  'xpbd',
  'soft-bodies',
  'emitters',
  'particle-contacts',
  'n-body',
  'collision',
  'solver/rigid-table.ts',
  'solver/refresh-parts.ts',
  'joints',
  'solver',
  'queries',
  'characters',
  'diagnostics',
  'snapshot',
  'debug',
  'presets',
  'world',
  'index.ts',
];

/** Files whose types every layer may import (`import type`), although they stand below: the contract of a world. */
export const typesForAll: readonly string[] = ['world/types.ts'];
