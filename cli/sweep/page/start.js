// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the page together.

function showHeading() {
  const failed = rows.filter((row) => row.error).length;
  const missing = countMissing();
  const parts = [countText(rows.length, 'view', 'views')];
  if (failed) parts.push(`${numberText(failed)} failed`);
  if (missing > 0) parts.push(`${numberText(missing)} not in this table`);
  document.getElementById('title').textContent = table.title;
  document.getElementById('summary').textContent = parts.join(' · ');
  document.title = `${table.title} – sweep`;
  const { name, version, commit } = table.program;
  document.getElementById('made-by').textContent = `Drawn by ${name} ${version} (${commit}).`;
}

function watchTheme() {
  const redraw = () => {
    redrawStage();
    redrawThumbnails();
  };
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
}

function startViews() {
  Object.assign(state, stateFromAddress());
  startControls();
  startStage();
  startNumbers();
  startPlot();
  startThumbnails();
  watchTheme();
  addEventListener('hashchange', () => change(stateFromAddress()));
}

function start() {
  showHeading();
  if (rows.length > 0) startViews();
  document.querySelector('main').hidden = rows.length === 0;
  document.documentElement.dataset.ready = 'true';
}

start();
