#include "render/film.h"

namespace drc {

void FilmLayer::add(int x, int y, const Rgb& value, float filterWeight) {
    Pixel& p = pixels_[region_.index(x, y)];
    for (int c = 0; c < 3; ++c) p.sum[c] += double(filterWeight) * double(value[c]);
    p.weight += double(filterWeight);
    p.count += 1;
}

Rgb FilmLayer::value(int x, int y) const {
    const Pixel& p = pixels_[region_.index(x, y)];
    if (p.count == 0) return Rgb(0.f);
    const double divisor = filterDivisor(p.weight, p.count);
    return Rgb(float(p.sum[0] / divisor), float(p.sum[1] / divisor), float(p.sum[2] / divisor));
}

Image FilmLayer::image(float scale) const {
    Image image(region_.width(), region_.height());
    for (int y = 0; y < region_.height(); ++y)
        for (int x = 0; x < region_.width(); ++x) image.setRgb(x, y, value(region_.x0 + x, region_.y0 + y) * scale);
    return image;
}

}  // namespace drc
