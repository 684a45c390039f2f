// Self-contained HTML pages: styles, plots and images are embedded, and nothing is fetched. Tags are closed as in XML.
#pragma once
#include <string>
#include <string_view>

#include "image/image.h"

namespace drc {

// Escapes text, also for attributes in double quotes.
std::string escapeHtml(std::string_view text);

std::string base64(std::string_view bytes);
// Linear values as an 8-bit sRGB PNG (as writePng encodes it) in a data URI, for the `src` of an img.
std::string pngDataUri(const Image& linear);

// The whole page. title is escaped here, body is not. Table cells are right-aligned for numbers. The style's classes
// are documented at its definition. `style`: additional CSS for this page.
std::string htmlPage(const std::string& title, const std::string& body, const std::string& style = "");

// "0.1234", or a dash for NaN.
std::string htmlNumber(double x);
// Three significant digits: "0.00123", "12.3", "1234". Very small and very large numbers are written as powers of ten
// with tags, NaN as a dash.
std::string htmlSignificant(double x);
// A p-value: "1.3 x 10^-82" with tags, or "< 10^-300".
std::string htmlP(double p);

}  // namespace drc
