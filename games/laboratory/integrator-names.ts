import { INTEGRATORS } from '@principia/physics';
import { WORDS } from './words.ts';

/** Integrators whose names are translated. */
export type NamedIntegrator = keyof typeof WORDS.integrators;

/** The name of an integrator in the language of the page. @param name as the integrator has it */
export function integratorName(name: string): string {
  const known = Object.entries(WORDS.integrators).find(([key]) => INTEGRATORS[key as NamedIntegrator].name === name);
  return known?.[1] ?? name;
}
