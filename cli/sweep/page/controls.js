// SPDX-License-Identifier: GPL-3.0-or-later
// What turns the view: sliders, play, keys, and dragging the drawing.

const playStep_ms = 125;
const calmPlayStep_ms = 500;
let playing = { axis: null, timer: 0 };

function step(axis, direction) {
  if (axis) change({ index: nextAlong(state.index, axis, direction) });
}

function stopPlay() {
  clearInterval(playing.timer);
  playing = { axis: null, timer: 0 };
  showPlaying();
}

function startPlay(axis) {
  stopPlay();
  const calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
  const timer = setInterval(() => step(axis, 1), calm ? calmPlayStep_ms : playStep_ms);
  playing = { axis, timer };
  showPlaying();
}

function togglePlay(axis) {
  if (playing.axis === axis) stopPlay();
  else if (axis) startPlay(axis);
}

function showPlaying() {
  for (const axis of axes) {
    const on = playing.axis === axis;
    axis.playButton.classList.toggle('playing', on);
    axis.playButton.setAttribute('aria-label', `${on ? 'Pause' : 'Play'} ${labelOf(axis.name)}`);
  }
}

function makePlayButton(axis) {
  const button = document.createElement('button');
  button.type = 'button';
  button.className = 'play';
  button.addEventListener('click', () => togglePlay(axis));
  return button;
}

function makeSlider(axis) {
  const slider = document.createElement('input');
  slider.type = 'range';
  slider.id = `slider-${axes.indexOf(axis)}`;
  slider.dataset.axis = axis.name;
  slider.min = 0;
  slider.max = axis.values.length - 1;
  slider.step = 1;
  slider.addEventListener('input', () => {
    stopPlay();
    change({ index: nearestAlong(state.index, axis, slider.valueAsNumber) });
    showSliders();
  });
  return slider;
}

// One row a slider: play, name, value, and the slider under them.
function makeControl(axis) {
  axis.playButton = makePlayButton(axis);
  axis.slider = makeSlider(axis);
  axis.output = document.createElement('output');
  axis.output.htmlFor = axis.slider.id;
  const label = document.createElement('label');
  label.htmlFor = axis.slider.id;
  label.textContent = labelOf(axis.name);
  label.title = columnOf.get(axis.name)?.about ?? '';
  const control = document.createElement('div');
  control.className = 'control';
  control.append(axis.playButton, label, axis.output, axis.slider);
  return control;
}

function axisText(axis, row) {
  if (axis.name !== 'view') return valueText(axis.name, row[axis.name]);
  return `${numberText(row.view)}${table.varied.length ? ' · ' + placeText(row) : ''}`;
}

function showSliders() {
  const row = rows[state.index];
  for (const axis of axes) {
    const place = axis.indexOf.get(row[axis.name]);
    axis.slider.value = place;
    axis.slider.style.setProperty('--filled', `${(100 * place) / (axis.values.length - 1)}%`);
    axis.slider.setAttribute('aria-valuetext', axisText(axis, row));
    axis.output.textContent = axisText(axis, row);
  }
}

function secondAxis() {
  return axes.find((axis) => axis !== turningAxis) ?? null;
}

const keyMoves = {
  ArrowRight: () => [turningAxis, 1],
  ArrowLeft: () => [turningAxis, -1],
  ArrowUp: () => [secondAxis(), 1],
  ArrowDown: () => [secondAxis(), -1],
};

// Keys that the focused control uses itself are left to it.
function isTakenBy(target, key) {
  if (target.closest('select, textarea')) return true;
  if (target.matches('input[type=range]')) return key !== ' ';
  return key === ' ' && target.closest('button, input, a') !== null;
}

function pressKey(event) {
  if (event.ctrlKey || event.altKey || event.metaKey || isTakenBy(event.target, event.key)) return;
  if (event.key === ' ' && turningAxis) {
    togglePlay(playing.axis ?? turningAxis);
    event.preventDefault();
  } else if (keyMoves[event.key]) {
    const [axis, direction] = keyMoves[event.key]();
    if (!axis) return;
    stopPlay();
    step(axis, direction);
    event.preventDefault();
  }
}

// Dragging across the whole drawing passes every view once; leftwards goes on, as on a turntable.
function startDrag(down) {
  if (!turningAxis || down.button !== 0) return;
  const axis = turningAxis;
  const start = axis.indexOf.get(rows[state.index][axis.name]);
  const count = axis.values.length;
  const step_px = Math.max(6, sheet.clientWidth / count);
  stopPlay();
  sheet.setPointerCapture(down.pointerId);
  const move = (event) => {
    const steps = Math.round((down.clientX - event.clientX) / step_px);
    change({ index: nearestAlong(state.index, axis, (((start + steps) % count) + count) % count) });
  };
  const end = () => {
    sheet.removeEventListener('pointermove', move);
    for (const name of ['pointerup', 'pointercancel']) sheet.removeEventListener(name, end);
  };
  sheet.addEventListener('pointermove', move);
  for (const name of ['pointerup', 'pointercancel']) sheet.addEventListener(name, end);
}

function showHint() {
  const keyboard = document.createElement('span');
  keyboard.className = 'keyboard';
  const second = secondAxis() ? `, ↑ ↓ change ${labelOf(secondAxis().name)}` : '';
  keyboard.textContent = `; ← → do the same${second}, space plays`;
  const drag = `Drag the drawing sideways to change ${labelOf(turningAxis.name)}`;
  document.getElementById('keys').append(drag, keyboard, '.');
}

function startControls() {
  document.getElementById('sliders').append(...axes.map(makeControl));
  if (turningAxis) showHint();
  sheet.classList.toggle('turns', turningAxis !== null);
  document.addEventListener('keydown', pressKey);
  sheet.addEventListener('pointerdown', startDrag);
  sheet.addEventListener('dragstart', (event) => event.preventDefault());
  onChange((changed) => { if (changed.has('index')) showSliders(); });
  showSliders();
  showPlaying();
}
