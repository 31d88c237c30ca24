// Runs in every page that `npm start` serves: covers it while the games are built for the first time and with the
// messages of a bad build, and reloads it after a good one.
(() => {
  /** @type {number | undefined} */
  let shown;
  new EventSource('/live').onmessage = ({ data }) => {
    const { version, problem, news } = JSON.parse(data);
    document.getElementById('build-news')?.remove();
    if (problem || news) {
      const box = document.createElement('pre');
      box.id = 'build-news';
      box.textContent = problem || news;
      box.style.cssText =
        'position:fixed;inset:0;z-index:99999;margin:0;padding:2rem;overflow:auto;white-space:pre-wrap;' +
        `font:14px/1.5 ui-monospace,monospace;${problem ? 'background:#1b1016f2;color:#ffb4b4' : 'background:#0d1226f2;color:#eef1fb'}`;
      document.body.append(box);
    } else if (shown !== undefined && shown !== version) location.reload();
    shown ??= version;
  };
})();
