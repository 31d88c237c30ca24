/** The styles of the controls. */
export const HUD_STYLE = `
.ss { position: absolute; inset: 0; pointer-events: none; color: #eaf0ff; font: 500 14px/1.4 system-ui, sans-serif;
  font-variant-numeric: tabular-nums; text-shadow: 0 1px 3px #000 }
.ss button, .ss input, .ss select, .ss details { pointer-events: auto; font: inherit; color: inherit }
.ss-labels { position: absolute; inset: 0; overflow: hidden }
.ss .ss-label { position: absolute; left: 2px; top: -10px; margin: 0; padding: 1px 3px; border: 0; background: none;
  font-size: 12.5px; font-weight: 600; line-height: 18px; cursor: pointer; white-space: nowrap; will-change: transform }
.ss-date { position: absolute; left: 20px; top: calc(var(--bar, 58px) + 4px); display: grid; gap: 1px }
.ss-date b { font-size: 25px; font-weight: 650; letter-spacing: -0.02em; line-height: 1.15 }
.ss-date b small { font-size: 15px; font-weight: 500; color: #a9b8e2; margin-left: 5px }
.ss-date > span { color: #ffd28a; max-width: 300px } .ss-date > em { font-style: normal; font-size: 12.5px; color: #ff9d8a; max-width: 270px }
.ss-pick { display: flex; gap: 6px; margin-top: 5px }
.ss-pick input, .ss-pick button, .ss-card button { border: 1px solid #ffffff2e; border-radius: 10px; background: #131a35c9;
  padding: 5px 10px; font-size: 13px; cursor: pointer; color-scheme: dark }
.ss button:hover { background: #2b3766 } .ss :is(button, input, summary):focus-visible { outline: 2px solid #ffc15e; outline-offset: 1px }
.ss .ss-label:hover { background: #0008; border-radius: 6px }
.ss-jpl { margin-top: 10px; width: 316px; box-sizing: border-box; border: 1px solid #ffffff1c; border-radius: 12px; background: #0b1024b8; padding: 7px 11px }
.ss-jpl summary { cursor: pointer; color: #b9c7ee; font-size: 12.5px; font-weight: 600 }
.ss-jpl table { border-spacing: 0; width: 100%; font-size: 12.5px; margin-top: 4px }
.ss-jpl td { padding: 0 0 0 8px; text-align: right; line-height: 21px } .ss-jpl td:first-child { padding: 0; text-align: left }
.ss-jpl td button { border: 0; background: none; padding: 0 2px; cursor: pointer; font-weight: 600; line-height: 21px }
.ss-jpl td:last-child { color: #8fa0cc } .ss-jpl p { margin: 4px 0 0; font-size: 12px; color: #8fa0cc }
.ss-jpl tr.on button { text-decoration: underline; text-underline-offset: 3px }
.ss-sky { margin-top: 6px } .ss-sky select { width: 100%; margin: 5px 0 3px; padding: 3px 6px; border: 1px solid #ffffff2e; border-radius: 8px; background: #131a35; font-size: 12.5px }
.ss-sky button { display: block; width: 100%; border: 0; background: none; padding: 2px; border-radius: 6px; text-align: left; font-size: 12.5px; line-height: 1.35; cursor: pointer }
.ss-date .ss-sky b { color: #ffd28a; font-size: 12.5px; font-weight: 600; letter-spacing: 0 }
.ss-jpl[open] { overflow-y: auto; pointer-events: auto; background: #0b1024ec } .ss-sky[open] { max-height: calc(100vh - 320px); min-height: 110px }
.ss-foot { position: absolute; left: 20px; right: 20px; bottom: max(14px, env(safe-area-inset-bottom)); display: grid; gap: 8px;
  justify-items: center }
.ss-time { display: grid; grid-template-columns: auto minmax(120px, 460px) auto; gap: 10px; align-items: center; font-size: 12px; color: #a9b8e2 }
.ss input[type=range] { width: 100%; height: 28px; margin: 0; accent-color: #ffc15e; cursor: pointer; touch-action: none }
.ss-card { border: 1px solid #ffffff24; border-radius: 14px; background: #0e142ce6; padding: 10px 14px; box-sizing: border-box;
  width: min(620px, 100%); display: grid; gap: 6px; text-shadow: none; pointer-events: auto }
.ss-card h2 { margin: 0; font-size: 16px; display: flex; gap: 10px; align-items: baseline; justify-content: space-between }
.ss-card p { margin: 0; color: #b9c7ee; font-size: 13px } .ss-card p.ss-say { color: #ffd28a } .ss-card p.ss-bad { color: #ff9d8a }
.ss-row { display: flex; flex-wrap: wrap; gap: 7px; align-items: center } .ss-card .ss-go { background: #ffc15e; border-color: transparent;
  color: #1c1503; font-weight: 700; padding: 5px 18px } .ss-card .ss-go:hover:enabled { background: #ffd58f } .ss-card .ss-go:disabled { background: #ffc15e } .ss-card button:disabled { opacity: .4; cursor: default }
.ss-card .ss-end { border: 0; background: none; padding: 0 2px; color: #97a3c7; font-weight: 500 }
.ss-slide { display: grid; grid-template-columns: 74px 1fr 84px; gap: 9px; align-items: center; font-size: 13px }
.ss-slide .ss-number { width: 100%; box-sizing: border-box; border: 1px solid #ffffff24; border-radius: 8px; background: #ffffff10; padding: 2px 5px; text-align: right }
.ss-menu { display: flex; gap: 8px; flex-wrap: wrap; justify-content: center }
.ss-menu button { border: 1px solid #ffc15e66; border-radius: 999px; background: #1c2038d9; padding: 7px 16px; font-weight: 650; cursor: pointer }
.ss-hint { margin: 0; flex-basis: 100%; text-align: center; text-wrap: balance; font-size: 14px; color: #cfdaf8 }
.game:has(.game-side:not([hidden])) .ss-foot { right: 296px }
@media (min-width: 760px) and (min-height: 480px) { .ss-slides { display: grid; grid-template-columns: 1fr 1fr 1fr; gap: 18px }
  .ss-slide { grid-template-columns: 1fr 78px; gap: 2px } .ss-slide input[type=range] { grid-row: 2; grid-column: 1 / 3 } }
@media (pointer: coarse) { .ss-pick input, .ss-pick button, .ss-card button, .ss-menu button { min-height: 44px } .ss .ss-label { padding: 13px 6px; top: -22px; min-width: 44px }
  .ss-jpl td button { min-height: 30px } .ss-sky :is(button, select) { min-height: 44px } .ss-card .ss-end { min-height: 30px } .ss input[type=range] { height: 44px } }
@media (max-width: 759px), (max-height: 479px) { .ss-date { left: 12px; top: 66px } .ss-date > span { max-width: 172px } .ss-date b { font-size: 20px } .ss-foot { left: 8px; right: 8px; gap: 5px }
  .game:has(.game-side:not([hidden])) .ss-foot { right: 8px } .ss-hint { font-size: 13px } .ss-card { padding: 8px 10px; gap: 4px }
  .ss-jpl { width: auto; max-width: 312px; padding: 4px 9px } .ss-slide { grid-template-columns: 62px 1fr 74px }
  .ss-date > em:not(:empty) { margin-top: 14px } .ss-pick { position: fixed; left: 190px; top: 64px; margin: 0; gap: 4px } .ss-pick input { width: 122px; padding: 5px 4px; font-size: 12px } .ss-pick button { padding: 5px 7px; font-size: 12px } .ss-time { grid-template-columns: auto minmax(90px, 1fr) auto; width: 100% } }
@media (max-width: 389px) { .ss-pick { left: auto; right: 8px } .ss-pick input { width: 110px; box-sizing: border-box } }
@media (max-width: 345px) { .ss-date b small { display: none } }
@media (max-width: 699px) { .ss-sky[open] { max-height: calc(100vh - 500px) } }
@media (max-height: 479px) { .ss-jpl[open] { max-height: calc(100vh - 214px) } }
/* The list ends above the missions. */
@media (min-height: 480px) and (max-height: 659px) { .ss-jpl[open]:not(.ss-sky) { max-height: calc(100vh - 282px - var(--bar, 58px)) } }
/* Card and lists together would leave no room for the flight. */
@media (max-width: 699px), (max-height: 659px) { .ss:has(.ss-card) .ss-jpl { display: none } }
@media (min-width: 700px) and (max-height: 479px) { .ss-card { position: fixed; right: 8px; bottom: 8px; width: 330px; max-height: calc(100% - 70px); overflow: auto }
  .ss-menu { position: fixed; right: 12px; bottom: 12px; width: 220px; display: grid } .ss-time { width: calc(100% - 350px); justify-self: start } }
/* Where the card has no room for the hint beside its controls. */
@media (max-width: 829px) and (max-height: 699px) { .ss-goal span { display: none } .ss-card .ss-row { gap: 5px } .ss-card .ss-row button { padding: 5px }
  .ss-card .ss-slide { height: 36px } }
@media (min-width: 830px) and (max-height: 479px) { .ss-card { width: 350px; max-height: calc(100% - 16px) } .ss-goal span { display: none }
  .ss-card .ss-row { gap: 5px } .ss-card .ss-row button { padding: 5px 8px } .ss-card .ss-slide { height: 36px } .ss-time { width: calc(100% - 370px) } }
`;
