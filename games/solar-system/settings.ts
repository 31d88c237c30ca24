/** The settings in the panel. */
import { switchSetting, type ValuesOf } from '@principia/shell';

export const settings = {
  enlarged: switchSetting('Enlarged bodies', true, {
    key: 'x',
    about: 'Off, Sun and planets have their true size, which is less than a pixel from afar',
  }),
  orbits: switchSetting('Orbits', true, { key: 'o', about: 'The ellipse on which each body is at this moment' }),
  trails: switchSetting('Trails', false, { key: 't', about: 'The paths that the bodies have taken' }),
  names: switchSetting('Names', true, { key: 'n' }),
  moon: switchSetting('Moon', true, {
    key: 'l',
    about: 'Off, Earth and Moon are one body, and time may run up to 100 years a second',
  }),
  sound: switchSetting('Sound', true, { key: 'm' }),
};

export type Settings = typeof settings;
export type Values = ValuesOf<Settings>;
