#include "render/film_variance.h"

namespace drc {

void FilmVariance::add(int x, int y, const Rgb& value) {
    Pixel& p = pixels_[region_.index(x, y)];
    ++p.count;
    for (int c = 0; c < 3; ++c) {
        const float difference = value[c] - p.mean[c];
        p.mean[c] += difference / float(p.count);
        p.squares[c] += difference * (value[c] - p.mean[c]);
    }
}

Rgb FilmVariance::ofMean(int x, int y) const {
    const Pixel& p = pixels_[region_.index(x, y)];
    if (p.count < 2) return Rgb(0.f);
    return Rgb(p.squares[0], p.squares[1], p.squares[2]) / (float(p.count) * float(p.count - 1));
}

}  // namespace drc
