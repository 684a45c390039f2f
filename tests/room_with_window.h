// A room that is closed but for one window.
#pragma once
#include <string>

#include "base/folder_testing.h"
#include "image/image_io.h"
#include "test_scenes.h"
#include "z_test.h"

namespace drc::test {

// pbrt-v3 text of a room that sees the sky through one window, [-1, 0] x [1, 2] at x = 2. The sky also lights a glossy
// ball by BSDF samples.
inline std::string roomWithWindow() {
    return "LookAt 0 -1.9 1.5  0 0 1  0 0 1\nCamera \"perspective\" \"float fov\" 70\n"
           "Film \"image\" \"integer xresolution\" 12 \"integer yresolution\" 8\nIntegrator \"path\"\nWorldBegin\n"
           "LightSource \"infinite\" \"rgb L\" [3 4 5]\n"
           "Material \"matte\" \"rgb Kd\" [0.6 0.5 0.4]\n" +
           quad("-2 -2 0", "2 -2 0", "2 2 0", "-2 2 0") + quad("-2 -2 3", "-2 2 3", "2 2 3", "2 -2 3") +
           quad("-2 2 0", "2 2 0", "2 2 3", "-2 2 3") + quad("-2 -2 0", "-2 -2 3", "2 -2 3", "2 -2 0") +
           quad("-2 -2 0", "-2 2 0", "-2 2 3", "-2 -2 3") + quad("2 -2 0", "2 -2 3", "2 -1 3", "2 -1 0") +
           quad("2 0 0", "2 0 3", "2 2 3", "2 2 0") + quad("2 -1 0", "2 -1 1", "2 0 1", "2 0 0") +
           quad("2 -1 2", "2 -1 3", "2 0 3", "2 0 2") +
           "Material \"plastic\" \"rgb Kd\" [0.2 0.2 0.2] \"rgb Ks\" [0.5 0.5 0.5] \"float roughness\" 0.2\n"
           "Translate 0.3 0.3 0.6\nShape \"sphere\" \"float radius\" 0.5\nWorldEnd\n";
}

inline const std::string kConstantSky = "LightSource \"infinite\" \"rgb L\" [3 4 5]";

// roomWithWindow() as pbrt-v4 text, under another sky. environment: its directive.
inline std::string roomUnder(const std::string& environment) {
    std::string text = respelt(roomWithWindow(), "\"plastic\" \"rgb Kd\" [0.2 0.2 0.2] \"rgb Ks\" [0.5 0.5 0.5]",
                               "\"coateddiffuse\" \"rgb reflectance\" [0.2 0.2 0.2]");
    return respelt(inWordsOfV4(text), kConstantSky, environment);
}

// A sky with a bright half and a small sun that shines into the room.
inline std::string sky(const TemporaryFolder& folder) {
    Image square(32, 32);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) square.setRgb(x, y, x > 16 ? Rgb(2, 3, 4) : Rgb(0.3f, 0.2f, 0.2f));
    square.setRgb(24, 14, Rgb(300, 250, 200));
    writeExr(folder.path("sky.exr"), square);
    return "LightSource \"infinite\" \"string filename\" \"" + folder.path("sky.exr") + "\"";
}

// Means over the columns of the picture that do not show the window, whose edge is noise of another kind.
inline Estimate besideTheWindow(const Estimate& pixels) {
    constexpr int kWidth = 12, kFirst = 3;
    Estimate means{std::vector<double>(27), std::vector<double>(27), std::vector<double>(27)};
    const size_t rows = pixels.mean.size() / 3 / kWidth;
    for (size_t y = 0; y < rows; ++y)
        for (size_t x = kFirst; x < kWidth; ++x)
            for (size_t c = 0; c < 3; ++c) {
                const size_t from = (y * kWidth + x) * 3 + c, to = (x - kFirst) * 3 + c;
                const double variance = pixels.variance[from] / double(rows * rows);
                means.mean[to] += pixels.mean[from] / double(rows);
                means.variance[to] += variance;
                means.freedom[to] += variance * variance / pixels.freedom[from];
            }
    for (size_t i = 0; i < means.freedom.size(); ++i)
        means.freedom[i] = means.freedom[i] > 0 ? means.variance[i] * means.variance[i] / means.freedom[i] : 1e9;
    return means;
}

inline double total(const std::vector<double>& values) {
    double sum = 0;
    for (const double v : values) sum += v;
    return sum;
}

}  // namespace drc::test
