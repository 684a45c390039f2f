#include "image/premultiply.h"

namespace drc {

Image unpremultiplied(const Image& colours, const Image& alpha) {
    Image result = colours;
    for (int y = 0; y < result.height(); ++y)
        for (int x = 0; x < result.width(); ++x) {
            const float a = alpha.at(x, y, 0), scale = a > 0 ? 1 / a : 0;
            for (int c = 0; c < result.channels(); ++c) result.at(x, y, c) *= scale;
        }
    return result;
}

Image withAlpha(const Image& colours, const Image& alpha) {
    std::vector<std::string> names = colours.channelNames();
    names.push_back("A");
    Image result(colours.width(), colours.height(), std::move(names));
    for (int y = 0; y < result.height(); ++y)
        for (int x = 0; x < result.width(); ++x) {
            for (int c = 0; c < colours.channels(); ++c) result.at(x, y, c) = colours.at(x, y, c);
            result.at(x, y, colours.channels()) = alpha.at(x, y, 0);
        }
    return result;
}

}  // namespace drc
