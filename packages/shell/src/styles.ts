import { FORCED_COLORS } from './forced-colors.ts';

/** Phones in portrait or landscape, and elements as small: the sidebar covers the stage and starts hidden. */
const NARROW = '(max-width: 759px) or (max-height: 479px)';

export const isNarrow = ({ clientWidth, clientHeight }: HTMLElement): boolean =>
  clientWidth < 760 || clientHeight < 480;

/** The styles of every game; a game changes colours by overriding the variables of `.game`. */
const styles = `
html:has(> body > .game:not(.game-inside)), body:has(> .game:not(.game-inside)) { margin: 0; height: 100%; overflow: hidden; background: #0d1226 }
.game { --ink: #eef1fb; --dim: #97a3c7; --accent: #ffc15e; --card: #141b36d9; --line: #ffffff1c;
  position: fixed; inset: 0; container-type: size; color: var(--ink); font: 14px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, sans-serif;
  background: radial-gradient(110% 95% at 42% 12%, #2c3a72 0%, #1a2349 45%, #0d1226 100%); user-select: none; direction: ltr;
  -webkit-text-size-adjust: 100%; text-size-adjust: 100%; -webkit-user-select: none; -webkit-tap-highlight-color: transparent }
/* A part of a page: what is fixed stays in it. */
.game.game-inside { position: relative; inset: auto; width: 100%; height: 100%; contain: layout paint; outline: none }
.game[data-preview] > :not(.game-stage), .game[data-preview] > .game-stage > :not(canvas) { display: none !important }
.game [hidden] { display: none !important }
.game-stage { position: absolute; inset: 0; overflow: hidden }
.game-stage canvas { display: block; outline: none }
.game[data-tabbing] .game-stage canvas:focus-visible { box-shadow: inset 0 0 0 2px var(--accent) }
.game-side :is(input, select, button):focus-visible { outline: 2px solid var(--accent); outline-offset: 1px }
.game-bar { position: absolute; left: 0; top: 0; display: flex; align-items: center; gap: 6px; flex-wrap: wrap;
  padding: max(12px, env(safe-area-inset-top)) 16px 8px max(20px, env(safe-area-inset-left)); pointer-events: none }
.game-title { text-shadow: 0 1px 3px #0d1226, 0 0 10px #0d1226; margin: 0 14px 0 0; font-size: 20px; font-weight: 650; letter-spacing: -0.01em }
.game-bar :is(button, a) { pointer-events: auto; min-width: 38px; height: 38px; padding: 0 9px; display: grid; place-items: center; box-sizing: border-box;
  border: 1px solid var(--line); border-radius: 11px; background: var(--card); color: var(--ink);
  font: 600 13px/1 inherit; font-family: inherit; cursor: pointer; touch-action: manipulation; transition: background .15s }
@media (hover: hover) { .game-bar :is(button, a):hover { background: #2b3766 } }
.game-bar :is(button, a):focus-visible { outline: 2px solid var(--accent); outline-offset: 2px }
.game-bar button[aria-pressed=true] { background: var(--accent); border-color: transparent; color: #1c1503 }
.game-bar svg { width: 18px; height: 18px; fill: currentColor }
.game-side { position: absolute; top: 12px; right: 12px; width: 264px; max-height: calc(100% - 24px); overflow: hidden auto;
  border: 1px solid var(--line); border-radius: 14px; background: var(--card);
  scrollbar-width: thin; scrollbar-color: #ffffff30 transparent }
.game-side .lil-gui { --background-color: transparent; --title-background-color: transparent; --text-color: var(--ink);
  --title-text-color: var(--ink); --widget-color: #ffffff14; --hover-color: #ffffff22; --focus-color: #ffffff2c;
  --number-color: var(--accent); --string-color: var(--accent); --font-size: 12.5px; --input-font-size: 12.5px;
  --font-family: inherit; --width: 264px; --widget-height: 24px; --row-height: 30px; --name-width: 38%; --padding: 10px;
  --slider-knob-width: 3px; --widget-border-radius: 6px; --slider-input-width: 36% }
.game-side .lil-disabled .lil-fill { display: none }
/* A long name takes a second line, so that the slider keeps its length. */
.game-side .lil-number > .lil-name { box-sizing: border-box; max-width: 46%; white-space: normal; overflow-wrap: anywhere; line-height: 1.25 }
/* Nothing to show yet. */
.game-side:not(:has(> :not(.game-side-close))) { visibility: hidden }
.game-side-close { display: none }
.game-card { padding: 6px 12px 10px; border-top: 1px solid var(--line) }
.game-card h2 { margin: 0 0 2px; font-size: 12px; font-weight: 600; color: var(--dim); display: flex; flex-wrap: wrap; gap: 0 10px }
.game-card h2 span { flex-basis: 100%; font-weight: 500; display: flex; flex-wrap: wrap; gap: 0 10px }
.game-card h2 small { font-size: 12px } .game-card h2 i { font-style: normal } .game-card h2 i::before { content: ""; display: inline-block; width: 8px; height: 8px;
  border-radius: 50%; margin-right: 4px; background: var(--mark) }
.game-card select, .game-card input { border: 0; border-radius: 6px; background: #ffffff14; color: var(--ink); font: inherit;
  font-size: 12px; line-height: 18px; padding: 1px 4px; max-width: 100% } .game-card option { background: #1a2349 }
.game-card input { width: 52px } .game-card h2 select { color: var(--dim); font-weight: 600; margin-left: -4px }
.game-plot-column { display: flex; gap: 8px; align-items: center; font-size: 12px; color: var(--dim); white-space: nowrap } .game-plot-column select { min-width: 0 }
.game-plot-buttons { display: flex; flex-wrap: wrap; gap: 6px; margin: 4px 0 } .game-plot-buttons button { border: 1px solid var(--line); border-radius: 7px;
  background: #ffffff10; color: var(--dim); font: inherit; font-size: 12px; padding: 1px 7px; cursor: pointer }
.game-plot-buttons button:focus-visible { outline: 2px solid var(--accent) }
.game-profile { display: grid; grid-template-columns: max-content 1fr max-content; gap: 1px 8px; margin: 0; font-size: 12px;
  align-items: center; font-variant-numeric: tabular-nums } .game-profile dt { color: var(--dim) } .game-profile dd { margin: 0 }
.game-profile i { height: 6px; border-radius: 3px; background: linear-gradient(90deg, var(--accent), var(--accent)) 0 0 /
  calc(100% * var(--share, 0)) 100% no-repeat #ffffff14 }
.game-tools { display: flex; flex-wrap: wrap; gap: 6px; padding-top: 10px }
.game-tools button { border: 1px solid var(--line); border-radius: 9px; background: #ffffff10; color: var(--ink);
  font: inherit; font-size: 12px; line-height: 1; padding: 7px 10px; cursor: pointer }
.game-tools button:hover { background: #ffffff22 } .game-tools button:focus-visible { outline: 2px solid var(--accent) }
.game-tools button[aria-pressed=true] { background: var(--accent); border-color: transparent; color: #1c1503 }
/* A clip in progress fills its button from the left. */
.game [data-clip][aria-pressed=true] { border-color: transparent; color: #1c1503; font-variant-numeric: tabular-nums;
  background: linear-gradient(#ffffff70, #ffffff70) 0 0 / calc(100% * var(--done, 0)) 100% no-repeat var(--accent) }
.game-clip { position: absolute; left: 50%; top: 50%; translate: -50% -50%; box-sizing: border-box; max-width: calc(100% - 24px);
  padding: 12px; border: 1px solid var(--line); border-radius: 18px; background: #141b36f7; box-shadow: 0 24px 80px #000c; z-index: 4 }
.game-clip video { display: block; max-width: min(520px, 100%); max-height: 50cqh; margin: 0 auto; border-radius: 10px; background: #000 }
.game-clip div { display: flex; gap: 8px; justify-content: center; margin-top: 12px }
.game-clip button { border: 1px solid var(--line); border-radius: 11px; padding: 9px 18px; background: #ffffff1c; color: var(--ink);
  font: 650 15px/1.2 inherit; font-family: inherit; cursor: pointer }
.game-clip button:first-child { background: var(--accent); color: #1c1503 }
.game-clip button:focus-visible { outline: 2px solid #fff; outline-offset: 2px }
.game-stats { display: grid; grid-template-columns: auto auto auto auto; gap: 0 8px; margin: 0; font-size: 12px;
  font-variant-numeric: tabular-nums }
.game-stats dt { color: var(--dim) } .game-stats dd { margin: 0; text-align: right }
.game-banner { position: absolute; left: 50%; bottom: calc(max(20px, env(safe-area-inset-bottom)) + var(--foot, 0px)); translate: -50% 0;
  box-sizing: border-box; width: max-content; max-width: min(680px, calc(100% - 32px)); display: flex; gap: 12px;
  align-items: center; padding: 12px 14px 12px 18px; border-radius: 14px; background: #30142bf2;
  border: 1px solid #ff8b9a66; color: #ffdfe3; box-shadow: 0 12px 40px #0008; user-select: text; z-index: 3 }
/* Notes lie below the bar, where they cover neither the controls of a game nor its ground. */
.game-banner:not([data-kind=error]) { bottom: auto; top: calc(var(--bar, 58px) + 8px); padding: 7px 8px 7px 16px;
  background: #18224a; border-color: #9bb4ff55; color: #dfe7ff }
.game:has(.game-side:not([hidden])) .game-banner { left: calc(50% - 144px); max-width: min(680px, calc(100% - 320px)) }
.game-banner p { margin: 0; white-space: pre-line; overflow-wrap: anywhere; hyphens: auto } .game-banner p + p { margin-top: 8px }
.game-banner button, .game-help button { flex: none; border: 1px solid #ffffff30; border-radius: 9px; background: #ffffff14;
  color: inherit; font: inherit; padding: 5px 12px; cursor: pointer }
.game-help { box-sizing: border-box; max-height: calc(100dvh - 32px); overflow: hidden auto; border: 1px solid var(--line); border-radius: 18px; padding: 22px 26px; max-width: min(460px, calc(100vw - 80px));
  background: #161e3df7; color: var(--ink); box-shadow: 0 24px 80px #000a }
.game-help::backdrop { background: #070b1a99 }
/* The foot covers the lines that scroll behind it over the whole width. */
.game-help footer { position: sticky; bottom: -22px; margin: 0 -26px -22px; padding: 12px 26px 16px; background: #161e3d } .game-help footer button { background: #2a3153 }
/* Lines fade where they go on below. */
.game-help footer::before { content: ""; position: absolute; left: 0; right: 0; bottom: 100%; height: 20px; background: linear-gradient(#161e3d00, #161e3d); pointer-events: none }
.game-help h2 { margin: 0 0 12px; font-size: 17px; outline: none }
.game-help dl { display: grid; grid-template-columns: max-content 1fr; gap: 5px 16px; margin: 0 0 16px }
.game-help dt { color: var(--accent); font-weight: 600 } .game-help dd { margin: 0 }
.game-pad { position: absolute; right: max(20px, env(safe-area-inset-right)); bottom: calc(max(24px, env(safe-area-inset-bottom)) + var(--foot, 0px));
  display: none; grid: ". up ." 64px "left . right" 64px ". down ." 64px / 64px 64px 64px; gap: 4px; z-index: 2;
  pointer-events: none } .game-pad > * { pointer-events: auto }
.game-pad button { border: 1px solid #ffffff38; border-radius: 20px; background: #ffffff1c; color: var(--ink);
  font: 600 20px/1 inherit; font-family: inherit; touch-action: none }
.game-pad button:active { background: #ffffff48 }
.game-pad [data-name=up] { grid-area: up } .game-pad [data-name=down] { grid-area: down }
.game-pad [data-name=left] { grid-area: left } .game-pad [data-name=right] { grid-area: right }
.game-stick { grid-column: 2 / 4; grid-row: 2 / 4; width: 132px; height: 132px; border-radius: 50%; border: 1px solid #ffffff38;
  background: #ffffff14; touch-action: none; display: grid; place-items: center }
.game-stick i { width: 56px; height: 56px; border-radius: 50%; background: #ffffff3c; border: 1px solid #ffffff60; pointer-events: none }
/* The action lies apart from the directions, so that a thumb that steers does not hit it. */
.game-pad [data-name=action] { position: fixed; left: max(20px, env(safe-area-inset-left)); bottom: calc(max(24px, env(safe-area-inset-bottom)) + var(--foot, 0px));
  width: 64px; height: 64px }
@media (pointer: fine) { .game-pad[data-mouse] { display: grid } .game-pad button { cursor: pointer } .game-pad button:hover { background: #ffffff30 } }
@media (pointer: coarse) { .game-pad { display: grid } .game-bar :is(button, a) { min-width: 44px; height: 44px }
  .game-side .lil-gui { --row-height: 48px; --widget-height: 44px; --checkbox-size: 28px }
  .game-plot-buttons button, .game-tools button, .game-banner button, .game-help button, .game-outcome button, .game-clip button { min-height: 44px; min-width: 44px }
  .game-card select, .game-card input { min-height: 44px } }
.game-outcome { position: absolute; left: 50%; top: 50%; translate: -50% -50%; box-sizing: border-box; width: max-content; min-width: 240px; max-width: min(560px, calc(100% - 24px));
  max-height: calc(100% - 16px); overflow: hidden auto; padding: 24px 32px 26px;
  border: 1px solid var(--line); border-radius: 20px; background: #141b36f2; box-shadow: 0 24px 80px #000c; text-align: center;
  z-index: 2 }
.game-outcome h2 { margin: 0 0 6px; font-size: 26px; letter-spacing: -0.01em }
.game-outcome p { margin: 0 } .game-outcome :is(h2, p) { text-wrap: balance }
.game-outcome ol { margin: 14px auto 18px; padding: 0; width: max-content; color: var(--dim); text-align: left;
  list-style-position: inside; font-variant-numeric: tabular-nums }
.game-outcome li b { display: inline-block; min-width: 44px; color: var(--ink); text-align: right }
.game-outcome li.new, .game-outcome li.new b { color: var(--accent) }
.game-outcome button { margin: 5px; border: 0; border-radius: 11px; padding: 9px 20px; background: var(--accent); color: #1c1503;
  font: 650 15px/1.2 inherit; font-family: inherit; cursor: pointer }
.game-outcome button.second { background: #ffffff1c; color: var(--ink) }
.game-outcome button:focus-visible { outline: 2px solid #fff; outline-offset: 2px }
/* On a window on its side the scores stand beside what was reached. */
@container (max-height: 479px) { .game-outcome { display: grid; grid-template-columns: auto auto auto auto; align-items: center; justify-content: center; padding: 14px 22px; max-width: calc(100% - 24px) }
  .game-outcome > :is(h2, div) { grid-column: 1 / 4; max-width: 420px; justify-self: center } .game-outcome > ol { grid-area: 1 / 4 / 3; margin: 0 0 0 24px }
  .game-outcome > button { margin: 12px 4px 0 } .game-outcome:has(> ol:empty) { display: block } .game-outcome > ol:empty { display: none } }
.game-hint { position: absolute; left: 16px; right: 16px; bottom: calc(max(14px, env(safe-area-inset-bottom)) + var(--foot, 0px)); margin: 0; pointer-events: none;
  text-align: center; text-wrap: balance; font-weight: 500; font-size: 15px; text-shadow: 0 1px 3px #0d1226, 0 0 10px #0d1226 }
@media (pointer: coarse) { .game-hint { bottom: auto; top: calc(var(--bar, 64px) + 10px) } }
/* A window on its side has no room above the picture, but some between the buttons at the corners. */
@media (pointer: coarse) { @container (max-height: 479px) { .game-hint { top: auto; bottom: 10px; left: 172px; right: 172px } } }
/* The bar of the recorded time lies below the picture; what stands at the bottom moves up by its height. */
.game:has(> .game-timeline) { --foot: 48px }
.game-timeline { position: absolute; left: 0; right: 0; bottom: 0; height: calc(44px + env(safe-area-inset-bottom)); display: flex; align-items: center; gap: 10px;
  box-sizing: border-box; padding: 0 16px env(safe-area-inset-bottom) max(20px, env(safe-area-inset-left)) }
.game-timeline input { flex: 1; min-width: 0; height: 44px; margin: 0; appearance: none; background: none; cursor: pointer; touch-action: none; outline: none; border-radius: 8px }
.game-timeline output { min-width: 56px; text-align: right; font-size: 12.5px; font-variant-numeric: tabular-nums; white-space: nowrap;
  padding: 0 6px; border-radius: 6px; background: #0d1226cc }
.game-timeline ::-webkit-slider-runnable-track { height: 6px; border-radius: 3px; background: linear-gradient(90deg, var(--accent), var(--accent)) 0 0 / calc(100% * var(--done, 1)) 100% no-repeat #ffffff2c }
.game-timeline ::-moz-range-track { height: 6px; border-radius: 3px; background: #ffffff2c } .game-timeline ::-moz-range-progress { height: 6px; border-radius: 3px; background: var(--accent) }
.game-timeline ::-webkit-slider-thumb { appearance: none; width: 18px; height: 18px; margin-top: -6px; border-radius: 50%; background: var(--ink); box-shadow: 0 1px 6px #000a }
.game-timeline ::-moz-range-thumb { width: 18px; height: 18px; border: 0; border-radius: 50%; background: var(--ink) }
.game-timeline input:focus-visible { outline: 2px solid var(--accent); outline-offset: -6px }
.game:has(.game-side:not([hidden])) > .game-timeline { right: 280px }
.game-loading { position: absolute; inset: 0; display: grid; place-items: center; color: var(--dim); pointer-events: none }
.uplot, .uplot * { box-sizing: border-box } .uplot { width: min-content }
.u-wrap { position: relative } .u-over, .u-under, .u-axis { position: absolute } .u-under { overflow: hidden }
.uplot canvas { display: block; position: relative; width: 100%; height: 100% } .u-axis.u-off { display: none }
.game:has(.game-side:not([hidden])) .game-bar { right: 288px }
.game:has(.game-side:not([hidden])) .game-pad { right: 300px }
.game:has(.game-side:not([hidden])) .game-hint { right: 304px }
@container (max-width: 999px) { .game-title { display: none } .game-bar { padding-left: max(12px, env(safe-area-inset-left)) } }
/* Texts of the game below it would show through. */
@container ${NARROW} { .game-side { top: 66px; max-height: calc(100% - 78px); background: #111834f7 }
  /* In a corner of the panel, whose height it does not take. */
  .game:not(.game-sheet) .game-side-close { display: grid; place-items: center; position: sticky; top: 0; z-index: 1; width: 44px; height: 44px;
    margin: 0 0 -44px auto; border: 0; border-radius: 14px; background: #212b56; color: var(--ink); font: 600 15px/1 system-ui, sans-serif; cursor: pointer }
  .game:has(.game-side:not([hidden])) .game-bar { right: 0 }
  .game:has(.game-side:not([hidden])) :is(.game-pad, .game-hint) { display: none }
  .game:has(.game-side:not([hidden])) .game-banner { left: 50%; max-width: calc(100% - 32px) }
  .game-bar { right: 0; flex-wrap: nowrap; gap: 5px; padding-right: 12px }
  .game-bar :is(button, a) { flex: 1; min-width: 0; max-width: 48px; height: 44px; padding: 0 } }
@container ${NARROW} { .game:has(.game-side:not([hidden])) > .game-timeline { right: 0 }
  /* The panel ends above the bar, which lies over it. A sheet lies beside the bar, or below it. */
  .game:not(.game-sheet):has(> .game-timeline) .game-side { max-height: calc(100% - 122px - env(safe-area-inset-bottom)) } }
.game-sheet .game-side { width: 320px } .game-sheet .game-side .lil-gui { --width: 100% }
@container (min-width: 760px) and (min-height: 480px) { .game-sheet:has(.game-side:not([hidden])) > :is(.game-bar, .game-timeline) { right: 344px } }
@container (max-width: 759px) { .game-sheet .game-side { top: 54%; right: 0; bottom: 0; left: 0; width: auto; max-height: none; border-radius: 18px 18px 0 0 }
  .game-sheet .game-pad { bottom: calc(46% + 12px + var(--foot, 0px)) }
  .game-sheet:has(.game-side:not([hidden])) > .game-timeline { bottom: 46% } }
@container (min-width: 760px) and (max-height: 479px) { .game-sheet .game-side { top: 8px; right: 8px; max-height: calc(100% - 16px); width: 300px }
  .game-sheet:has(.game-side:not([hidden])) > :is(.game-bar, .game-timeline) { right: 316px } .game-sheet .game-pad { right: 324px } }
/* A page that is enlarged, or a phone on its side: beside the picture, which a sheet below would leave no height. */
@container (min-width: 560px) and (max-width: 759px) and (max-height: 420px) {
  .game-sheet .game-side { top: 8px; right: 8px; bottom: auto; left: auto; width: 264px; max-height: calc(100% - 16px); border-radius: 14px }
  .game-sheet:has(.game-side:not([hidden])) > :is(.game-bar, .game-timeline) { right: 276px } .game-sheet:has(.game-side:not([hidden])) > .game-timeline { bottom: 0; left: 0 }
  .game-sheet .game-pad { right: 284px; bottom: calc(12px + var(--foot, 0px)) }
  .game-sheet:has(.game-side:not([hidden])) .game-bar [data-minor] { display: none } }
@media (min-width: 860px), (min-width: 700px) and (max-height: 479px) { .game-help { max-width: 780px } .game-help dl { grid-template-columns: fit-content(150px) 1fr fit-content(150px) 1fr } }
@media (max-height: 479px) { .game-help { max-height: calc(100dvh - 16px); padding: 12px 26px; line-height: 1.4 } .game-help h2 { margin-bottom: 6px } .game-help footer { bottom: -12px; margin-bottom: -12px; padding-block: 6px 8px } }
@container (max-width: 520px) { .game-bar :is([data-minor], [data-renderer][aria-pressed=true]) { display: none }
  .game-banner[data-kind=error] { flex-wrap: wrap; justify-content: end } .game-banner[data-kind=error] div { flex-basis: 100% } }
/* The help is a dialog over the whole page. */
@media (max-width: 520px) {
  .game-help { max-width: calc(100vw - 24px); padding: 18px } .game-help dl { grid-template-columns: minmax(min-content, 27%) 1fr }
  .game-help footer { bottom: -18px; margin: 0 -18px -18px; padding: 10px 18px 14px } }
.game[data-reduced-motion] * { transition: none !important; animation: none !important }
`;

/** Adds the styles to the page once. */
export function addStyles(): void {
  if (document.getElementById('game-styles') !== null) return;
  const sheet = document.createElement('style');
  sheet.id = 'game-styles';
  sheet.textContent = styles + FORCED_COLORS;
  document.head.append(sheet);
}
