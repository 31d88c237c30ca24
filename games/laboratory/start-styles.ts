const styles = `
body { color: #eef1fb; font: 15px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, sans-serif; overflow: auto;
  background: radial-gradient(110% 60vh at 42% 0, #2c3a72 0%, #1a2349 45%, #0d1226 100%) no-repeat, #0d1226 }
.start { max-width: 1100px; margin: 0 auto; padding: 24px 20px 60px }
.start h1 { font-size: 34px; letter-spacing: -0.02em; margin: 4px 0 } .start p { margin: 0 0 14px; color: #b9c2e0 }
.start a { color: inherit; text-decoration: none } .start-home { color: #ffc15e !important; font-weight: 600; font-size: 13px }
.start input { width: 100%; box-sizing: border-box; font: inherit; font-size: 16px; padding: 11px 14px; border-radius: 12px;
  border: 1px solid #ffffff2c; background: #141b36; color: inherit }
.start input::placeholder { color: #b9c2e0; opacity: 1 }
.start-tags { display: flex; flex-wrap: wrap; gap: 6px; margin: 12px 0 }
.start-tags button { font: inherit; font-size: 13px; padding: 5px 12px; min-height: 32px; border-radius: 16px; cursor: pointer;
  border: 1px solid #ffffff24; background: #ffffff0f; color: inherit }
.start-tags button[aria-pressed=true] { background: #ffc15e; color: #1c1503 }
.start-tags button:hover { background: #ffffff22 } .start :focus-visible { outline: 2px solid #ffc15e; outline-offset: 2px }
.start-count { font-size: 13px } .start-problem { color: #ffdfe3 !important; background: #30142b; padding: 10px 14px; border-radius: 10px }
.start-new { display: inline-block; border: 1px solid #ffc15e; border-radius: 12px; padding: 9px 16px; color: #ffc15e !important; font-weight: 600 }
.start h2 { font-size: 16px; margin: 22px 0 8px; color: #b9c2e0 }
.start ul { list-style: none; margin: 0; padding: 0; display: grid; grid-template-columns: repeat(auto-fill, minmax(240px, 1fr)); gap: 12px }
.start li a { display: block; height: 100%; box-sizing: border-box; padding: 12px 14px; border-radius: 14px;
  border: 1px solid #ffffff1c; background: #141b36d9 } .start li a:hover { background: #212b56 }
.start-picture { aspect-ratio: 8 / 5; margin: -12px -14px 10px; border-radius: 14px 14px 0 0; overflow: hidden; background: #0d1430 }
.start-picture svg { display: block; width: 100%; height: 100% }
.start li b { display: block; font-weight: 600 } .start li span { font-size: 12.5px; color: #97a3c7 }
.start .start-striking ul { grid-template-columns: repeat(3, 1fr) }
@media (pointer: coarse) { .start-new { line-height: 26px } .start .start-home { display: inline-block; line-height: 44px } .start-tags button { min-height: 44px; border-radius: 22px } }
@media (max-width: 600px) { .start .start-striking ul { grid-template-columns: 1fr 1fr } .start { padding: 16px 14px 40px } .start h1 { font-size: 28px }
  .start-tags { flex-wrap: nowrap; overflow-x: auto; margin-inline: -14px; padding-inline: 14px; scrollbar-width: none }
  .start-tags button { flex: none; min-height: 44px; border-radius: 22px } .start ul { grid-template-columns: 1fr 1fr; gap: 10px }
  .start li a { padding: 10px } .start-picture { margin: -10px -10px 8px } .start li b { font-size: 14px; line-height: 1.3 } }
`;

export function addStartStyles(): void {
  const sheet = document.createElement('style');
  sheet.textContent = styles;
  document.head.append(sheet);
}
