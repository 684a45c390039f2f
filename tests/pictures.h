// Renders pictures of a scene text and returns them as samples for estimates.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "maps/map_denoiser.h"
#include "pbrt/scene_file.h"
#include "reconstruct/surface_picture_filter.h"
#include "render/session.h"
#include "z_test.h"

namespace drc::test {

// Means over blocks of so many pixels a side. With few samples, single pixels are far from normally distributed, but
// block means nearly are. Pixels beyond the last whole block are left out.
inline constexpr int kBlock = 4;
inline std::vector<Rgb> blocksOf(const Image& image, int block = kBlock) {
    const int columns = image.width() / block, rows = image.height() / block;
    std::vector<Rgb> blocks(size_t(columns * rows), Rgb(0.f));
    for (int y = 0; y < rows * block; ++y)
        for (int x = 0; x < columns * block; ++x)
            blocks[size_t(y / block * columns + x / block)] += image.rgb(x, y) * (1.f / float(block * block));
    return blocks;
}

struct PictureSettings {
    std::string integrator;
    int count = 1, spp = 1;
    int block = kBlock;
    std::function<void(RenderParams&)> change = [](RenderParams&) {};  // sets what else is different
    Stats* stats = nullptr;
};

// Pictures with different seeds: [picture][block].
inline std::vector<std::vector<Rgb>> pictures(const Scene& scene, const PictureSettings& settings) {
    std::vector<std::vector<Rgb>> result;
    for (int seed = 0; seed < settings.count; ++seed) {
        RenderParams params;
        params.integrator = settings.integrator;
        params.seed = uint64_t(seed);
        params.spp = settings.spp;
        params.mapPasses = 2;
        params.firstSpacing = 4.f / float(scene.sensor.settings.film.height);
        params.indirect.capture.layout = MapLayout(Projection::EqualArea, 8);
        params.indirect.primarySamples = 1;
        params.maxDepth = scene.sensor.settings.maxDepth;
        params.indirect.denoiser = makeGaussianMapDenoiser(1);
        settings.change(params);
        Session session(scene, params, settings.stats);
        while (session.step()) {
        }
        EXPECT_EQ(session.samplesDone(), settings.spp);
        LayeredPicture picture = session.picture();
        if (traitsOf(settings.integrator).maps) SurfacePictureFilter(true, true).apply(picture);
        result.push_back(blocksOf(picture.beauty, settings.block));
    }
    return result;
}

inline std::vector<std::vector<Rgb>> pictures(const std::string& text, const std::string& integrator, int count,
                                              int spp) {
    const auto scene = pbrt::loadPbrtString(text);
    return pictures(*scene, {.integrator = integrator, .count = count, .spp = spp});
}

}  // namespace drc::test
