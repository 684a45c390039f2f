
// ---- Keys ------------------------------------------------------------------------------------------------------
// The directions of keys that fly: ahead, to the right, upwards; and of keys that turn: to the right, upwards.
const flying = { w: [1, 0, 0], s: [-1, 0, 0], a: [0, -1, 0], d: [0, 1, 0], q: [0, 0, -1], e: [0, 0, 1] };
const turning = { arrowleft: [-1, 0], arrowright: [1, 0], arrowup: [0, 1], arrowdown: [0, -1] };
const kTurn = 1;  // radians a second
let speed = 0;    // binary logarithm of the speed of flight, in halves of the scene's distance a second
function setSpeed(power) {
  speed = between(-6, power, 6);
  $("speed").value = speed;
  $("pace").textContent = (2 ** speed).toPrecision(2) + " x";
}
const held = new Set();
let lastFlight = null, middle = null;
function flight(now) {
  if (!held.size) { lastFlight = null; return; }
  const seconds = between(0, (now - lastFlight) / 1000, 0.1), quicker = held.has("shift") ? 4 : 1;
  lastFlight = now;
  const sum = [0, 0, 0, 0, 0];
  for (const key of held) {
    flying[key]?.forEach((x, i) => sum[i] += x * seconds * quicker * 0.5 * 2 ** speed);
    turning[key]?.forEach((x, i) => sum[3 + i] += x * seconds * kTurn);
  }
  const [along, aside, upward, rightward, rise] = sum;
  if (along || aside || upward) fly(along, aside, upward);
  // When the camera turns around the picture's middle, the eye moves to the side of the key.
  if (rightward || rise) { if (steering === "look") turn(camera.eye, rightward, rise); else if (middle) turn(middle, -rightward, -rise); }
  wheel = null;
  requestAnimationFrame(flight);
}
// The letter on the key, on a keyboard with Latin letters. On others, the letter of that key on an American keyboard.
function keyOf(event) {
  const { key, code } = event;
  return (key.length === 1 && key > "~" ? code.replace(/^(Key|Digit)/, "") : key).toLowerCase();
}
// After a click or a touch on a control, keys act on the picture again. A control that was reached by Tab keeps the
// keys.
let byPointer = true;
addEventListener("pointerdown", () => byPointer = true, true);
addEventListener("keydown", event => { if (event.key === "Tab") byPointer = false; }, true);
function backToPicture(event) {
  if (byPointer && event.target.matches(event.type === "click" ? "button, input[type=range]" : "select, input:not([type=number])")) screen.focus({ preventScroll: true });
}
for (const done of ["click", "change"]) addEventListener(done, backToPicture);
// Whether the element that has the focus handles a key itself.
function takesKey(element, key) {
  if (!(element instanceof Element)) return false;
  if (element.matches("input[type=number], input[type=file]")) return true;
  if (element.matches("select")) return !byPointer || key === " " || key.length > 1;
  if (element.matches("input[type=range]")) return /^(arrow|page|home|end)/.test(key);
  return element.matches("button") && (key === " " || key === "enter");
}
const acts = {
  " ": togglePause, r: reset, f: fit, p: togglePanel, c: copy, x: auto, h: toggleHelp, "?": toggleHelp, escape: giveUpPart,
  o: () => setSteering("orbit"), l: () => setSteering("look"), i: () => setInspect(!inspect), b: () => setBoxing(!boxing),
  "+": () => setExposure(exposure + 0.5), "=": () => setExposure(exposure + 0.5), "-": () => setExposure(exposure - 0.5), "0": () => setExposure(0),
};
addEventListener("keydown", event => {
  const key = keyOf(event);
  if (event.ctrlKey || event.metaKey || event.altKey) return release();
  if (key === "shift" && held.size) held.add(key);
  if (!camera || takesKey(event.target, key) || ($("help").open && acts[key] !== toggleHelp)) return;
  if (flying[key] || turning[key]) {
    event.preventDefault();
    if (held.has(key)) return;
    held.add(key);
    if (event.shiftKey) held.add("shift");
    if (turning[key]) findMiddle();
    if (lastFlight === null) { lastFlight = performance.now(); requestAnimationFrame(flight); }
    return;
  }
  const act = key >= "1" && key <= "9" ? () => setLayerNumber(Number(key)) : acts[key];
  if (!act) return;
  event.preventDefault();
  if (!event.repeat || "+=-".includes(key)) act();
});
async function findMiddle() {
  middle = null;
  const { x, y, width, height } = placed();
  middle = await pointAt(x + width / 2, y + height / 2);
}
function release() { held.clear(); takeUp(); }
addEventListener("keyup", event => {
  held.delete(keyOf(event));
  // Shift alone steers nothing.
  if ([...held].every(key => key === "shift")) release();
});
addEventListener("blur", release);
$("target").addEventListener("keydown", event => { if (event.key === "Enter" || event.key === "Escape") screen.focus(); });
