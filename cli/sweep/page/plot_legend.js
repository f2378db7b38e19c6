// SPDX-License-Identifier: GPL-3.0-or-later
// Which line is which: each by name, or the ends of the ramp where there are many.

const mostNamedLines = 8;
const legend = document.getElementById('plot-legend');

function lineName(line) {
  return line.names.map((name) => valueText(name, line.row[name])).join(', ');
}

function makeSwatch(line, place, count) {
  const entry = document.createElement('span');
  entry.className = 'entry';
  entry.style.setProperty('--line', lineColour(place, count));
  entry.textContent = lineName(line);
  line.entry = entry;
  return entry;
}

function makeRamp(lines) {
  const ramp = document.createElement('span');
  ramp.className = 'ramp';
  return [lineName(lines[0]), ramp, lineName(lines[lines.length - 1])];
}

function showLegend(lines) {
  legend.replaceChildren();
  if (lines.length < 2) return;
  const title = document.createElement('span');
  title.className = 'legend-title';
  title.textContent = lines[0].names.map(labelOf).join(', ');
  const parts = lines.length <= mostNamedLines
    ? lines.map((line, place) => makeSwatch(line, place, lines.length)) : makeRamp(lines);
  legend.append(title, ...parts);
}

function markLegend(current) {
  for (const line of plotted.lines) line.entry?.classList.toggle('current', line === current);
}
