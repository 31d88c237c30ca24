/** The sounds: engine, wind, stall horn, tyres, rings and the crash. */
import { Synth } from '@principia/shell';
import type { Flight } from './sim.ts';

const CHORD = [523, 659, 784];

export interface Sounds {
  /** Call it once a frame. */
  update(flight: Flight, isOn: boolean, seconds: number): void;
  destroy(): void;
}

export function createSounds(): Sounds {
  const synth = new Synth();
  const last = { ring: -1, onGround: true, phase: 'flying' };
  let sinceEngine = 0;
  let sinceHorn = 0;
  return {
    update(flight, isOn, seconds) {
      synth.set(isOn);
      const { log, pilot } = flight;
      if (synth.isAudible) {
        sinceEngine += seconds;
        sinceHorn += seconds;
        if (log.phase === 'flying' && pilot.throttle > 0.02 && sinceEngine > 0.11) {
          sinceEngine = 0;
          const frequency = 60 + 70 * pilot.throttle;
          synth.tone({ frequency, loudness: 0.05 + 0.06 * pilot.throttle, seconds: 0.24, wave: 'sawtooth' });
        }
        if (flight.isStalling && sinceHorn > 0.3) {
          sinceHorn = 0;
          synth.tone({ frequency: 640, loudness: 0.12, seconds: 0.22, wave: 'square' });
        }
        if (log.ringsFlown > last.ring && last.ring >= 0) {
          for (const frequency of CHORD) synth.tone({ frequency, loudness: 0.14, seconds: 0.8 });
        }
        if (log.onGround && !last.onGround) synth.noise({ frequency: 2200, to: 500, loudness: 0.3, seconds: 0.3 });
        if (log.phase === 'crashed' && last.phase === 'flying') {
          synth.noise({ frequency: 900, to: 60, loudness: 0.7, seconds: 1.4 });
        }
      }
      last.ring = log.ringsFlown;
      last.onGround = log.onGround;
      last.phase = log.phase;
    },
    destroy: () => synth.destroy(),
  };
}
