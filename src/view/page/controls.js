
// ---- Controls --------------------------------------------------------------------------------------------------
function setInspect(on) {
  inspect = on;
  // The text that a click has shown may cover a part of the picture, so it is removed.
  if (!on) $("pixel").replaceChildren("\u00a0");
  tellMode();
}
function fit() { zoom = 1; panX = panY = 0; draw(); }
function setExposure(stops) {
  exposure = Math.max(-10, Math.min(10, stops));
  $("exposure").value = exposure;
  $("stops").textContent = exposure.toFixed(1) + " stops";
  draw();
}
async function setLayer(name) { layer = name; $("layer").value = name; await load(); }
function setLayerNumber(n) { const option = $("layer").options[n - 1]; if (option) setLayer(option.value); }
async function auto() {
  try { setExposure((await (await ask("exposure")).json()).stops); } catch (error) { say(error.message, true); }
}
async function togglePause() { onFrame(await (await ask("pause", String(!state.paused))).json().then(x => ({ ...state, ...x }))); }
function togglePanel() { const on = $("controls").hidden; $("controls").hidden = !on; $("panel").setAttribute("aria-pressed", String(on)); }
function toggleHelp() { if ($("help").open) $("help").close(); else $("help").showModal(); }
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
$("target").oninput = tellError;
$("layer").onchange = () => setLayer($("layer").value);
$("view").onchange = () => { view = $("view").value; draw(); };
$("exposure").oninput = () => setExposure(Number($("exposure").value));
$("auto").onclick = auto;
$("neutral").onclick = () => setExposure(0);
$("mode").onclick = () => setInspect(!inspect);
for (const name of kSteerings) $(name).onclick = () => setSteering(name);
$("speed").oninput = () => setSpeed(Number($("speed").value));
$("keys").onclick = $("understood").onclick = toggleHelp;
// A click beside the help closes it.
$("help").onclick = event => { if (event.target === $("help")) toggleHelp(); };
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
restoreSteering();
setSpeed(0);
start().catch(error => say(error.message, true));
