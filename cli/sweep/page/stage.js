// SPDX-License-Identifier: GPL-3.0-or-later
// The current view, large: its preview, the drawing's file itself, or why there is neither.

const sheet = document.getElementById('sheet');
const drawing = document.getElementById('drawing');
const fullDrawing = document.getElementById('full-drawing');
const sheetMessage = document.getElementById('sheet-message');
const heroLeastInk = 0.45;
const defaultRatio = 297 / 210;

function formatOf(file) {
  const name = file.split('/').pop();
  return name.includes('.') ? name.split('.').pop().toLowerCase() : '';
}

// Relative to the page, whatever is in the name.
function addressOfFile(file) {
  return './' + file.split('/').map(encodeURIComponent).join('/');
}

function hasFile(row) {
  return Boolean(row.file) && !row.error;
}

function browserShows(row) {
  return hasFile(row) && ['svg', 'png'].includes(formatOf(row.file));
}

function showMessage(text) {
  sheetMessage.textContent = text;
  sheetMessage.hidden = !text;
  sheet.classList.toggle('has-message', Boolean(text));
}

function showSheetSize(preview) {
  const ratio = preview ? preview.size_mm[0] / preview.size_mm[1] : defaultRatio;
  sheet.style.setProperty('--ratio', ratio.toFixed(5));
}

function showPreview(row, preview) {
  drawing.hidden = !preview;
  if (preview) drawPreview(drawing, preview, heroLeastInk);
  drawing.setAttribute('aria-label', `Drawing of the terrain: ${placeText(row) || row.name}`);
}

// The file replaces the preview once it is read; where it can't be, the preview stays.
function showFile(row, wanted) {
  if (!wanted) {
    fullDrawing.hidden = true;
    fullDrawing.removeAttribute('src');
    return;
  }
  const address = addressOfFile(row.file);
  if (fullDrawing.getAttribute('src') === address) return;
  fullDrawing.hidden = true;
  fullDrawing.alt = `Full drawing: ${placeText(row) || row.name}`;
  fullDrawing.onload = () => { fullDrawing.hidden = false; };
  fullDrawing.onerror = () =>
    showMessage(`${row.file} can’t be read: is it still beside this page?`);
  fullDrawing.src = address;
}

function showCaption(row) {
  document.getElementById('view-name').textContent =
    row.name + (chosenRows.has(row) ? ` ★ ${chosenText}` : '');
  const link = document.getElementById('full-link');
  link.hidden = !hasFile(row);
  if (hasFile(row)) {
    link.href = addressOfFile(row.file);
    link.textContent = `Open the ${formatOf(row.file).toUpperCase() || 'file'}`;
  }
  document.getElementById('full-choice').hidden = !browserShows(row);
  document.getElementById('full-switch').checked = state.full;
}

function showCompass(row) {
  const compass = document.getElementById('compass');
  const azimuth_deg = row.azimuth_deg;
  compass.toggleAttribute('hidden', !isNumber(azimuth_deg) || Boolean(row.error));
  if (!isNumber(azimuth_deg)) return;
  document.getElementById('compass-viewer').setAttribute('transform', `rotate(${azimuth_deg})`);
  const where = `The viewer stands at azimuth ${numberText(azimuth_deg)}°, north is up`;
  compass.setAttribute('aria-label', where);
}

function showStage() {
  const row = rows[state.index];
  const preview = previewOf(state.index);
  const wantsFile = browserShows(row) && (state.full || !preview);
  showMessage(row.error ? `This view failed: ${row.error}`
    : preview || wantsFile ? '' : 'There is no preview of this view: open its file.');
  showSheetSize(preview);
  showPreview(row, row.error ? null : preview);
  showFile(row, wantsFile);
  showCaption(row);
  showCompass(row);
}

function redrawStage() {
  const preview = previewOf(state.index);
  if (preview && !rows[state.index].error) drawPreview(drawing, preview, heroLeastInk);
}

function startStage() {
  const fullSwitch = document.getElementById('full-switch');
  fullSwitch.addEventListener('change', () => change({ full: fullSwitch.checked }));
  onChange((changed) => { if (changed.has('index') || changed.has('full')) showStage(); });
  new ResizeObserver(redrawStage).observe(sheet);
  showStage();
}
