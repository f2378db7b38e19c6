// SPDX-License-Identifier: GPL-3.0-or-later
// The current row's numbers. The name of a numeric one plots it.

const numberCells = new Map();

const mostLetters = 16;
function isWordy(name) {
  return rows.some((row) => typeof row[name] === 'string' && row[name].length > mostLetters);
}

function makeNumber(column) {
  const name = document.createElement('dt');
  const value = document.createElement('dd');
  let text = name;
  if (measureNames.includes(column.name)) {
    text = document.createElement('button');
    text.type = 'button';
    text.addEventListener('click', () => change({ y: column.name }));
    name.append(text);
  }
  text.textContent = labelOf(column.name);
  name.title = column.about ?? '';
  value.dataset.column = column.name;
  numberCells.set(column.name, { value, button: text === name ? null : text });
  const pair = document.createElement('div');
  pair.classList.toggle('varied', table.varied.includes(column.name));
  pair.classList.toggle('wordy', isWordy(column.name));
  pair.append(name, value);
  return pair;
}

function showNumbers() {
  const row = rows[state.index];
  for (const [name, cell] of numberCells) {
    cell.value.textContent = valueText(name, row[name]);
    cell.button?.setAttribute('aria-pressed', String(name === state.y));
  }
}

function startNumbers() {
  const shown = table.columns.filter((column) => !identities.has(column.name));
  document.getElementById('numbers').append(...shown.map(makeNumber));
  onChange((changed) => { if (changed.has('index') || changed.has('y')) showNumbers(); });
  showNumbers();
}
