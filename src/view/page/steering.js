
// ---- Steering --------------------------------------------------------------------------------------------------
// What a drag does: "orbit" goes around the point under the pointer, "look" turns the camera where it stands.
let steering = "orbit";
const kSteerings = ["orbit", "look"], kSteeringKey = "drc-view-steering";
function setSteering(name) {
  steering = name;
  setInspect(false);
  // A browser may be set to keep nothing.
  try { localStorage.setItem(kSteeringKey, name); } catch { }
}
function restoreSteering() {
  let kept = null;
  try { kept = localStorage.getItem(kSteeringKey); } catch { }
  setSteering(kSteerings.includes(kept) ? kept : "orbit");
}
function tellMode() {
  for (const name of kSteerings) $(name).setAttribute("aria-pressed", String(!inspect && steering === name));
  $("mode").setAttribute("aria-pressed", String(inspect));
  screen.classList.toggle("inspect", inspect);
}

// The renderer has one camera, which every page may set. The renderer numbers these settings.
let sending = false, next = null, settle = 0, heard = null;
function moved() {
  send(true);
  clearTimeout(settle);
  settle = setTimeout(() => { settle = 0; send(false); }, 200);
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
    try {
      const { pbrt, number } = await (await ask("camera", body)).json();
      Object.assign(camera, { pbrt, number });
    } catch (error) { say(error.message, true); }
  }
  sending = false;
  takeUp();
}
// A camera that another page has set is taken over, unless this page is steering: its own camera then comes last.
function hear(their) {
  if (!heard || their.number > heard.number) heard = their;
  takeUp();
}
function takeUp() {
  if (!heard || sending || settle || pointers.size || held.size) return;
  if (heard.number > camera.number) camera = heard;
  heard = null;
}
// Otherwise the renderer would go on with the small pictures of a moving camera.
addEventListener("pagehide", () => {
  if (!settle) return;
  const [width, height] = film;
  fetch("camera", { method: "POST", keepalive: true,
                    body: JSON.stringify({ eye: camera.eye, look: camera.look, up: camera.up, lens: camera.lens, width, height }) });
});
function reset() {
  camera = { ...structuredClone(home), number: camera.number };
  send(false);
}

// The point of the scene at a place of the screen, which drags and the wheel refer to. Where there is no surface, or if
// the answer takes too long, it is the point that the camera looks at.
async function pointAt(x, y) {
  const at = placed(), ahead = camera.look;
  const share = (a, from, size) => between(0, (a - from) / size, 1).toFixed(5);
  const question = ask(`point?x=${share(x, at.x, at.width)}&y=${share(y, at.y, at.height)}`).then(answer => answer.json());
  const answer = await Promise.race([question.catch(() => null), pause(300)]);
  return answer?.point ?? ahead;
}
