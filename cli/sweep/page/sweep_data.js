// SPDX-License-Identifier: GPL-3.0-or-later
// What the program wrote, and the questions that the page asks of it.
'use strict';

function readJson(id) {
  return JSON.parse(document.getElementById(id).textContent);
}

const table = readJson('table');
const rows = table.views;
const columnOf = new Map(table.columns.map((column) => [column.name, column]));
// A row's own names: shown elsewhere, never as a number.
const identities = new Set(['view', 'name', 'file', 'error']);

let parsedPreviews = null;
// The preview of a row, or null. They are megabytes: parsed when the first one is wanted.
function previewOf(index) {
  parsedPreviews ??= readJson('previews');
  return parsedPreviews[index] ?? null;
}

function isNumber(value) {
  return typeof value === 'number' && Number.isFinite(value);
}

function isNumericColumn(name) {
  return rows.some((row) => isNumber(row[name]));
}

// Numbers in their order; anything else as it comes up.
function distinctValues(name) {
  const values = [...new Set(rows.map((row) => row[name]))];
  return values.every(isNumber) ? values.sort((a, b) => a - b) : values;
}

// An axis is what one slider moves along: a parameter of a crossed sweep, or the list of views.
function listAxes() {
  const names = table.crossed ? table.varied : ['view'];
  return names
    .map((name) => ({ name, values: distinctValues(name) }))
    .filter((axis) => axis.values.length > 1);
}

const axes = listAxes();
for (const axis of axes)
  axis.indexOf = new Map(axis.values.map((value, index) => [value, index]));

// Where a row stands on every axis.
function positionOf(row) {
  return axes.map((axis) => axis.indexOf.get(row[axis.name]));
}

const indexAtPosition = new Map(rows.map((row, index) => [positionOf(row).join(), index]));
const indexOfView = new Map(rows.map((row, index) => [row.view, index]));

// The row that differs from this one on one axis only, or undefined: shards may lack some.
function rowAlong(index, axis, place) {
  const position = positionOf(rows[index]);
  position[axes.indexOf(axis)] = place;
  return indexAtPosition.get(position.join());
}

// The next row along an axis in the direction given (1 or -1), round the end.
function nextAlong(index, axis, direction) {
  const count = axis.values.length;
  const start = axis.indexOf.get(rows[index][axis.name]);
  for (let step = 1; step <= count; ++step) {
    const found = rowAlong(index, axis, (start + (direction * step + count * step)) % count);
    if (found !== undefined) return found;
  }
  return index;
}

// The row nearest to a place on an axis; of two as near, the one farther along the way there.
function nearestAlong(index, axis, place) {
  const start = axis.indexOf.get(rows[index][axis.name]);
  const ahead = place >= start ? 1 : -1;
  for (let off = 0; off < axis.values.length; ++off)
    for (const direction of [ahead, -ahead]) {
      const found = rowAlong(index, axis, place + direction * off);
      if (found !== undefined) return found;
    }
  return index;
}

// What is played, dragged and stepped through first: the azimuth turns the view.
const turningAxis = axes.find((axis) => axis.name === 'azimuth_deg') ??
  [...axes].sort((a, b) => b.values.length - a.values.length)[0] ?? null;

const radians = Math.PI / 180;

// The cosine of the angle between a row's direction and the one that the program would choose. What
// the table doesn't tell is the same for all.
function nearnessToChosen(row) {
  const chosen = table.chosen;
  const of = (name) => (isNumber(row[name]) ? row[name] : chosen[name]) * radians;
  const elevation = of('elevation_deg'), chosenElevation = chosen.elevation_deg * radians;
  const turn = of('azimuth_deg') - chosen.azimuth_deg * radians;
  return Math.sin(elevation) * Math.sin(chosenElevation) +
    Math.cos(elevation) * Math.cos(chosenElevation) * Math.cos(turn);
}

// The rows nearest to the direction from which the terrain shows most: several where they differ in
// something else.
function listChosen() {
  if (!table.chosen) return new Set();
  const nearness = rows.map((row) => row.error ? -2 : nearnessToChosen(row));
  const most = Math.max(-1, ...nearness);
  return new Set(rows.filter((row, index) => nearness[index] > most - 1e-12));
}
const chosenRows = listChosen();
const chosenText = 'shows most of the terrain';

// How many views the sweep has beyond those of this table, as far as the table can tell.
function countMissing() {
  const least = Math.min(rows.length, 1);
  const combinations = axes.reduce((count, axis) => count * axis.values.length, least);
  const numbered = rows.reduce((most, row) => Math.max(most, row.view + 1), 0);
  return Math.max(table.views_planned ?? 0, combinations, numbered) - rows.length;
}
