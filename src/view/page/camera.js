// ---- Camera ----------------------------------------------------------------------------------------------------
let home = null, camera = null, film = [16, 9];
const add = (a, b, k = 1) => a.map((x, i) => x + k * b[i]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = a => { const l = Math.hypot(...a) || 1; return a.map(x => x / l); };
function turned(v, axis, angle) {
  const c = Math.cos(angle), s = Math.sin(angle);
  return add(add(v.map(x => x * c), cross(axis, v), s), axis, dot(axis, v) * (1 - c));
}
// The scene's vertical: the axis that is nearest to the camera's own up.
function vertical() {
  const most = Math.max(...home.up.map(Math.abs));
  return home.up.map(x => Math.abs(x) === most ? Math.sign(x) : 0);
}
function axes() {
  const forward = unit(add(camera.look, camera.eye, -1)), up = vertical();
  let right = unit(cross(forward, up));
  if (camera.mirrored) right = right.map(x => -x);
  return { forward, right, up };
}
let sending = false, next = null, settle = 0;
function moved() {
  send(true);
  clearTimeout(settle);
  settle = setTimeout(() => send(false), 200);
}
async function send(moving) {
  const scale = moving ? Math.min(1, 640 / Math.max(...film)) : 1;
  next = JSON.stringify({ eye: camera.eye, look: camera.look, up: camera.up, lens: camera.lens, moving,
                          width: Math.max(16, Math.round(film[0] * scale)), height: Math.max(16, Math.round(film[1] * scale)) });
  if (sending) return;
  sending = true;
  while (next) {
    const body = next;
    next = null;
    try { camera.pbrt = (await (await ask("camera", body)).json()).pbrt; } catch (error) { say(error.message, true); }
  }
  sending = false;
}
function orbit(dx, dy) {
  const { up } = axes(), sign = camera.mirrored ? -1 : 1;
  let arm = turned(add(camera.eye, camera.look, -1), up, -sign * dx);
  const right = unit(cross(arm, up)), tilted = turned(arm, right, dy);
  // Not over the poles.
  if (Math.abs(dot(unit(tilted), up)) < 0.995) arm = tilted;
  camera.eye = add(camera.look, arm);
  camera.up = up;
  moved();
}
function pan(dx, dy) {
  const { forward, right } = axes(), distance = Math.hypot(...add(camera.look, camera.eye, -1));
  const top = camera.mirrored ? cross(forward, right) : cross(right, forward);
  const shift = add(right.map(x => -x * dx * distance), top, dy * distance);
  camera.eye = add(camera.eye, shift);
  camera.look = add(camera.look, shift);
  moved();
}
function dolly(factor) {
  camera.eye = add(camera.look, add(camera.eye, camera.look, -1), factor);
  moved();
}
function fly(along, aside, upward) {
  const { forward, right, up } = axes(), distance = Math.hypot(...add(home.look, home.eye, -1));
  const shift = add(add(forward.map(x => x * along * distance), right, aside * distance), up, upward * distance);
  camera.eye = add(camera.eye, shift);
  camera.look = add(camera.look, shift);
  camera.up = up;
  moved();
}
function reset() { camera = structuredClone(home); send(false); }
