import { createPhysicsWorld, type PhysicsWorldOptions, type Warning } from '@principia/physics';

/** A world, the warnings that it has given, and their messages by lines. */
export function warnedWorld(options: PhysicsWorldOptions = {}) {
  const warnings: Warning[] = [];
  const world = createPhysicsWorld({ capacity: 100, onWarning: (warning) => warnings.push(warning), ...options });
  const messages = () => warnings.map(({ message }) => message).join('\n');
  return { world, warnings, messages };
}
