// ---- The screen ------------------------------------------------------------------------------------------------
let state = null, zoom = 1, panX = 0, panY = 0, inspect = false, split = 0.5;
// Where the picture lies on the screen, in CSS pixels.
function placed() {
  const w = screen.clientWidth, h = screen.clientHeight, film = current ? [current.width, current.height] : [16, 9];
  const fit = Math.min(w / film[0], h / film[1]) * zoom, width = film[0] * fit, height = film[1] * fit;
  return { x: (w - width) / 2 + panX, y: (h - height) / 2 + panY, width, height, scale: fit };
}
let drawing = false;
function draw() {
  if (drawing) return;
  drawing = true;
  requestAnimationFrame(() => {
    drawing = false;
    const ratio = devicePixelRatio, w = Math.round(screen.clientWidth * ratio), h = Math.round(screen.clientHeight * ratio);
    if (screen.width !== w || screen.height !== h) { screen.width = w; screen.height = h; }
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.fillStyle = getComputedStyle(screen).backgroundColor;
    pen.fillRect(0, 0, w, h);
    if (!current) return;
    const at = placed();
    render(current, current.layer);
    pen.imageSmoothingEnabled = at.scale < 2;
    pen.drawImage(current.canvas, at.x, at.y, at.width, at.height);
    if (reference) {
      render(reference, "reference");
      const x = at.x + at.width * split;
      pen.save();
      pen.beginPath();
      pen.rect(at.x, at.y, x - at.x, at.height);
      pen.clip();
      pen.drawImage(reference.canvas, at.x, at.y, at.width, at.height);
      pen.restore();
      pen.fillStyle = "#e0a458";
      pen.fillRect(x - 0.5, at.y, 1, at.height);
    }
    if (box) outline(Math.min(box.x0, box.x1), Math.min(box.y0, box.y1), Math.abs(box.x1 - box.x0), Math.abs(box.y1 - box.y0), [4, 4]);
    else if (state?.focus) {
      const [x0, y0, x1, y1] = state.focus;
      outline(at.x + x0 * at.scale, at.y + y0 * at.scale, (x1 - x0) * at.scale, (y1 - y0) * at.scale, []);
    }
    document.body.dataset.drawn = current.number;
  });
}
// Draws a rectangle, given in CSS pixels, so that it is visible on any picture.
function outline(x, y, width, height, dashes) {
  for (const [colour, line] of [["#191817", 4], ["#e0a458", 2]]) {
    pen.strokeStyle = colour;
    pen.lineWidth = line;
    pen.setLineDash(line === 2 ? dashes : []);
    pen.strokeRect(x, y, width, height);
  }
}
new ResizeObserver(draw).observe(screen);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
