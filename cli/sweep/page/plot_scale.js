// SPDX-License-Identifier: GPL-3.0-or-later
// From values to pixels, and where an axis has its ticks.

const decimalSteps = [1, 2, 5, 10];
const degreeSteps = [1, 2, 5, 10, 15, 30, 45, 90, 180];

// The smallest round step with which `extent` has at most `most` of them.
function tickStep(extent, most, inDegrees) {
  const rough = extent / most;
  const round = inDegrees && degreeSteps.find((step) => step >= rough && rough > 0.5);
  if (round) return round;
  const power = 10 ** Math.floor(Math.log10(rough));
  return power * decimalSteps.find((step) => step * power >= rough * (1 - 1e-9));
}

// From nought where little of the axis is lost to it; never without extent.
function paddedRange(values, maySeeNought) {
  let low = values.reduce((least, value) => Math.min(least, value));
  let high = values.reduce((most, value) => Math.max(most, value));
  if (maySeeNought && low > 0 && low < 0.4 * high) low = 0;
  if (low === high) {
    const half = Math.abs(low) * 0.1 || 1;
    [low, high] = [low - half, high + half];
  }
  return [low, high];
}

function makeTicks(low, high, stepSize) {
  const decimals = Math.max(0, Math.min(12, -Math.floor(Math.log10(stepSize) + 1e-9)));
  const ticks = [];
  for (let i = Math.ceil(low / stepSize - 1e-9); i * stepSize <= high + stepSize * 1e-9; ++i)
    ticks.push({ value: i * stepSize, text: tickText(i * stepSize, decimals, high) });
  return ticks;
}

function tickText(value, decimals, high) {
  return Math.abs(high) >= 1e9 || decimals > 6 ? numberText(value) : fixedText(value, decimals);
}

// A scale of numbers from pixel `begin` to pixel `end`; a vertical one ends on whole ticks.
function numberScale(values, begin, end, most, options) {
  let [low, high] = paddedRange(values, options.upToTicks);
  const stepSize = tickStep(high - low, most, options.inDegrees);
  if (options.upToTicks) {
    low = Math.floor(low / stepSize + 1e-9) * stepSize;
    high = Math.ceil(high / stepSize - 1e-9) * stepSize;
  }
  const place = (value) => begin + ((value - low) / (high - low)) * (end - begin);
  return { place, ticks: makeTicks(low, high, stepSize) };
}

// A scale of words: one place each.
function wordScale(values, begin, end) {
  const words = [...new Set(values)];
  const place = (value) => begin + ((words.indexOf(value) + 0.5) / words.length) * (end - begin);
  return { place, ticks: words.map((word) => ({ value: word, text: String(word ?? '–') })) };
}
