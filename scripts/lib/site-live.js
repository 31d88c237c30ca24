// Runs in every page that `npm start` serves: reloads it after a good build, covers it with the messages after a bad one.
(() => {
  /** @type {number | undefined} */
  let shown;
  new EventSource('/live').onmessage = ({ data }) => {
    const { version, problem } = JSON.parse(data);
    document.getElementById('build-problem')?.remove();
    if (problem) {
      const box = document.createElement('pre');
      box.id = 'build-problem';
      box.textContent = problem;
      box.style.cssText =
        'position:fixed;inset:0;z-index:99999;margin:0;padding:2rem;overflow:auto;white-space:pre-wrap;' +
        'background:#1b1016f2;color:#ffb4b4;font:14px/1.5 ui-monospace,monospace';
      document.body.append(box);
    } else if (shown !== undefined && shown !== version) location.reload();
    shown ??= version;
  };
})();
