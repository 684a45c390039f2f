// ---- The server ------------------------------------------------------------------------------------------------
async function ask(path, body) {
  const response = await fetch(path, body === undefined ? {} : { method: "POST", body });
  if (!response.ok) throw new Error((await response.text()).trim() || response.statusText);
  return response;
}
// Just after a camera move there is no estimate of the error yet.
const available = name => name === "error" && !state?.["error estimate"] ? "beauty" : name;
let fetching = false, wanted = false;
async function load() {
  wanted = true;
  if (fetching) return;
  fetching = true;
  while (wanted) {
    wanted = false;
    const chosen = layer, name = available(layer);
    try {
      const picture = new Picture(await (await ask("frame?layer=" + encodeURIComponent(name))).arrayBuffer());
      picture.layer = name;
      if (chosen === layer) { current = picture; draw(); }
    } catch (error) { if (current) say(error.message, true); }
  }
  fetching = false;
}
function say(text, bad) { $("status").textContent = text; $("status").classList.toggle("bad", !!bad); }
function onFrame(event) {
  // An event may overtake an answer, which is then out of date.
  if (event.serial < state?.serial) return;
  state = Object.assign(state ?? {}, event);
  if (event.error) return say(event.error, true);
  const how = event.done ? "done" : event.paused ? "paused" : "rendering";
  const extra = event.focus && event.focusSamples ? ` + ${event.focusSamples} in the part` : "";
  say(event.number ? `${how}, ${event.samples > 0 ? event.samples + " spp" + extra : event.status}, ${event.seconds.toFixed(1)} s` : how);
  $("whole").disabled = !event.focus;
  $("pause").textContent = event.paused ? "Continue" : "Pause";
  $("pause").setAttribute("aria-pressed", String(!!event.paused));
  $("progress").style.width = event.samples > 0 ? "0" : 100 * (event.share ?? 0) + "%";
  tellError();
  if (event.camera) hear(event.camera);
  if (event.number) load();
  draw();
}
// The renderer's estimate of the error of the denoised picture falls as samples ^ -slope.
function tellError() {
  const estimate = state?.["error estimate"], target = Number($("target").value) / 100;
  $("error").textContent = estimate ? `${(100 * estimate.whole).toPrecision(2)} %, ${estimate.samples} spp` : "not known yet";
  let text = "";
  if (estimate && target > 0 && state.samples > 0) {
    const needed = estimate.samples * Math.max(1, estimate.whole / target) ** (1 / estimate.slope);
    const seconds = state.seconds / state.samples * (needed - state.samples);
    text = estimate.whole <= target || seconds <= 0 ? "reached" : seconds < 100 ? `${Math.ceil(seconds)} s`
      : seconds < 6000 ? `${Math.ceil(seconds / 60)} min` : `${Math.ceil(seconds / 3600)} h`;
  }
  $("eta").textContent = text;
  if (estimate && !layers.includes("error")) listLayers();
}
let layers = [];
async function start() {
  const first = await (await ask("state")).json();
  state = first;
  document.title = first.title + " - drc view";
  $("title").textContent = first.title;
  home = first.home;
  camera = structuredClone(first.camera);
  film = first.film;
  await listLayers();
  view = $("view").value = first.display.view;
  setExposure(first.display.exposure + (first.display.auto ? (await (await ask("exposure")).json()).stops : 0));
  if (first.reference) reference = new Picture(await (await ask("frame?layer=reference")).arrayBuffer());
  $("split").disabled = $("without").disabled = !reference;
  onFrame(first);
  listen();
}
// Listens to the renderer's events as long as there is a renderer: a page outlives the program that it came from.
function listen() {
  const events = new EventSource("events");
  events.addEventListener("frame", event => onFrame(JSON.parse(event.data)));
  events.onopen = async () => {
    const now = await (await ask("state")).json();
    // Another render has the same address: all data of this page are those of the former render.
    if (now.run === state.run) onFrame(now); else location.reload();
  };
  events.onerror = async () => {
    say("the renderer does not answer; trying again", true);
    // In the other states, the browser itself tries again.
    if (events.readyState !== EventSource.CLOSED) return;
    const answer = await fetch("state").catch(() => null);
    if (answer?.status === 403) say("drc view has been started anew: open the new address, which it has printed", true);
    else setTimeout(listen, 2000);
  };
}
async function listLayers() {
  for (;;) {
    const now = await (await ask("state")).json();
    if (now.number) {
      layers = now.layers;
      $("layer").replaceChildren(...layers.map(name => new Option(name, name)));
      $("layer").value = layer;
      return;
    }
    await new Promise(done => setTimeout(done, 100));
  }
}
