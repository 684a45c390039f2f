// Pages that are one file: style, drawings and pictures are in it, and nothing is fetched. Tags are closed as in XML.
#pragma once
#include <string>
#include <string_view>

#include "image/image.h"

namespace drc {

// For text and for attributes in double quotes.
std::string escapeHtml(std::string_view text);

std::string base64(std::string_view bytes);
// An 8-bit sRGB PNG of linear values, as writePng makes it: for the `src` of an img.
std::string pngDataUri(const Image& linear);

// The whole page. title is escaped here; body is not. Tables have right-aligned numbers; the classes of the style are
// listed at its definition. `style`: CSS of this page alone, after that of all.
std::string htmlPage(const std::string& title, const std::string& body, const std::string& style = "");

// "0.1234", or a dash for NaN.
std::string htmlNumber(double x);
// Three digits that count: "0.00123", "12.3", "1234"; very small and very large ones as powers of ten in tags; a dash
// for NaN.
std::string htmlSignificant(double x);
// "1.3 x 10^-82" in tags, or "< 10^-300".
std::string htmlP(double p);

}  // namespace drc
