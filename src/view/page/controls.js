// ---- Mouse, touch, keys ----------------------------------------------------------------------------------------
const pointers = new Map();
let spread = 0;
// The part of the picture that all samples go to: the next drag draws it, and the one that begins with shift held.
let box = null, boxing = false;
function setBoxing(on) {
  boxing = on;
  $("part").setAttribute("aria-pressed", String(on));
  screen.classList.toggle("drawing", on);
}
function onScreen(event) {
  const frame = screen.getBoundingClientRect();
  return [event.clientX - frame.left, event.clientY - frame.top];
}
function endBox() {
  const { x0, y0, x1, y1 } = box, at = placed();
  box = null;
  setBoxing(false);
  draw();
  // A mere click draws nothing.
  if (Math.hypot(x1 - x0, y1 - y0) <= 3) return;
  const share = (a, from, size) => Math.max(0, Math.min(1, (a - from) / size));
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
function pixelAt(event) {
  const box = screen.getBoundingClientRect(), at = placed();
  const x = Math.floor((event.clientX - box.left - at.x) / at.scale), y = Math.floor((event.clientY - box.top - at.y) / at.scale);
  return current && x >= 0 && y >= 0 && x < current.width && y < current.height ? [x, y] : null;
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
// What the renderer knows of the surface under the pointer. One question at a time, and not too many a second.
const surface = document.createElement("span"), pause = ms => new Promise(done => setTimeout(done, ms));
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
screen.addEventListener("pointerdown", event => {
  screen.setPointerCapture(event.pointerId);
  pointers.set(event.pointerId, event);
  spread = 0;
  if (!current || !(boxing || event.shiftKey) || event.button !== 0) return;
  // A second finger makes it a pinch.
  if (pointers.size > 1) { box = null; draw(); return; }
  const [x, y] = onScreen(event);
  box = { x0: x, y0: y, x1: x, y1: y };
});
screen.addEventListener("pointermove", event => {
  tellPixel(event);
  const before = pointers.get(event.pointerId);
  if (!before || !camera) return;
  const dx = event.clientX - before.clientX, dy = event.clientY - before.clientY;
  pointers.set(event.pointerId, event);
  if (!dx && !dy) return;
  if (box) { [box.x1, box.y1] = onScreen(event); draw(); return; }
  if (pointers.size === 2) {
    const [a, b] = [...pointers.values()], now = Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
    if (spread > 0) inspect ? magnify(now / spread, (a.clientX + b.clientX) / 2, (a.clientY + b.clientY) / 2) : dolly(spread / now);
    spread = now;
  }
  if (inspect) { panX += dx / pointers.size; panY += dy / pointers.size; draw(); return; }
  const size = Math.max(200, screen.clientHeight);
  if (pointers.size === 2 || event.buttons & 2) pan(dx / size / pointers.size, dy / size / pointers.size);
  else orbit(dx / size * Math.PI, dy / size * Math.PI);
});
// All layers of a pixel that is clicked, as the renderer has them.
let clicked = null;
screen.addEventListener("pointerdown", event => { clicked = [event.clientX, event.clientY]; });
screen.addEventListener("pointercancel", () => { box = null; draw(); });
screen.addEventListener("pointerup", async event => {
  const at = pixelAt(event), drew = box;
  if (box) endBox();
  if (drew || !inspect || !at || !clicked || Math.hypot(event.clientX - clicked[0], event.clientY - clicked[1]) > 3) return;
  try {
    const answer = await (await ask(`pixel?x=${at[0]}&y=${at[1]}`)).json();
    const number = v => v === null ? "no number" : v.toPrecision(5);
    const values = Object.entries(answer.layers).map(([name, v]) => `   ${name} ${v.map(number).join(" ")}`).join("");
    $("pixel").replaceChildren(`${at[0]}, ${at[1]}` + values + words({ surface: answer.surface }));
  } catch (error) { say(error.message, true); }
});
for (const end of ["pointerup", "pointercancel"]) screen.addEventListener(end, event => { pointers.delete(event.pointerId); spread = 0; });
screen.addEventListener("contextmenu", event => event.preventDefault());
function magnify(factor, x, y) {
  const box = screen.getBoundingClientRect(), cx = x - box.left - screen.clientWidth / 2, cy = y - box.top - screen.clientHeight / 2;
  const to = Math.max(0.1, Math.min(64, zoom * factor)), k = to / zoom;
  panX = cx - (cx - panX) * k;
  panY = cy - (cy - panY) * k;
  zoom = to;
  draw();
}
screen.addEventListener("wheel", event => {
  event.preventDefault();
  const factor = 1.0015 ** event.deltaY;
  if (inspect) magnify(1 / factor, event.clientX, event.clientY);
  else if (camera) dolly(factor);
}, { passive: false });
function setInspect(on) {
  inspect = on;
  $("mode").setAttribute("aria-pressed", String(on));
  screen.classList.toggle("inspect", on);
}
function fit() { zoom = 1; panX = panY = 0; draw(); }
function setExposure(stops) {
  exposure = Math.max(-10, Math.min(10, stops));
  $("exposure").value = exposure;
  $("stops").textContent = exposure.toFixed(1) + " stops";
  draw();
}
async function setLayer(name) { layer = name; $("layer").value = name; await load(); }
async function auto() {
  try { setExposure((await (await ask("exposure")).json()).stops); } catch (error) { say(error.message, true); }
}
async function togglePause() { onFrame(await (await ask("pause", String(!state.paused))).json().then(x => ({ ...state, ...x }))); }
function togglePanel() { const on = $("controls").hidden; $("controls").hidden = !on; $("panel").setAttribute("aria-pressed", String(on)); }
async function copy() {
  const text = camera.pbrt;
  try { await navigator.clipboard.writeText(text); say("copied: " + text.replace("\n", " ")); } catch { prompt("The camera as pbrt writes it:", text); }
}
function download(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}
const flying = { w: [1, 0, 0], s: [-1, 0, 0], a: [0, -1, 0], d: [0, 1, 0], q: [0, 0, -1], e: [0, 0, 1] };
const held = new Set();
let last = 0;
function flight(now) {
  if (!held.size) return;
  const step = Math.min(0.1, (now - last) / 1000) * (held.has("shift") ? 0.1 : 0.5);
  last = now;
  const sum = [0, 0, 0];
  for (const key of held) if (flying[key]) flying[key].forEach((x, i) => sum[i] += x * step);
  if (sum.some(x => x)) fly(...sum);
  requestAnimationFrame(flight);
}
addEventListener("keydown", event => {
  if (event.target.matches("input, select") || event.ctrlKey || event.metaKey || event.altKey || !camera) return;
  const key = event.key.toLowerCase();
  if (flying[key]) {
    if (event.shiftKey) held.add("shift"); else held.delete("shift");
    if (!held.has(key)) { held.add(key); last = performance.now(); requestAnimationFrame(flight); }
    return;
  }
  const act = { r: reset, i: () => setInspect(!inspect), f: fit, p: togglePanel, c: copy, b: () => setBoxing(!boxing), escape: giveUpPart, "+": () => setExposure(exposure + 0.5),
                "=": () => setExposure(exposure + 0.5), "-": () => setExposure(exposure - 0.5), "0": () => setExposure(0), x: auto };
  if (key === " " && !event.target.matches("button")) { event.preventDefault(); togglePause(); }
  else if (act[key]) act[key]();
  else if (key >= "1" && key <= "9" && $("layer").options[key - 1]) setLayer($("layer").options[key - 1].value);
});
addEventListener("keyup", event => { held.delete(event.key.toLowerCase()); if (event.key === "Shift") held.delete("shift"); });
addEventListener("blur", () => held.clear());
$("target").oninput = tellError;
$("layer").onchange = () => setLayer($("layer").value);
$("view").onchange = () => { view = $("view").value; draw(); };
$("exposure").oninput = () => setExposure(Number($("exposure").value));
$("auto").onclick = auto;
$("neutral").onclick = () => setExposure(0);
$("mode").onclick = () => setInspect(!inspect);
$("fit").onclick = fit;
$("part").onclick = () => setBoxing(!boxing);
$("whole").onclick = () => setFocus(null);
$("home").onclick = reset;
$("copy").onclick = copy;
$("pause").onclick = togglePause;
$("panel").onclick = togglePanel;
$("split").oninput = () => { split = Number($("split").value); draw(); };
$("file").onchange = async () => {
  try {
    await ask("compare", $("file").files[0]);
    reference = new Picture(await (await ask("frame?layer=reference")).arrayBuffer());
    $("split").disabled = $("without").disabled = false;
    draw();
  } catch (error) { say(error.message, true); }
};
$("without").onclick = () => { reference = null; $("split").disabled = $("without").disabled = true; $("file").value = ""; draw(); };
$("exr").onclick = async () => { try { download(await (await ask("save.exr")).blob(), "drc.exr"); } catch (error) { say(error.message, true); } };
$("png").onclick = () => { if (current) { render(current, current.layer); current.canvas.toBlob(blob => download(blob, "drc.png"), "image/png"); } };
if (innerWidth <= 700) togglePanel();
start().catch(error => say(error.message, true));
