// Two pictures given by formulas, for tests of the metrics against other implementations.
#pragma once
#include <cmath>

#include "image/image.h"

namespace drc::testing_images {

inline Image waves(float phase, float amplitude) {
    Image image(48, 40);
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 48; ++x) {
            image.setRgb(x, y,
                         Rgb(.5f + .5f * std::sin(.30f * float(x) + .11f * float(y) + phase),
                             .5f + amplitude * std::cos(.17f * float(x) - .23f * float(y)),
                             (x / 6 + y / 5) % 2 == 0 ? .8f : .1f));
        }
    }
    return image;
}

inline Image reference() { return waves(0, .4f); }

inline Image changed() {
    Image image = waves(.35f, .3f);
    for (int y = 10; y < 14; ++y)
        for (int x = 20; x < 26; ++x) image.setRgb(x, y, Rgb(1, .9f, 0));
    return image;
}

}  // namespace drc::testing_images
