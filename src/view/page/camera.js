
// ---- Camera ----------------------------------------------------------------------------------------------------
// Vectors are arrays of three numbers in the world space of the renderer.
let home = null, camera = null, film = [16, 9];
const add = (a, b, k = 1) => a.map((x, i) => x + k * b[i]);
const scaled = (a, k) => a.map(x => x * k);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = a => { const l = Math.hypot(...a) || 1; return a.map(x => x / l); };
const between = (low, x, high) => Math.max(low, Math.min(high, x));
// Turns v about a unit axis by an angle in radians, by the right-hand rule.
function turned(v, axis, angle) {
  const c = Math.cos(angle), s = Math.sin(angle);
  return add(add(scaled(v, c), cross(axis, v), s), axis, dot(axis, v) * (1 - c));
}
const distanceOf = c => Math.hypot(...add(c.look, c.eye, -1));
// The axes of LookAt: pbrt's are left-handed, right = up x ahead.
function basis(c) {
  const ahead = unit(add(c.look, c.eye, -1)), right = unit(cross(c.up, ahead));
  return [right, cross(ahead, right), ahead];
}
// The geometry of the picture in these axes, which the renderer has measured with rays unless the page has set a lens.
// A mirrored camera has its right at their left.
function pictureOf(c) {
  if (!c.lens) return home.picture;
  return { kind: c.lens.orthographic ? "parallel" : "perspective", width: c.lens.window[1] - c.lens.window[0],
           ahead: [0, 0, 1], right: [c.mirrored ? -1 : 1, 0, 0], top: [0, 1, 0] };
}
// The directions of the picture's middle, of its right edge and of its top edge in world space. hand: 1 if right = top
// x ahead, -1 if it is the contrary.
function directions() {
  const axes = basis(camera), picture = pictureOf(camera);
  const world = v => add(add(scaled(axes[0], v[0]), axes[1], v[1]), axes[2], v[2]);
  const [ahead, right, top] = [picture.ahead, picture.right, picture.top].map(world);
  return { ahead, right, top, hand: dot(cross(top, ahead), right) < 0 ? -1 : 1 };
}
// The scene's vertical: a coordinate axis at a right angle to the right of the scene's camera, if that camera stands
// level. If several axes qualify, it is the one nearest to the camera's own up.
function vertical() {
  const [right] = basis(home), axes = [0, 1, 2].map(i => home.up.map((x, k) => (k === i ? Math.sign(x) : 0)));
  const level = axes.filter(axis => Math.abs(dot(axis, right)) < 0.02 && dot(axis, home.up) > 0.1);
  return (level.length ? level : axes).reduce((a, b) => (dot(b, home.up) > dot(a, home.up) ? b : a));
}
// How far ahead of the camera a point is.
function depthOf(point) {
  const arm = add(point, camera.eye, -1);
  return pictureOf(camera).kind === "panorama" ? Math.hypot(...arm) : Math.max(1e-6, dot(arm, directions().ahead));
}
// World units that a pixel of the screen shows at a depth.
function unitsPerPixel(depth) {
  const { kind, width } = pictureOf(camera);
  return width * (kind === "parallel" ? 1 : depth) / placed().width;
}
// The elevation of the picture's middle above the horizon, radians.
const elevation = () => Math.asin(between(-1, dot(directions().ahead, vertical()), 1));
// Turns the camera about a point, which stays where it is in the picture: by these angles, in radians, the direction of
// view moves to the right and up.
function turn(about, rightward, upward) {
  const up = vertical(), { ahead, right, hand } = directions(), now = elevation();
  // Not beyond the poles.
  const most = Math.max(1.5, Math.abs(now)), rise = between(-most, now + upward, most) - now;
  const level = Math.abs(dot(ahead, up)) < 0.9999 ? scaled(unit(cross(up, ahead)), hand) : right;
  const by = v => turned(turned(v, level, -hand * rise), up, hand * rightward);
  camera.eye = add(about, by(add(camera.eye, about, -1)));
  camera.look = add(about, by(add(camera.look, about, -1)));
  camera.up = unit(by(camera.up));
  // A camera that stands level gets the vertical as its up, which people can read; any other camera keeps its roll.
  if (Math.abs(dot(basis(camera)[0], up)) < 1e-4 && dot(camera.up, up) > 0) camera.up = up;
  moved();
}
function shift(by) {
  camera.eye = add(camera.eye, by);
  camera.look = add(camera.look, by);
  moved();
}
// Shifts the camera by pixels of the screen: points at this depth follow the pointer.
function pan(depth, dx, dy) {
  const { right, top } = directions(), k = unitsPerPixel(depth);
  shift(add(scaled(right, -dx * k), top, dy * k));
}
// Multiplies the distance from a point by a factor; the point stays where it is in the picture. A camera of parallel
// rays shows a smaller or larger part of its picture instead.
function dolly(towards, factor) {
  const [, , axis] = basis(camera), arm = add(towards, camera.eye, -1);
  if (pictureOf(camera).kind === "parallel") {
    const { right, top } = directions(), { window, ...rest } = camera.lens ?? { orthographic: true, window: home.picture.window };
    const at = [dot(arm, right), dot(arm, right), dot(arm, top), dot(arm, top)];
    camera.lens = { ...rest, window: window.map((edge, i) => at[i] + factor * (edge - at[i])) };
  } else {
    const distance = Math.max(1e-6, distanceOf(camera) * factor);
    camera.eye = add(towards, arm, -factor);
    camera.look = add(camera.eye, axis, distance);
  }
  moved();
}
// Moves the camera ahead, to the right and upwards; 1 is the median distance of the surfaces that the scene's camera
// shows.
function fly(along, aside, upward) {
  const { ahead, right } = directions();
  shift(scaled(add(add(scaled(ahead, along), right, aside), vertical(), upward), distanceOf(home)));
}
