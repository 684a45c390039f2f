
// ---- Mouse and touch -------------------------------------------------------------------------------------------
const pointers = new Map(), pause = ms => new Promise(done => setTimeout(done, ms));
function onScreen(event) {
  const frame = screen.getBoundingClientRect();
  return [event.clientX - frame.left, event.clientY - frame.top];
}
// The middle of the pointers on the screen, and the distance between two of them.
function gesture() {
  const places = [...pointers.values()].map(onScreen), n = places.length;
  const [x, y] = [0, 1].map(i => places.reduce((sum, p) => sum + p[i], 0) / n);
  return { x, y, spread: n > 1 ? Math.hypot(places[0][0] - places[1][0], places[0][1] - places[1][1]) : 0 };
}
// A drag holds a point of the scene. Movements add up until the renderer has told which point it is.
let drag = null;
async function take(pans) {
  const mine = drag = { grip: null, pans, at: gesture(), x: 0, y: 0, closer: 1 };
  if (inspect || box) return;
  mine.grip = steering === "look" && !pans ? camera.eye : await pointAt(mine.at.x, mine.at.y);
  if (!drag || drag === mine) steer(mine);
}
function steer(d) {
  if (!d.grip || (!d.x && !d.y && d.closer === 1)) return;
  const { grip, x, y, closer } = d, size = Math.max(200, screen.clientHeight);
  [d.x, d.y, d.closer] = [0, 0, 1];
  wheel = null;
  if (d.pans) {
    if (closer !== 1) dolly(grip, closer);
    pan(depthOf(grip), x, y);
  } else if (steering === "look") {
    // The middle of the picture follows the pointer. Where the camera looks down or up, the same turn moves the picture
    // less.
    const angle = pictureOf(camera).kind === "parallel" ? Math.PI / size : unitsPerPixel(1);
    turn(camera.eye, -x * angle / Math.max(0.3, Math.cos(elevation())), y * angle);
  } else {
    turn(grip, x / size * Math.PI, -y / size * Math.PI);
  }
}
screen.addEventListener("pointerdown", event => {
  screen.setPointerCapture(event.pointerId);
  pointers.set(event.pointerId, event);
  const [x, y] = clicked = onScreen(event);
  if (pointers.size > 1) { box = null; draw(); }
  else if (current && (boxing || event.shiftKey) && event.button === 0) box = { x0: x, y0: y, x1: x, y1: y };
  if (camera) take(pointers.size > 1 || event.button > 0 || event.ctrlKey);
});
// The middle button would scroll the page, on some systems.
screen.addEventListener("mousedown", event => { if (event.button === 1) event.preventDefault(); });
screen.addEventListener("pointermove", event => {
  tellPixel(event);
  if (!pointers.has(event.pointerId) || !camera) return;
  pointers.set(event.pointerId, event);
  if (box) { [box.x1, box.y1] = onScreen(event); draw(); return; }
  if (!drag) return;
  const now = gesture(), { at } = drag, dx = now.x - at.x, dy = now.y - at.y, closer = now.spread && at.spread ? at.spread / now.spread : 1;
  drag.at = now;
  if (inspect) {
    magnify(1 / closer, now.x, now.y);
    panX += dx;
    panY += dy;
    draw();
    return;
  }
  drag.x += dx;
  drag.y += dy;
  drag.closer *= closer;
  steer(drag);
});
for (const end of ["pointerup", "pointercancel"])
  screen.addEventListener(end, event => {
    pointers.delete(event.pointerId);
    drag = null;
    // Two fingers are hardly ever lifted at once, so the remaining one does not move the camera.
    if (!pointers.size) takeUp(); else if (inspect) take(false);
  });
screen.addEventListener("contextmenu", event => event.preventDefault());
function magnify(factor, x, y) {
  const cx = x - screen.clientWidth / 2, cy = y - screen.clientHeight / 2;
  const to = between(0.1, zoom * factor, 64), k = to / zoom;
  panX = cx - (cx - panX) * k;
  panY = cy - (cy - panY) * k;
  zoom = to;
  draw();
}
// While keys fly, the wheel sets their speed. Otherwise it moves the camera towards or away from the point under the
// pointer.
let wheel = null;
screen.addEventListener("wheel", async event => {
  event.preventDefault();
  // Some browsers count in lines or pages; these are converted to pixels.
  const factor = 1.0015 ** (event.deltaY * [1, 30, 300][event.deltaMode]), [x, y] = onScreen(event);
  if (inspect) return magnify(1 / factor, x, y);
  if (!camera) return;
  if (held.size) return setSpeed(speed - Math.sign(event.deltaY) * 0.25);
  const now = performance.now();
  // The point stays under the pointer as long as nothing but the wheel moves the camera.
  if (!wheel || wheel.x !== x || wheel.y !== y || now - wheel.at > 1000) {
    const mine = wheel = { x, y, owed: 1, point: null };
    pointAt(x, y).then(point => { mine.point = point; if (mine.owed !== 1) dolly(point, mine.owed); });
  }
  wheel.at = now;
  if (wheel.point) dolly(wheel.point, factor); else wheel.owed *= factor;
}, { passive: false });

// ---- The part of the picture that all samples go to: the next drag draws it, and the one that begins with shift held
let box = null, boxing = false;
function setBoxing(on) {
  boxing = on;
  $("part").setAttribute("aria-pressed", String(on));
  screen.classList.toggle("drawing", on);
}
function endBox() {
  const { x0, y0, x1, y1 } = box, at = placed();
  box = null;
  setBoxing(false);
  draw();
  // A mere click draws nothing.
  if (Math.hypot(x1 - x0, y1 - y0) <= 3) return;
  const share = (a, from, size) => between(0, (a - from) / size, 1);
  const [left, right] = [share(Math.min(x0, x1), at.x, at.width), share(Math.max(x0, x1), at.x, at.width)];
  const [top, bottom] = [share(Math.min(y0, y1), at.y, at.height), share(Math.max(y0, y1), at.y, at.height)];
  if (left < right && top < bottom) setFocus({ x0: left, y0: top, x1: right, y1: bottom });
}
async function setFocus(part) {
  try { await ask("focus", JSON.stringify(part)); } catch (error) { say(error.message, true); }
}
function giveUpPart() {
  if (box || boxing) { box = null; setBoxing(false); draw(); } else if (state?.focus) setFocus(null);
}

// ---- What is under the pointer ---------------------------------------------------------------------------------
function pixelAt(event) {
  const [x, y] = onScreen(event), at = placed();
  const column = Math.floor((x - at.x) / at.scale), row = Math.floor((y - at.y) / at.scale);
  return current && column >= 0 && row >= 0 && column < current.width && row < current.height ? [column, row] : null;
}
function tellPixel(event) {
  const at = pixelAt(event), line = $("pixel");
  pointed = pointers.size ? null : at;
  if (!at) { line.replaceChildren("\u00a0"); return; }
  const values = current.at(...at), text = values.map(v => v.toPrecision(4)).join("  ");
  const square = document.createElement("i"), shown = current.canvas.getContext("2d").getImageData(at[0], at[1], 1, 1).data;
  square.style.background = `rgb(${shown[0]} ${shown[1]} ${shown[2]})`;
  line.replaceChildren(square, `${at[0]}, ${at[1]}   ${current.layer}   ${text}`, surface);
  tellSurface();
}
// The renderer's answer about the surface under the pointer. Only one question is open at a time, and few are asked a
// second.
const surface = document.createElement("span");
let pointed = null, asking = false;
function words(answer) {
  const s = answer.surface, samples = answer.samples === undefined ? "" : `   ${answer.samples} ${answer.samples === 1 ? "sample" : "samples"}`;
  if (!s) return samples + "   no surface";
  const parts = [s.material ? `${s.material} (${s.materialKind})` : s.materialKind ?? "no material",
                 [s.shapeKind, s.meshFile].filter(Boolean).join(" "), s.emits && "emits light", s.object && "part of " + s.object,
                 `${s.distance.toPrecision(4)} away`, s.file && `${s.file}:${s.line}`];
  return samples + "   " + parts.filter(Boolean).join(", ");
}
async function tellSurface() {
  if (asking || !pointed) return;
  asking = true;
  while (pointed) {
    const [x, y] = pointed;
    pointed = null;
    try { surface.textContent = words(await (await ask(`surface?x=${x}&y=${y}`)).json()); } catch { surface.textContent = ""; }
    await pause(50);
  }
  asking = false;
}
// All layers of a pixel that is clicked, as the renderer has them.
let clicked = null;
screen.addEventListener("pointerup", async event => {
  const at = pixelAt(event), drew = box, [x, y] = onScreen(event);
  if (box) endBox();
  if (drew || !inspect || !at || !clicked || Math.hypot(x - clicked[0], y - clicked[1]) > 3) return;
  try {
    const answer = await (await ask(`pixel?x=${at[0]}&y=${at[1]}`)).json();
    const number = v => v === null ? "no number" : v.toPrecision(5);
    const values = Object.entries(answer.layers).map(([name, v]) => `   ${name} ${v.map(number).join(" ")}`).join("");
    $("pixel").replaceChildren(`${at[0]}, ${at[1]}` + values + words({ surface: answer.surface }));
  } catch (error) { say(error.message, true); }
});
screen.addEventListener("pointercancel", () => { box = null; draw(); });
