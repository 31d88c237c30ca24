import { PHASES, type PhysicsWorld, type Profile, resetProfile, startProfile, stopProfile } from '@principia/physics';
import { element } from './element.ts';
import { decimal } from './language.ts';
import { words } from './words.ts';

/** The time of a step, phase by phase. */
export interface ProfileCard {
  /** Shows the mean milliseconds per step since the last call. */
  show(world: PhysicsWorld): void;
  toggle(): void;
}

export function createProfileCard(parent: HTMLElement): ProfileCard {
  const list = element('dl', 'game-profile');
  const title = element('h2', '', {}, words().profileTitle);
  const card = element('section', 'game-card', { 'aria-label': words().profile }, title, list);
  card.hidden = true;
  parent.append(card);
  const rows = PHASES.map((phase) => {
    const bar = element('i', '');
    const time = element('dd', '', {}, '–');
    list.append(element('dt', '', {}, words().names[phase] ?? phase), bar, time);
    return { phase, bar, time };
  });
  let watched: { readonly world: PhysicsWorld; readonly profile: Profile; tick: number } | undefined;
  const watch = (world: PhysicsWorld) => ({
    world,
    profile: startProfile(world, () => performance.now()),
    tick: world.tick,
  });
  const update = (world: PhysicsWorld) => {
    if (watched?.world !== world) watched = watch(world);
    const { profile, tick } = watched;
    const steps = world.tick - tick;
    watched.tick = world.tick;
    if (steps > 0) {
      const times = PHASES.map((phase) => profile.times[phase] / steps);
      const sum = times.reduce((total, time) => total + time, 0);
      for (const [i, { bar, time }] of rows.entries()) {
        bar.style.setProperty('--share', String(sum > 0 ? times[i] / sum : 0));
        time.textContent = `${decimal(times[i], times[i] < 1 ? 3 : 1)} ms`;
      }
    }
    resetProfile(profile);
  };
  return {
    show(world) {
      if (!card.hidden) update(world);
    },
    toggle() {
      card.hidden = !card.hidden;
      if (!card.hidden || watched === undefined) return;
      // Reading the clock costs time, so a hidden card measures nothing.
      if (watched.world.state !== 'destroyed') stopProfile(watched.world);
      watched = undefined;
    },
  };
}
