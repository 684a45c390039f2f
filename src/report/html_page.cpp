#include "report/html_page.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "image/image_io.h"
#include "math/rank_statistics.h"

namespace drc {
namespace {

// table.measures   columns of equal width, so that several tables line up
// .name, td.text   text in a table, whose other cells are numbers; td.text wraps
// tbody.group      a block of rows with a line above it; th.block: its title; td.best: bold
// div.wide         may be wider than the page and scrolls on its own
// .lead, .note     less prominent and smaller than other paragraphs
// .plots           plots (svg.plot; svg_box_plot.h, svg_line_plot.h) side by side
// .legend          the names that belong to the plots' colours
// .contents        links to the sections
// small, .failure  a qualification below a number; an error message in place of one
// .example, .maps  images in a row, each --map pixels wide, with captions above and below
// .c0 to .c7       the colours of series, for everything drawn in currentColor
constexpr const char* kStyle = R"(
:root { color-scheme: light dark;
  --paper: #fdfdfb; --ink: #1d1f21; --soft: #63676b; --rule: #d9d9d4; --faint: #f2f2ee;
  --c0: #85898d; --c1: #b57a1c; --c2: #22689c; --c3: #2f8456; --c4: #8a4a9c; --c5: #b4443f; --c6: #4d7c86; --c7: #7a6a3a; }
@media (prefers-color-scheme: dark) { :root {
  --paper: #17191b; --ink: #e3e3df; --soft: #9a9da0; --rule: #37393c; --faint: #202326;
  --c0: #9da1a5; --c1: #d9a145; --c2: #5fa8df; --c3: #5fbb88; --c4: #c08ad2; --c5: #e67f78; --c6: #86b6c0; --c7: #b9a66b; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2.5rem 1.5rem 4rem; max-width: 68rem; background: var(--paper); color: var(--ink);
  font: 15px/1.5 system-ui, "Segoe UI", "Helvetica Neue", Arial, sans-serif; font-variant-numeric: tabular-nums lining-nums; }
h1 { font-size: 1.75rem; line-height: 1.2; font-weight: 600; margin: 0 0 .4rem; letter-spacing: -.01em; }
h2 { font-size: 1.25rem; font-weight: 600; margin: 3rem 0 .3rem; padding-top: .9rem; border-top: 2px solid var(--ink); }
h3 { font-size: 1rem; font-weight: 600; margin: 2rem 0 .5rem; }
p { margin: .4rem 0; max-width: 46rem; }
.lead, .note, figcaption { color: var(--soft); }
.note, figcaption { font-size: .87rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .87rem; line-height: 1.35; margin: .6rem 0; }
th, td { padding: .18rem .7rem; text-align: right; vertical-align: top; white-space: nowrap; font-weight: 400; }
th:first-child, td:first-child { padding-left: 0; }
thead th { color: var(--soft); font-weight: 500; }
thead tr.span th { text-align: center; border-bottom: 1px solid var(--rule); }
thead tr:last-child th { border-bottom: 1px solid var(--ink); }
tbody.group + tbody.group tr:first-child > * { border-top: 1px solid var(--rule); }
tbody:last-child tr:last-child > * { border-bottom: 1px solid var(--ink); }
tbody tr:first-child > * { padding-top: .35rem; }
tbody tr:last-child > * { padding-bottom: .35rem; }
table.measures { table-layout: fixed; width: 100%; min-width: 60rem; }
table.measures thead th:first-child { width: 9.5rem; }
table.measures .name, .block { white-space: normal; overflow-wrap: anywhere; }
.name { text-align: left; }
.block { text-align: left; font-weight: 600; }
td.best { font-weight: 700; }
td.text { text-align: left; white-space: normal; overflow-wrap: anywhere; min-width: 14rem; }
td.soft, th.soft, tr.soft > * { color: var(--soft); }
.gap { border-left: 1.2rem solid transparent; }
sup { font-size: .72em; line-height: 0; }
details { margin: .5rem 0; } summary { cursor: pointer; color: var(--soft); font-size: .87rem; }
code { font: .92em ui-monospace, "SF Mono", Consolas, monospace; }
.c0 { color: var(--c0); } .c1 { color: var(--c1); } .c2 { color: var(--c2); } .c3 { color: var(--c3); }
.c4 { color: var(--c4); } .c5 { color: var(--c5); } .c6 { color: var(--c6); } .c7 { color: var(--c7); }
.plots { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(20rem, 100%), 1fr)); gap: 1rem 1.6rem;
  margin: .6rem 0; }
svg.plot { display: block; width: 100%; height: auto; overflow: visible; }
svg.plot text { font-size: 11px; fill: var(--ink); }
svg.plot .title { font-size: 12px; font-weight: 600; }
svg.plot .tick { fill: var(--soft); font-size: 10px; }
svg.plot .grid { stroke: var(--rule); stroke-width: 1; }
svg.plot .whisker { stroke: currentColor; stroke-width: 1.3; fill: none; }
svg.plot .box { stroke: currentColor; stroke-width: 1.3; fill: currentColor; fill-opacity: .22; }
svg.plot .median { stroke: currentColor; stroke-width: 2.6; }
svg.plot .mean { fill: var(--paper); stroke: currentColor; stroke-width: 1.4; }
svg.plot .line { stroke: currentColor; stroke-width: 1.6; fill: none; stroke-linejoin: round; }
svg.plot .mark { stroke: currentColor; stroke-width: 1.4; fill: var(--paper); }
svg.plot circle.mark { fill: currentColor; }
.contents { max-width: none; font-size: .87rem; } .contents a { margin-right: 1.1rem; }
a { color: var(--c2); text-decoration: none; } a:hover { text-decoration: underline; }
small { display: block; font-size: .82em; color: var(--soft); font-weight: 400; }
.failure { color: var(--c5); }
.legend { font-size: .87rem; max-width: none; }
.legend span { margin-right: 1.3rem; white-space: nowrap; }
.legend i { display: inline-block; width: 1.4em; margin-right: .45em; border-top: 3px solid; vertical-align: .25em; }
.example { margin: 0 0 1.6rem; padding-top: .7rem; border-top: 1px solid var(--rule); }
.example h4 { font-size: .93rem; font-weight: 600; margin: 0 0 .5rem; }
.example h4 span { font-weight: 400; color: var(--soft); }
.maps { display: flex; gap: .9rem; overflow-x: auto; font-size: .8rem; line-height: 1.35; }
.maps figure { margin: 0; flex: none; width: var(--map); }
.maps figure > div { white-space: nowrap; overflow: hidden; text-overflow: ellipsis; }
.maps img { display: block; width: var(--map); height: var(--map); margin: .15rem 0 .35rem; image-rendering: pixelated; }
.maps img.bar { height: .8rem; image-rendering: auto; }
.maps dl { display: grid; grid-template-columns: auto auto; margin: 0; }
.maps dt { color: var(--soft); } .maps dd { margin: 0; text-align: right; }
.ends { display: flex; justify-content: space-between; color: var(--soft); }
@media print { h2 { break-after: avoid; } .example, svg.plot, tbody { break-inside: avoid; } }
)";

std::string minus(int x) { return fmt::format("{}{}", x < 0 ? "&#8722;" : "", std::abs(x)); }

std::string scientific(double x, int decimals) {
    const std::string text = fmt::format("{:.{}e}", x, decimals);  // note that 9.96e-5 is rounded to 1.0e-04
    const size_t e = text.find('e');
    return fmt::format("{}&#8201;&#215;&#8201;10<sup>{}</sup>", text.substr(0, e),
                       minus(std::stoi(text.substr(e + 1))));
}

}  // namespace

std::string escapeHtml(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            case '\'':
                escaped += "&#39;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

std::string base64(std::string_view bytes) {
    constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](size_t k) { return i + k < bytes.size() ? uint32_t(uint8_t(bytes[i + k])) : 0u; };
        const uint32_t three = byte(0) << 16 | byte(1) << 8 | byte(2);
        for (int k = 0; k < 4; ++k) text += i + size_t(k) <= bytes.size() ? kDigits[three >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::string pngDataUri(const Image& linear) { return "data:image/png;base64," + base64(encodePng(linear)); }

std::string htmlPage(const std::string& title, const std::string& body, const std::string& style) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
        "<title>{}</title>\n<style>{}{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
        escapeHtml(title), kStyle, style, body);
}

std::string htmlNumber(double x) { return std::isnan(x) ? "&#8211;" : fmt::format("{:.4f}", x); }

std::string htmlSignificant(double x) {
    if (std::isnan(x)) return htmlNumber(x);
    if (std::isinf(x)) return x > 0 ? "&#8734;" : "&#8722;&#8734;";
    const double size = std::abs(std::stod(fmt::format("{:.2e}", x)));  // rounded first: 9.996 becomes 10.0
    if (size == 0) return "0";
    if (size >= 1e-4 && size < 1e5) {
        const int decade = int(std::floor(std::log10(size) + 1e-9));
        return fmt::format("{:.{}f}", x, std::max(0, 2 - decade));
    }
    return scientific(x, 2);
}

std::string htmlP(double p) {
    if (std::isnan(p)) return htmlNumber(p);
    if (p < kSmallestP) return fmt::format("&lt;&#8201;10<sup>&#8722;{:.0f}</sup>", -std::log10(kSmallestP));
    if (p >= 0.001) return fmt::format("{:#.2g}", p);
    return scientific(p, 1);
}

}  // namespace drc
