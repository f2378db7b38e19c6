// SPDX-License-Identifier: GPL-3.0-or-later
// Which points a plot shows, and which of them a line joins.

// The parameters told apart by lines: with a list of views there is one line.
function groupingNames() {
  if (!table.crossed || state.x === 'view') return [];
  return axes.map((axis) => axis.name).filter((name) => name !== state.x);
}

function compareX(a, b) {
  return isNumber(a.x) && isNumber(b.x) ? a.x - b.x : 0;
}

// Lines in the order of their parameters' values: { name, points: [{ index, x, y }] }, where y is
// null for a view without this number.
function plotLines() {
  const names = groupingNames();
  const lines = new Map();
  rows.forEach((row, index) => {
    const key = names.map((name) => row[name]).join('\n');
    if (!lines.has(key)) lines.set(key, { row, names, points: [] });
    const y = isNumber(row[state.y]) ? row[state.y] : null;
    lines.get(key).points.push({ index, x: row[state.x] ?? null, y });
  });
  const inOrder = [...lines.values()];
  for (const axis of axes.filter(({ name }) => names.includes(name)).reverse())
    inOrder.sort((a, b) => axis.indexOf.get(a.row[axis.name]) - axis.indexOf.get(b.row[axis.name]));
  if (table.crossed || state.x === 'view') for (const line of inOrder) line.points.sort(compareX);
  return inOrder;
}

function isPlaced(point) {
  return point.x !== null && point.y !== null;
}

// Joined from point to point, broken where a view has no number.
function linePath(points, placeX, placeY) {
  let path = '', pen = 'M';
  for (const point of points) {
    if (!isPlaced(point)) {
      pen = 'M';
      continue;
    }
    path += `${pen}${placeX(point.x).toFixed(1)} ${placeY(point.y).toFixed(1)}`;
    pen = 'L';
  }
  return path;
}

// Along a ramp from low to high, as a map's tints are.
function lineColour(place, count) {
  const share = count < 2 ? 0 : place / (count - 1);
  return `color-mix(in oklab, var(--ramp-high) ${Math.round(100 * share)}%, var(--ramp-low))`;
}
