// The viewer of a comparison's pictures: two of them with a wipe between, their magnified part and their differences to
// the reference. It finds a picture as figure[data-scene][data-method][data-budget] on the page. It has no "less than"
// sign, so that the page's tags nest as those of XML do.
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
