// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and names as people read them.

const thinSpace = '\u202f';
const minus = '\u2212';

function groupThousands(digits) {
  return digits.length < 5 ? digits : digits.replace(/\B(?=(\d{3})+$)/g, thinSpace);
}

// With as many decimals as asked for.
function fixedText(value, decimals) {
  const [whole, fraction] = Math.abs(value).toFixed(decimals).split('.');
  const sign = value < 0 && Number(value.toFixed(decimals)) !== 0 ? minus : '';
  return sign + groupThousands(whole) + (fraction ? '.' + fraction : '');
}

// Whole numbers in full, others to four significant digits.
function numberText(value) {
  const size = Math.abs(value);
  if (Number.isInteger(value) && size < 1e15) return fixedText(value, 0);
  if (size >= 1e15 || size < 1e-4) return value.toExponential(3).replace('-', minus);
  const decimals = Math.max(0, 3 - Math.floor(Math.log10(size)));
  return fixedText(value, decimals).replace(/(\.\d*?)0+$/, '$1').replace(/\.$/, '');
}

function unitText(unit) {
  if (!unit || unit === '1') return '';
  return unit === 'deg' ? '°' : ' ' + unit;
}

function unitOf(name) {
  return columnOf.get(name)?.unit ?? '';
}

function valueText(name, value) {
  if (value === null || value === undefined) return '–';
  return isNumber(value) ? numberText(value) + unitText(unitOf(name)) : String(value);
}

// "horizon_largest" as "horizon largest"; a unit at its end is told by the unit.
function labelOf(name) {
  const unit = unitOf(name);
  const bare = unit && name.endsWith('_' + unit) ? name.slice(0, -unit.length - 1) : name;
  return bare.replaceAll('_', ' ');
}

function labelWithUnit(name) {
  const unit = unitOf(name);
  return labelOf(name) + (unit && unit !== '1' ? `, ${unit === 'deg' ? '°' : unit}` : '');
}

// "azimuth 30°, elevation 10°": what tells this view from the others.
function placeText(row, names = table.varied) {
  const parts = names.map((name) => `${labelOf(name)} ${valueText(name, row[name])}`);
  return parts.join(', ');
}

function countText(count, one, many) {
  return `${numberText(count)} ${count === 1 ? one : many}`;
}
