// SPDX-License-Identifier: GPL-3.0-or-later
// A preview's strokes on a canvas, at the screen's own resolution.

const previewUnits_per_mm = 10;
// Thinner lines than this (in pixels of the screen) break up.
const leastLine_px = 0.7;

function themeColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

function setCanvasPixels(canvas) {
  const ratio = window.devicePixelRatio || 1;
  canvas.width = Math.max(1, Math.round(canvas.clientWidth * ratio));
  canvas.height = Math.max(1, Math.round(canvas.clientHeight * ratio));
}

// A line drawn wider than its pen gets paler by as much, but not faint: tones stay true.
function strokeLayer(context, layer, scale, leastInk, themeInk) {
  const pen_px = layer.pen_mm * previewUnits_per_mm * scale;
  const width_px = Math.max(pen_px, leastLine_px);
  context.lineWidth = width_px / scale;
  const ink = Math.max(leastInk, Math.min(1, pen_px / width_px));
  context.strokeStyle = layer.colour ?? themeInk;
  context.globalAlpha = (layer.colour ? 1 : 1 - (layer.grey ?? 0)) * ink;
  context.stroke(new Path2D(layer.path));
}

function drawPreview(canvas, preview, leastInk) {
  setCanvasPixels(canvas);
  const context = canvas.getContext('2d');
  const [width_mm, height_mm] = preview.size_mm;
  const scale = Math.min(canvas.width / width_mm, canvas.height / height_mm) / previewUnits_per_mm;
  context.setTransform(scale, 0, 0, scale,
    (canvas.width - width_mm * previewUnits_per_mm * scale) / 2,
    (canvas.height - height_mm * previewUnits_per_mm * scale) / 2);
  context.lineCap = context.lineJoin = 'round';
  const themeInk = themeColour('--ink');
  for (const layer of preview.layers) strokeLayer(context, layer, scale, leastInk, themeInk);
}

function clearCanvas(canvas) {
  canvas.width = canvas.height = 0;
}
