"use strict";
const $ = id => document.getElementById(id);
const screen = $("screen"), pen = screen.getContext("2d");

// ---- Values of the picture -------------------------------------------------------------------------------------
// Pictures arrive as halves. A table turns each of the 65536 into a number.
const halfTable = new Float32Array(65536);
for (let i = 0; i < 65536; ++i) {
  const sign = i >> 15 ? -1 : 1, exponent = i >> 10 & 31, fraction = i & 1023;
  halfTable[i] = exponent === 31 ? (fraction ? NaN : sign * Infinity)
    : exponent === 0 ? sign * fraction * 2 ** -24 : sign * (1 + fraction / 1024) * 2 ** (exponent - 15);
}
class Picture {
  constructor(bytes) {
    const head = new Uint32Array(bytes, 0, 4);
    [this.width, this.height, this.channels, this.number] = head;
    this.halves = new Uint16Array(bytes, 16);
    this.canvas = document.createElement("canvas");
    this.canvas.width = this.width;
    this.canvas.height = this.height;
    this.drawnAs = "";
  }
  at(x, y) {
    const values = [], i = (y * this.width + x) * this.channels;
    for (let c = 0; c < this.channels; ++c) values.push(halfTable[this.halves[i + c]]);
    return values;
  }
}

// ---- From linear radiance to the screen ------------------------------------------------------------------------
const srgb = x => x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055;
const byte = x => Math.max(0, Math.min(255, Math.round(255 * x)));
// Curves are tabulated over the logarithm of their argument: 256 steps a stop.
const kLow = -20, kHigh = 20, kSteps = 256;
function tabulated(curve) {
  const table = new Float32Array((kHigh - kLow) * kSteps + 1);
  for (let i = 0; i < table.length; ++i) table[i] = curve(2 ** (kLow + i / kSteps));
  return x => x > 2 ** kLow ? table[Math.min(table.length - 1, Math.round((Math.log2(x) - kLow) * kSteps))] : curve(Math.max(0, x));
}
// The same formulas as src/image/view_transform.cpp, where they are explained.
const kGrey = 0.18, clamp01 = x => Math.max(0, Math.min(1, x));
const narkowicz = x => x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
const kFilmicScale = (() => {
  const a = 2.51 - 2.43 * kGrey, b = 0.03 - 0.59 * kGrey, c = -0.14 * kGrey;
  return (-b + Math.sqrt(b * b - 4 * a * c)) / (2 * a) / kGrey;
})();
function agxCode(radiance) {
  if (!(radiance > 0)) return 0;
  const below = 10, above = 6.5, slope = 2.4, power = 1.5;
  const pivotX = below / (below + above), pivotY = kGrey ** (1 / 2.4);
  const x = clamp01((Math.log2(radiance / kGrey) + below) / (below + above)), isAbove = x > pivotX;
  const distance = Math.abs(x - pivotX), run = isAbove ? 1 - pivotX : pivotX, rise = isAbove ? 1 - pivotY : pivotY;
  const bend = ((slope * run / rise) ** power - 1) * (distance / run) ** power, y = slope * distance / (1 + bend) ** (1 / power);
  return isAbove ? pivotY + y : pivotY - y;
}
// Every channel is pulled by a share towards a mean of all.
function inset(share) {
  const weights = [0.2120053548, 0.3921825078, 0.3958121374], matrix = [];
  for (let row = 0; row < 3; ++row) for (let column = 0; column < 3; ++column) matrix.push((row === column ? 1 - share : 0) + share * weights[column]);
  return matrix;
}
const viewTransforms = {
  srgb: { curve: x => srgb(clamp01(x)) },
  filmic: { curve: x => srgb(clamp01(narkowicz(kFilmicScale * Math.min(x, 1e6)))) },
  agx: { from: inset(0.2), curve: agxCode, to: inset(-0.25), encode: code => srgb(clamp01(Math.max(code, 0) ** 2.4)) },
};

let layer = "beauty", exposure = 0, view = "srgb", current = null, reference = null;
// Layers that are not radiance are shown by fixed rules.
function render(picture, name) {
  const key = [name, exposure, view].join();
  if (picture.drawnAs === key) return;
  picture.drawnAs = key;
  const { width, height, channels, halves } = picture, pixels = new ImageData(width, height), out = pixels.data;
  const n = width * height;
  if (name === "normal") {
    for (let i = 0; i < n; ++i) for (let c = 0; c < 3; ++c) out[4 * i + c] = byte(0.5 + 0.5 * halfTable[halves[3 * i + c]]);
  } else if (name === "albedo") {
    for (let i = 0; i < n; ++i) for (let c = 0; c < 3; ++c) out[4 * i + c] = byte(srgb(halfTable[halves[3 * i + c]]));
  } else if (channels === 1) {
    // From zero, which is black, to the greatest finite value, which is white.
    let most = 0;
    for (let i = 0; i < n; ++i) { const v = halfTable[halves[i]]; if (v > most && v < Infinity) most = v; }
    for (let i = 0; i < n; ++i) { const v = byte(srgb(halfTable[halves[i]] / (most || 1))); out[4 * i] = out[4 * i + 1] = out[4 * i + 2] = v; }
  } else {
    const gain = 2 ** exposure * (name === "variance" ? 16 : 1), transform = viewTransforms[view];
    if (!transform.from) {
      // The curve acts on single channels, so one table over all halves suffices.
      const table = new Uint8ClampedArray(65536);
      for (let i = 0; i < 65536; ++i) { const v = halfTable[i] * gain; table[i] = v > 0 ? byte(transform.curve(v)) : 0; }
      for (let i = 0, k = 0, m = 3 * n; i < m; i += 3, k += 4) {
        out[k] = table[halves[i]]; out[k + 1] = table[halves[i + 1]]; out[k + 2] = table[halves[i + 2]];
      }
    } else {
      const curve = transform.table ??= tabulated(transform.curve), a = transform.from, b = transform.to;
      for (let i = 0, k = 0, m = 3 * n; i < m; i += 3, k += 4) {
        const r = halfTable[halves[i]] * gain, g = halfTable[halves[i + 1]] * gain, v = halfTable[halves[i + 2]] * gain;
        const x = curve(a[0] * r + a[1] * g + a[2] * v), y = curve(a[3] * r + a[4] * g + a[5] * v), z = curve(a[6] * r + a[7] * g + a[8] * v);
        out[k] = byte(transform.encode(b[0] * x + b[1] * y + b[2] * z));
        out[k + 1] = byte(transform.encode(b[3] * x + b[4] * y + b[5] * z));
        out[k + 2] = byte(transform.encode(b[6] * x + b[7] * y + b[8] * z));
      }
    }
  }
  for (let k = 3; k < out.length; k += 4) out[k] = 255;
  picture.canvas.getContext("2d").putImageData(pixels, 0, 0);
}
