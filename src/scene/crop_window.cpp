#include "scene/crop_window.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace drc {

CropWindow cropWindowOf(std::span<const double> values) {
    if (values.size() != 4) throw Error(fmt::format("must be four numbers, x0 x1 y0 y1, not {}", values.size()));
    CropWindow window{};
    for (size_t axis = 0; axis < 2; ++axis) {
        const double a = values[2 * axis], b = values[2 * axis + 1];
        if (std::isnan(a) || std::isnan(b)) throw Error("must be numbers, x0 x1 y0 y1 from 0 to 1");
        window[2 * axis] = float(std::clamp(std::min(a, b), 0., 1.));
        window[2 * axis + 1] = float(std::clamp(std::max(a, b), 0., 1.));
        if (!(window[2 * axis] < window[2 * axis + 1]))
            throw Error(
                fmt::format("is empty from {0}0 = {1:g} to {0}1 = {2:g}: it must be x0 x1 y0 y1 from 0 to 1, with "
                            "x0 < x1 and y0 < y1",
                            axis == 0 ? 'x' : 'y', a, b));
    }
    return window;
}

}  // namespace drc
