// SPDX-License-Identifier: GPL-3.0-or-later
// Every view, small. Only those near the screen are drawn: hundreds of canvases would be slow.

const thumbnailLeastInk = 0.28;
const thumbnails = [];

const thumbnailObserver = new IntersectionObserver((entries) => {
  for (const entry of entries) drawThumbnail(entry.target, entry.isIntersecting);
}, { rootMargin: '200px' });

function drawThumbnail(canvas, near) {
  const preview = previewOf(Number(canvas.dataset.index));
  canvas.toggleAttribute('data-drawn', near);
  if (near) drawPreview(canvas, preview, thumbnailLeastInk);
  else clearCanvas(canvas);
}

function makePicture(index) {
  const row = rows[index];
  const preview = row.error ? null : previewOf(index);
  if (!preview) {
    const text = document.createElement('span');
    text.className = 'no-picture';
    text.textContent = row.error ? row.error : 'no preview';
    return text;
  }
  const canvas = document.createElement('canvas');
  canvas.dataset.index = index;
  canvas.style.aspectRatio = preview.size_mm.join(' / ');
  thumbnailObserver.observe(canvas);
  return canvas;
}

// What differs inside its group: the others are in the group's heading.
function thumbnailText(row) {
  if (axes.length < 2) return placeText(row) || row.name;
  return valueText(turningAxis.name, row[turningAxis.name]);
}

function makeThumbnail(index) {
  const row = rows[index];
  const button = document.createElement('button');
  const caption = document.createElement('span');
  button.type = 'button';
  button.className = 'thumbnail';
  button.classList.toggle('failed', Boolean(row.error));
  button.tabIndex = -1;
  const isChosen = chosenRows.has(row);
  const note = row.error ? `failed: ${row.error}` : isChosen ? chosenText : '';
  button.classList.toggle('chosen', isChosen);
  button.title = note ? `${row.name}: ${row.error ?? note}` : row.name;
  button.setAttribute('aria-label', `${placeText(row) || row.name}${note ? `, ${note}` : ''}`);
  caption.className = 'thumbnail-caption';
  caption.textContent = thumbnailText(row) + (isChosen ? ' ★' : '');
  button.append(makePicture(index), caption);
  button.addEventListener('click', () => {
    stopPlay();
    change({ index });
  });
  thumbnails[index] = button;
  const item = document.createElement('li');
  item.append(button);
  return item;
}

// Views that differ only in the turning axis stand together.
function groupThumbnails() {
  const others = axes.filter((axis) => axis !== turningAxis).map((axis) => axis.name);
  const groups = new Map();
  rows.forEach((row, index) => {
    const heading = placeText(row, others);
    if (!groups.has(heading)) groups.set(heading, []);
    groups.get(heading).push(index);
  });
  return groups;
}

function makeThumbnailGroup([heading, indices]) {
  const group = document.createElement('div');
  const list = document.createElement('ol');
  list.className = 'thumbnails';
  list.append(...indices.map(makeThumbnail));
  if (heading) {
    const title = document.createElement('h3');
    title.textContent = heading;
    group.append(title);
  }
  group.append(list);
  return group;
}

let markedThumbnail = null;
function markThumbnail() {
  const button = thumbnails[state.index];
  const hadFocus = markedThumbnail !== null && document.activeElement === markedThumbnail;
  if (markedThumbnail) {
    markedThumbnail.removeAttribute('aria-current');
    markedThumbnail.tabIndex = -1;
  }
  button.setAttribute('aria-current', 'true');
  button.tabIndex = 0; // the only one: tab passes hundreds in one step
  if (hadFocus) button.focus();
  markedThumbnail = button;
}

function redrawThumbnails() {
  for (const canvas of document.querySelectorAll('canvas[data-drawn]')) drawThumbnail(canvas, true);
}

function startThumbnails() {
  const place = document.getElementById('thumbnails');
  place.append(...[...groupThumbnails()].map(makeThumbnailGroup));
  onChange((changed) => { if (changed.has('index')) markThumbnail(); });
  new ResizeObserver(redrawThumbnails).observe(place);
  markThumbnail();
}
