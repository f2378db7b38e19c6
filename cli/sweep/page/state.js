// SPDX-License-Identifier: GPL-3.0-or-later
// What is chosen, kept in the address so that a link opens the same again.

const state = { index: 0, x: 'view', y: null, full: false };
const parameterNames = [...table.varied, 'view'];
const measureNames = table.columns
  .map((column) => column.name)
  .filter((name) => !identities.has(name) && isNumericColumn(name));

const listeners = [];
// The listener is called with the set of names in `state` that changed.
function onChange(listener) {
  listeners.push(listener);
}

function change(part) {
  const changed = new Set(Object.keys(part).filter((name) => state[name] !== part[name]));
  if (changed.size === 0) return;
  Object.assign(state, part);
  for (const listener of listeners) listener(changed);
  rememberSoon();
}

function defaultMeasure() {
  const liked = ['visible_share', 'horizon_largest', 'strokes', 'seconds'];
  return liked.find((name) => measureNames.includes(name)) ??
    measureNames.find((name) => !table.varied.includes(name)) ?? measureNames[0] ?? null;
}

function stateFromAddress() {
  const wanted = new URLSearchParams(location.hash.slice(1));
  const index = indexOfView.get(Number(wanted.get('view') ?? NaN));
  return {
    index: index ?? 0,
    x: parameterNames.includes(wanted.get('x')) ? wanted.get('x') : (turningAxis?.name ?? 'view'),
    y: measureNames.includes(wanted.get('y')) ? wanted.get('y') : defaultMeasure(),
    full: wanted.get('full') === '1',
  };
}

function addressOfState() {
  const parts = new URLSearchParams({ view: rows[state.index].view, x: state.x });
  if (state.y) parts.set('y', state.y);
  if (state.full) parts.set('full', '1');
  return '#' + parts;
}

// Browsers refuse more than a few changes of the address a second: only where it comes to rest.
let rememberTimer = 0;
function rememberSoon() {
  clearTimeout(rememberTimer);
  rememberTimer = setTimeout(() => history.replaceState(null, '', addressOfState()), 250);
}
