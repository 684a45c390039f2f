// Renders pictures of a scene text and returns them as samples for estimates.
#pragma once
#include <string>
#include <vector>

#include "cache/map_denoiser.h"
#include "pbrt/scene_file.h"
#include "render/session.h"
#include "render/surface_picture_filter.h"
#include "z_test.h"

namespace drc::test {

// Means over blocks of kBlock x kBlock pixels. With few samples, single pixels are far from normally distributed, but
// block means nearly are.
inline constexpr int kBlock = 4;
inline std::vector<Rgb> blocksOf(const Image& image) {
    std::vector<Rgb> blocks(size_t(image.width() / kBlock * (image.height() / kBlock)), Rgb(0.f));
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            blocks[size_t(y / kBlock * (image.width() / kBlock) + x / kBlock)] +=
                image.rgb(x, y) * (1.f / (kBlock * kBlock));
    return blocks;
}

// Pictures with different seeds: [picture][block].
inline std::vector<std::vector<Rgb>> pictures(const std::string& text, const std::string& integrator, int count,
                                              int spp) {
    const auto scene = pbrt::loadPbrtString(text);
    std::vector<std::vector<Rgb>> result;
    for (int seed = 0; seed < count; ++seed) {
        RenderParams params;
        params.integrator = integrator;
        params.seed = uint64_t(seed);
        params.spp = spp;
        params.mapPasses = 2;
        params.firstSpacing = 4.f / float(scene->settings.film.height);
        params.indirect.capture.layout = MapLayout(Projection::EqualArea, 8);
        params.indirect.primarySamples = 1;
        params.maxDepth = scene->settings.maxDepth;
        Session session(*scene, params, makeGaussianMapDenoiser(1), nullptr);
        while (session.step()) {
        }
        EXPECT_EQ(session.samplesDone(), spp);
        LayeredPicture picture = session.picture();
        if (usesMaps(integrator)) SurfacePictureFilter(true, true).apply(picture);
        result.push_back(blocksOf(picture.beauty));
    }
    return result;
}

}  // namespace drc::test
