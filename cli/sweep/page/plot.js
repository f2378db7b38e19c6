// SPDX-License-Identifier: GPL-3.0-or-later
// One column over one parameter; clicking near a point selects its view.

const plotBox = document.getElementById('plot');
let plotted = { svg: null, points: [], lines: [] };

function svgElement(name, attributes, text) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== undefined) element.textContent = text;
  return element;
}

function makeScale(name, values, begin, end, most, upToTicks) {
  if (!values.every(isNumber)) return wordScale(values, begin, end);
  return numberScale(values, begin, end, most, { upToTicks, inDegrees: unitOf(name) === 'deg' });
}

function lineElement(name, x1, y1, x2, y2) {
  return svgElement('line', { class: name, x1, y1, x2, y2 });
}

function textElement(name, x, y, text) {
  return svgElement('text', { class: name, x, y }, text);
}

function drawAxes(svg, frame, x, y) {
  const { left, right, bottom } = frame;
  for (const tick of y.ticks) {
    const at = y.place(tick.value);
    svg.append(lineElement('grid', left, at, right, at),
      textElement('y-tick', left - 8, at, tick.text));
  }
  for (const tick of x.ticks) {
    const at = x.place(tick.value);
    svg.append(lineElement('tick', at, bottom, at, bottom + 5),
      textElement('x-tick', at, bottom + 18, tick.text));
  }
  svg.append(lineElement('base', left, bottom, right, bottom),
    textElement('name', 0, 11, labelWithUnit(state.y)),
    textElement('name end', right, bottom + 36, labelWithUnit(state.x)));
}

function drawLines(svg, lines, x, y) {
  const points = [];
  const radius = rows.length > 150 ? 1.5 : 2.4;
  lines.forEach((line, place) => {
    const colour = lineColour(place, lines.length);
    const group = svgElement('g', { class: 'line', style: `--line: ${colour}` });
    group.append(svgElement('path', { d: linePath(line.points, x.place, y.place) }));
    for (const point of line.points) {
      if (!isPlaced(point)) continue;
      const at = { ...point, line, left: x.place(point.x), top: y.place(point.y) };
      const centre = { cx: at.left.toFixed(1), cy: at.top.toFixed(1) };
      group.append(svgElement('circle', { class: 'point', ...centre, r: radius }));
      points.push(at);
    }
    line.group = group;
    svg.append(group);
  });
  return points;
}

function describePlot(points) {
  const count = countText(points.length, 'point', 'points');
  return `${labelWithUnit(state.y)} over ${labelWithUnit(state.x)}: ${count}`;
}

function textWidth(texts) {
  return 7 * Math.max(...texts.map((text) => text.length));
}

// The vertical scale first: its numbers say how much room the left margin needs.
function drawPlot() {
  const lines = state.y ? plotLines() : [];
  const shown = lines.flatMap((line) => line.points).filter(isPlaced);
  plotBox.replaceChildren();
  showLegend(lines);
  document.getElementById('plot-about').textContent = columnOf.get(state.y)?.about ?? '';
  if (shown.length === 0) {
    plotBox.textContent = 'No view has this number.';
    plotted = { svg: null, points: [], lines: [] };
    return;
  }
  const width = Math.max(240, plotBox.clientWidth);
  const height = Math.round(Math.min(380, Math.max(230, width * 0.56)));
  const frame = { top: 26, right: width - 12, bottom: height - 44 };
  const yValues = shown.map((point) => point.y), xValues = shown.map((point) => point.x);
  const y = makeScale(state.y, yValues, frame.bottom, frame.top, 6, true);
  frame.left = 16 + textWidth(y.ticks.map((tick) => tick.text));
  const x = makeScale(state.x, xValues, frame.left + 8, frame.right - 8, width / 70, false);
  const svg = svgElement('svg', { width, height, viewBox: `0 0 ${width} ${height}`, role: 'img' });
  drawAxes(svg, frame, x, y);
  const points = drawLines(svg, lines, x, y);
  svg.setAttribute('aria-label', describePlot(points));
  svg.append(svgElement('line', { class: 'mark-line', y1: frame.top - 6, y2: frame.bottom }),
    svgElement('circle', { class: 'mark', r: 5 }), svgElement('circle', { class: 'near', r: 6 }));
  plotBox.append(svg, makeReadout());
  plotted = { svg, points, lines, x };
  markPlot();
}

// The current view: a line at its parameter, a ring on its point, its own line in front.
function markPlot() {
  if (!plotted.svg) return;
  const at = plotted.points.find((point) => point.index === state.index);
  const mark = plotted.svg.querySelector('.mark');
  const markLine = plotted.svg.querySelector('.mark-line');
  mark.style.display = markLine.style.display = at ? '' : 'none';
  for (const line of plotted.lines) line.group.classList.toggle('current', line === at?.line);
  if (!at) return;
  plotted.svg.insertBefore(at.line.group, markLine);
  markLine.setAttribute('x1', at.left);
  markLine.setAttribute('x2', at.left);
  mark.setAttribute('cx', at.left);
  mark.setAttribute('cy', at.top);
  markLegend(at.line);
}

function nearestPoint(event) {
  const box = plotted.svg.getBoundingClientRect();
  const left = event.clientX - box.left, top = event.clientY - box.top;
  let nearest = null, least = Infinity;
  for (const point of plotted.points) {
    const distance = Math.hypot(point.left - left, point.top - top);
    if (distance < least) [nearest, least] = [point, distance];
  }
  return nearest;
}

function makeReadout() {
  const readout = document.createElement('div');
  readout.className = 'readout';
  readout.hidden = true;
  return readout;
}

function showReadout(point) {
  const readout = plotBox.querySelector('.readout');
  const ring = plotted.svg.querySelector('.near');
  const row = rows[point.index];
  readout.hidden = false;
  readout.replaceChildren();
  const value = document.createElement('strong');
  value.textContent = valueText(state.y, row[state.y]);
  readout.append(value, placeText(row) || row.name);
  const room = plotBox.clientWidth - readout.offsetWidth;
  readout.style.left = `${Math.max(0, Math.min(room, point.left - readout.offsetWidth / 2))}px`;
  const above = point.top - readout.offsetHeight - 12;
  readout.style.top = `${above >= 0 ? above : point.top + 14}px`;
  ring.setAttribute('cx', point.left);
  ring.setAttribute('cy', point.top);
  ring.style.display = 'inline';
}

function hideReadout() {
  if (!plotted.svg) return;
  plotBox.querySelector('.readout').hidden = true;
  plotted.svg.querySelector('.near').style.display = 'none';
}

function fillChoice(id, names, key) {
  const choice = document.getElementById(id);
  choice.append(...names.map((name) => new Option(labelWithUnit(name), name)));
  choice.value = state[key] ?? '';
  choice.addEventListener('change', () => change({ [key]: choice.value }));
  onChange(() => { choice.value = state[key] ?? ''; });
}

function startPlot() {
  document.getElementById('plot-section').hidden = rows.length < 2 || measureNames.length === 0;
  fillChoice('plot-y', measureNames, 'y');
  fillChoice('plot-x', parameterNames, 'x');
  plotBox.addEventListener('pointermove', (event) => {
    if (plotted.svg) showReadout(nearestPoint(event));
  });
  plotBox.addEventListener('pointerleave', hideReadout);
  plotBox.addEventListener('click', (event) => {
    if (!plotted.svg) return;
    stopPlay();
    change({ index: nearestPoint(event).index });
  });
  onChange((changed) => {
    if (changed.has('x') || changed.has('y')) drawPlot();
    else if (changed.has('index')) markPlot();
  });
  let drawnWidth = 0;
  new ResizeObserver(() => {
    if (plotBox.clientWidth === drawnWidth) return;
    drawnWidth = plotBox.clientWidth;
    drawPlot();
  }).observe(plotBox);
}
