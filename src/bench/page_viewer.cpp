#include "bench/page_viewer.h"

#include <fmt/core.h>

#include "report/html_page.h"

namespace drc {
namespace {

std::string options(const auto& items, const auto& name, const std::string& more = "") {
    std::string html;
    for (size_t i = 0; i < items.size(); ++i)
        html += fmt::format("<option value=\"{}\">{}</option>", i, escapeHtml(name(items[i])));
    return html + more;
}

std::string sideChoices(const BenchReport& report, const std::string& side) {
    return fmt::format(
        "<div class=\"{0}\"><select class=\"method\" aria-label=\"{0} picture\" autocomplete=\"off\">{1}</select> "
        "<select class=\"budget\" aria-label=\"budget of the {0} picture\" autocomplete=\"off\">{2}</select></div>\n",
        side,
        options(
            report.methods, [](const std::string& name) { return name; },
            "<option value=\"reference\">reference</option>"),
        options(report.budgets, budgetName));
}

std::string sideDetails(const std::string& side) {
    return fmt::format(
        "<div class=\"{0}\"><dl></dl><canvas class=\"zoom\" role=\"img\" aria-label=\"a part of the {0} picture, four "
        "times as large\"></canvas><canvas class=\"difference\" role=\"img\" aria-label=\"difference of "
        "the {0} picture to the reference\"></canvas></div>\n",
        side);
}

// No "less than" sign, so that the page's tags nest as those of XML do.
constexpr const char* kScript = R"(
(() => {
  "use strict";
  const viewer = document.querySelector(".viewer"), part = selector => viewer.querySelector(selector);
  const figures = [...document.querySelectorAll("figure[data-method]")];
  const scene = part(".scene"), kind = part(".kind");
  const stage = part(".stage"), wipe = part(".wipe"), loupe = part(".loupe");
  const sides = ["right", "left"].map(name => {
    const image = stage.insertBefore(new Image(), loupe);
    image.className = name;
    image.draggable = false;
    return { image, method: part(`.choices .${name} .method`), budget: part(`.choices .${name} .budget`),
             facts: part(`.details .${name} dl`), zoom: part(`.details .${name} .zoom`),
             difference: part(`.details .${name} .difference`) };
  });
  const centre = { x: 0.5, y: 0.5 };
  const kZoom = 4, kGain = 4, kNarrow = 600;

  const figuresOf = (method, budget) => figures.filter(({ dataset }) => dataset.scene === scene.value &&
    (method === undefined || dataset.method === method) && (budget === undefined || dataset.budget === budget));
  const figureOf = side => side.method.value === "reference" ? figuresOf("reference")[0]
    : figuresOf(side.method.value, side.budget.value)[0];

  // Only what there is a picture of can be chosen; where the choice is gone, the budget of the figures comes first.
  const offer = (select, has) => {
    for (const option of select.options) option.hidden = option.disabled = !has(option.value);
  };
  const choose = side => {
    offer(side.method, value => figuresOf(value).length > 0);
    if (!side.method.selectedOptions[0] || side.method.selectedOptions[0].disabled)
      side.method.value = [...side.method.options].find(option => !option.disabled).value;
    side.budget.hidden = side.method.value === "reference";
    if (side.budget.hidden) return;
    const there = figuresOf(side.method.value);
    offer(side.budget, value => there.some(figure => figure.dataset.budget === value));
    if (!side.budget.selectedOptions[0] || side.budget.selectedOptions[0].disabled)
      side.budget.value = (there.find(figure => figure.closest(".strip")) || there[there.length - 1]).dataset.budget;
  };

  const magnify = () => {
    for (const { source, zoom } of sides) {
      if (!source) continue;
      const scale = window.devicePixelRatio || 1, width = zoom.clientWidth, height = zoom.clientHeight;
      const w = Math.min(width / kZoom, source.naturalWidth), h = Math.min(height / kZoom, source.naturalHeight);
      const inside = (at, part, whole) => Math.max(0, Math.min(whole - part, at * whole - part / 2));
      const x = inside(centre.x, w, source.naturalWidth), y = inside(centre.y, h, source.naturalHeight);
      zoom.width = width * scale;
      zoom.height = height * scale;
      const context = zoom.getContext("2d");
      context.imageSmoothingEnabled = false;
      context.drawImage(source, x, y, w, h, 0, 0, w * kZoom * scale, h * kZoom * scale);
      loupe.style.left = `${100 * x / source.naturalWidth}%`;
      loupe.style.top = `${100 * y / source.naturalHeight}%`;
      loupe.style.width = `${100 * w / source.naturalWidth}%`;
      loupe.style.height = `${100 * h / source.naturalHeight}%`;
    }
  };

  const pixels = image => {
    const canvas = document.createElement("canvas");
    canvas.width = image.naturalWidth;
    canvas.height = image.naturalHeight;
    const context = canvas.getContext("2d", { willReadFrequently: true });
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, canvas.width, canvas.height);
  };
  // As drc compare shows it: between displayed colours, four times as large.
  const subtract = (side, reference) => {
    const result = pixels(side.source), { data } = result, other = reference.data, bySign = kind.value === "sign";
    for (let i = 0; data.length > i; i += 4) {
      const d = [0, 1, 2].map(c => kGain * (data[i + c] - other[i + c]));
      const brighter = 0.2126 * d[0] + 0.7152 * d[1] + 0.0722 * d[2];
      data[i] = bySign ? brighter : Math.abs(d[0]);
      data[i + 1] = bySign ? 0 : Math.abs(d[1]);
      data[i + 2] = bySign ? -brighter : Math.abs(d[2]);
    }
    side.difference.width = result.width;
    side.difference.height = result.height;
    side.difference.getContext("2d").putImageData(result, 0, 0);
  };

  let shown = 0;
  const show = async () => {
    const turn = ++shown, reference = figuresOf("reference")[0].querySelector("img");
    sides.forEach(choose);
    const chosen = sides.map(figureOf), images = chosen.map(figure => figure.querySelector("img"));
    await Promise.all([reference, ...images].map(image => image.decode()));
    if (turn !== shown) return;
    const width = reference.naturalWidth, height = reference.naturalHeight;
    viewer.style.setProperty("--ratio", width / height);
    viewer.style.setProperty("--natural", `${width * Math.ceil(kNarrow / width)}px`);
    const values = pixels(reference);
    sides.forEach((side, i) => {
      side.source = images[i];
      side.image.src = images[i].src;
      side.image.alt = images[i].alt;
      side.facts.replaceChildren(...chosen[i].querySelector("dl").cloneNode(true).childNodes);
      subtract(side, values);
    });
    magnify();
  };

  for (const select of viewer.querySelectorAll("select")) select.addEventListener("change", show);
  wipe.addEventListener("input", () => {
    stage.style.setProperty("--wipe", `${wipe.value}%`);
    centre.x = wipe.value / 100;
    magnify();
  });
  stage.addEventListener("pointermove", event => {
    const box = stage.getBoundingClientRect();
    centre.x = (event.clientX - box.left) / box.width;
    centre.y = (event.clientY - box.top) / box.height;
    magnify();
  });
  window.addEventListener("resize", magnify);

  viewer.hidden = false;
  for (const all of document.querySelectorAll("details.all")) all.open = false;
  for (const side of sides) side.budget.selectedIndex = -1;
  sides[1].method.selectedIndex = 0;
  sides[0].method.selectedIndex = 1;
  show();
})();
)";

// .viewer   a .frame as wide as its picture: .choices above a .stage, .details of both sides below it. A small picture
//           is shown several times as large
// .stage    two pictures on top of each other, the left one cut at --wipe; a range over all of it takes the pointer
// .strip    pictures of one scene side by side; .gallery: more of them, smaller
constexpr const char* kStyle = R"(
.viewer { margin-bottom: 1rem; --gap: 1rem; } .viewer .heads { margin-top: .8rem; }
.viewer[hidden], .viewer [hidden] { display: none; }
.viewer select { font: inherit; font-size: .87rem; color: inherit; background: var(--paper);
  border: 1px solid var(--rule); border-radius: 3px; padding: .2rem .3rem; max-width: 100%; }
.viewer .heads { display: flex; flex-wrap: wrap; gap: .4rem 1.4rem; font-size: .87rem; margin-bottom: .6rem; }
.viewer .heads label { color: var(--soft); } .viewer .heads select { color: var(--ink); margin-left: .3rem; }
.choices, .details { display: grid; grid-template-columns: 1fr 1fr; gap: var(--gap); }
.choices { margin-bottom: .4rem; } .choices > div { display: flex; flex-wrap: wrap; gap: .3rem; }
.choices .right { justify-content: flex-end; }
.frame { width: min(100%, var(--natural, 100%), max(22rem, 82vh * var(--ratio, 1))); }
.stage { position: relative; aspect-ratio: var(--ratio, 1); --wipe: 50%; overflow: hidden; background: var(--faint); }
.stage img { position: absolute; inset: 0; width: 100%; height: 100%; user-select: none; }
.stage .left { clip-path: inset(0 calc(100% - var(--wipe)) 0 0); }
.stage .divider { position: absolute; top: 0; bottom: 0; left: var(--wipe); width: 2px; margin-left: -1px;
  background: #fff; box-shadow: 0 0 3px rgba(0, 0, 0, .6); pointer-events: none; }
.stage .divider::after { content: ""; position: absolute; top: 50%; left: 50%; width: 1.3rem; height: 1.3rem;
  margin: -.65rem 0 0 -.65rem; border-radius: 50%; background: #fff; box-shadow: 0 0 3px rgba(0, 0, 0, .6); }
.stage .loupe { position: absolute; border: 1px solid rgba(255, 255, 255, .85); outline: 1px solid rgba(0, 0, 0, .45);
  pointer-events: none; }
.stage .wipe { position: absolute; inset: 0; width: 100%; height: 100%; margin: 0; opacity: 0; cursor: ew-resize;
  touch-action: pan-y; -webkit-appearance: none; appearance: none; }
.stage .wipe::-webkit-slider-thumb { -webkit-appearance: none; width: 1px; height: 100%; }
.stage .wipe::-moz-range-thumb { width: 1px; height: 100%; border: 0; }
.stage:focus-within { outline: 2px solid var(--c2); outline-offset: 2px; }
.details { margin-top: .6rem; }
.details dl, .strip dl, .gallery dl { margin: 0; font-size: .8rem; line-height: 1.35; }
.details dl { display: flex; flex-wrap: wrap; gap: 0 1rem; margin-bottom: .4rem; }
.details dl div, .strip dl div, .gallery dl div { display: flex; justify-content: space-between; gap: .4rem; }
.details dt, .strip dt, .gallery dt { color: var(--soft); }
.details dd, .strip dd, .gallery dd { margin: 0; }
.details canvas { display: block; width: 100%; } .details .difference { margin-top: var(--gap); background: #000; }
.details .zoom { aspect-ratio: 3 / 2; background: var(--faint); }
.strip { display: flex; gap: .6rem; overflow-x: auto; }
.strip figure { flex: 1 1 0; min-width: 8.5rem; margin: 0; }
.gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(11rem, 1fr)); gap: 1rem .6rem; }
.gallery figure { margin: 0; }
.strip img, .gallery img { display: block; width: 100%; height: auto; margin: .15rem 0 .35rem; }
.strip b, .gallery b { color: var(--ink); font-weight: 600; }
.strip figcaption, .gallery figcaption { white-space: nowrap; overflow: hidden; text-overflow: ellipsis; }
@media (max-width: 40rem) { .viewer { --gap: .5rem; } .details .zoom { aspect-ratio: 1; } }
@media print { .viewer { display: none; } .strip figure { break-inside: avoid; } }
)";

}  // namespace

std::string viewer(const BenchReport& report) {
    return "<div class=\"viewer\" hidden=\"hidden\">\n<p class=\"note\">Drag over the picture, or use the arrow keys, "
           "to wipe "
           "between left and right. Below: the framed part, four screen pixels to a pixel, and the difference to the "
           "reference, between displayed colours and four times as large.</p>\n<div "
           "class=\"heads\"><label>Scene<select class=\"scene\" "
           "autocomplete=\"off\">" +
           options(report.scenes, [](const BenchScene& scene) { return scene.name; }) +
           "</select></label><label>Differences<select class=\"kind\" autocomplete=\"off\"><option value=\"colour\">in "
           "colour</option><option value=\"sign\">brighter red, darker blue</option></select></label></div>\n"
           "<div class=\"frame\">\n<div class=\"choices\">\n" +
           sideChoices(report, "left") + sideChoices(report, "right") +
           "</div>\n<div class=\"stage\"><div class=\"loupe\"></div><div class=\"divider\"></div>"
           "<input class=\"wipe\" type=\"range\" min=\"0\" max=\"100\" step=\"0.5\" value=\"50\" autocomplete=\"off\" "
           "aria-label=\"how much of the left picture is seen, in percent\"/></div>\n<div class=\"details\">\n" +
           sideDetails("left") + sideDetails("right") + "</div>\n</div>\n</div>\n";
}

std::string viewerScript() { return fmt::format("<script>{}</script>\n", kScript); }

std::string pictureStyle() { return kStyle; }

}  // namespace drc
