/** Styles of the game's controls. */
export const CONTROLS_STYLE = `
.game-pad { display: none !important }
.fw-desk { position: absolute; left: 0; right: 0; bottom: max(10px, env(safe-area-inset-bottom)); display: grid; gap: 8px;
  grid-template-columns: minmax(0, 1fr); justify-items: center; container-type: inline-size; padding: 0 10px; pointer-events: none; color: var(--ink) }
.fw-desk > * { pointer-events: auto; box-sizing: border-box; max-width: 100%; border: 1px solid #ffffff1f;
  border-radius: 14px; background: #0a0e24c4; backdrop-filter: blur(6px) }
.fw-tray, .fw-tray > div { display: flex; justify-content: center; gap: 4px } .fw-tray { flex-wrap: wrap; padding: 5px 7px }
.fw-desk button { display: grid; place-items: center; min-width: 36px; height: 36px; padding: 0 6px; border: 0; border-radius: 9px;
  background: none; color: var(--ink); font: 600 13px/1 inherit; font-family: inherit; cursor: pointer; touch-action: manipulation }
.fw-desk button:hover { background: #ffffff1c }
.fw-desk button:focus-visible { outline: 2px solid var(--accent); outline-offset: -1px }
.fw-desk button[aria-pressed=true] { background: #ffffff2e; box-shadow: inset 0 0 0 1.5px #ffffff8a }
.fw-desk button:disabled { opacity: .35; cursor: default }
.fw-desk svg { width: 22px; height: 22px; fill: none; stroke: currentColor; stroke-width: 1.5; stroke-linecap: round }
.fw-tray span { width: 1px; margin: 4px 3px; background: #ffffff24 }
.fw-tray .fw-color { min-width: 27px; padding: 0 }
.fw-color i { width: 15px; height: 15px; border-radius: 50%; background: var(--c); box-shadow: 0 0 8px var(--c) }
.fw-color.fw-any i { background: conic-gradient(#ff5a4d, #ffd94a, #3dff6e, #3f9bff, #b45cff, #ff5a4d); box-shadow: none }
@media (forced-colors: active) { :is(.fw-color i, .fw-mark, .fw-cursor) { forced-color-adjust: none } }
.fw-show { width: min(760px, 100%); padding: 7px 9px 5px }
.fw-show > div:first-child { display: flex; gap: 4px; align-items: center }
.fw-show p { flex: 1; margin: 0 6px; color: #b9c4e6; font-size: 13px; min-width: 0; overflow: hidden; text-overflow: ellipsis; white-space: nowrap }
.fw-line { position: relative; height: 34px; margin: 4px 8px 0; cursor: pointer; touch-action: none;
  background: linear-gradient(#ffffff26, #ffffff26) 0 16px / 100% 2px no-repeat }
.fw-line .fw-mark { position: absolute; top: 8px; width: 18px; min-width: 0; height: 18px; margin-left: -9px; padding: 0; border-radius: 50%;
  background: var(--c); box-shadow: 0 0 9px var(--c); cursor: grab; touch-action: none }
.fw-line .fw-mark[aria-pressed=true] { box-shadow: 0 0 0 2px #fff, 0 0 12px var(--c); background: var(--c) }
.fw-cursor { position: absolute; top: 1px; bottom: 1px; width: 2px; margin-left: -1px; border-radius: 1px; background: var(--accent); pointer-events: none }
.fw-hint { padding: 4px 14px; border: 0 !important; background: none !important; backdrop-filter: none !important; color: #cfd8f5;
  font-size: 14px; text-align: center; text-shadow: 0 1px 4px #000, 0 0 12px #000; pointer-events: none }
.fw-ring, .fw-sight { position: absolute; left: -32px; top: -32px; width: 64px; height: 64px; border-radius: 50%; pointer-events: none;
  box-sizing: border-box }
.fw-ring { display: grid; place-items: center; color: #ffe6b0; font: 700 26px/1 system-ui, sans-serif; border: 2px solid #ffe6b0cc; scale: calc(0.25 + 0.9 * var(--power, 0.35)); box-shadow: 0 0 18px #ffcf7a88, inset 0 0 18px #ffcf7a55 }
.fw-sight { background: radial-gradient(circle, #ffe6b0 0 2px, #0000 3px), linear-gradient(#ffe6b0cc, #ffe6b0cc) 31px 10px / 2px 14px no-repeat,
  linear-gradient(#ffe6b0cc, #ffe6b0cc) 31px 40px / 2px 14px no-repeat, linear-gradient(#ffe6b0cc, #ffe6b0cc) 10px 31px / 14px 2px no-repeat,
  linear-gradient(#ffe6b0cc, #ffe6b0cc) 40px 31px / 14px 2px no-repeat }
.fw-extras { position: absolute; left: max(20px, env(safe-area-inset-left)); top: calc(var(--bar, 58px) + 4px);
  display: flex; flex-wrap: wrap; gap: 6px; max-width: calc(100% - 40px) }
.fw-text { display: flex; gap: 6px; order: 1; flex-basis: 100% }
.fw-text input { width: 150px; min-width: 0; padding: 0 12px; border: 1px solid #ffffff38; border-radius: 11px; background: #0a0e24e0;
  color: var(--ink); font: 600 16px/1 inherit; font-family: inherit }
.fw-text input::placeholder { color: #aab6dc }
.fw-extra { min-height: 38px; padding: 0 13px; border: 1px solid var(--line); border-radius: 11px; background: var(--card); color: var(--ink);
  font: 600 13px/1 inherit; font-family: inherit; cursor: pointer; touch-action: manipulation }
.fw-extra:hover { background: #2b3766 }
.fw-gallery { position: absolute; z-index: 1; left: 0; top: calc(100% + 6px); box-sizing: border-box; width: min(350px, 100vw - 40px); overflow-y: auto;
  overscroll-behavior: contain; padding: 5px; border: 1px solid #ffffff2e; border-radius: 14px; background: #0a0e24f0 }
.fw-gallery button { display: grid; grid-template-columns: 1fr auto; gap: 3px 10px; width: 100%; min-height: 50px; padding: 7px 10px; border: 0;
  border-radius: 9px; background: none; color: var(--ink); font: 13px/1.3 inherit; font-family: inherit; text-align: left; cursor: pointer; touch-action: manipulation }
.fw-gallery button:hover { background: #ffffff1c }
.fw-gallery :is(i, span) { color: #b9c4e6; font-style: normal } .fw-gallery span { grid-column: 1 / -1 } .fw-gallery b { font-size: 14px }
.fw-gallery button:focus-visible { outline: 2px solid var(--accent); outline-offset: -2px }
:is(.fw-extra, .fw-text input):focus-visible { outline: 2px solid var(--accent); outline-offset: 2px }
@media (pointer: coarse) { .fw-extra, .fw-text input { min-height: 44px; box-sizing: border-box } }
@container (max-width: 860px) { .fw-desk button { min-width: 31px; padding: 0 4px } .fw-tray, .fw-tray > div { gap: 1px }
  .fw-tray .fw-color { min-width: 24px } .fw-tray span { margin: 4px 2px } }
@container (max-width: 600px) { .fw-tray .fw-color { min-width: 36px } .fw-tray span.fw-break { display: none } .fw-tray { padding: 4px }
  .fw-hint { font-size: 12.5px } }
@container (max-width: 400px) { .fw-desk button { min-width: 30px; padding: 0 2px } .fw-tray .fw-color { min-width: 32px } }
@media (pointer: coarse) { .fw-desk :is(.fw-tray, .fw-show) button:not(.fw-mark) { min-width: 44px; height: 44px }
  .fw-tray > div { display: contents } .fw-tray { gap: 0; padding: 2px } .fw-tray span { display: none }
  .fw-show p { display: none } .fw-line { height: 44px } .fw-line .fw-mark { top: 4px; width: 26px; height: 26px; margin-left: -13px } }
@media (max-height: 460px) { .fw-hint { padding: 0 14px; font-size: 13px } .fw-hint:empty { display: none } }
@media (max-height: 460px) and (pointer: coarse) { .fw-desk { bottom: 2px }
  .fw-tray { display: grid; border-radius: 10px; padding: 0 6px } .fw-tray > div { display: flex }
  .fw-show { display: flex; gap: 20px; padding: 2px 10px 2px 4px } .fw-line { flex: 1; margin-top: 0 } }
@media (max-width: 759px), (max-height: 479px) { .game:has(.game-side:not([hidden])) :is(.fw-desk, .fw-extras) { visibility: hidden } }
@media (max-height: 460px) and (pointer: fine) { .fw-desk button { height: 30px } .fw-desk { gap: 4px } }
`;
