#include "integrators/render_params.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/folder_testing.h"
#include "integrators/integrator.h"
#include "pbrt/scene_file.h"

namespace drc {
namespace {

using testing::HasSubstr;

std::unique_ptr<Scene> sceneFor(const std::string& integrator) {
    return pbrt::loadPbrtString("Integrator \"" + integrator +
                                "\" \"integer maxdepth\" 7\nSampler \"random\" \"integer pixelsamples\" 9\n"
                                "WorldBegin\nShape \"sphere\"\nWorldEnd\n");
}

RenderParams resolvedFor(const std::string& integrator, Quality quality = Quality::Standard) {
    RenderParams params;
    params.integrator = integrator;
    params.quality = quality;
    return resolved(params, sceneFor("path")->sensor.settings);
}

TEST(RenderParams, IntegratorsOfFiles) {
    for (const auto& [named, meant] : std::vector<std::pair<std::string, std::string>>{
             {"iispt", "drc"}, {"path", "path"}, {"volpath", "path"}, {"bdpt", "bdpt"}, {"directlighting", "direct"}}) {
        RenderParams params;
        params.integrator = "scene";
        const RenderParams found = resolved(params, sceneFor(named)->sensor.settings);
        EXPECT_EQ(found.integrator, meant) << named;
        EXPECT_EQ(found.spp, 9) << named;
        EXPECT_EQ(found.maxDepth, 7) << named;
    }
    EXPECT_EQ(resolved({}, sceneFor("path")->sensor.settings).integrator, "drc");
}

// Map passes bring the indirect light: fewer camera samples do for the rest.
TEST(RenderParams, EffortsAreThoseOfTheKindOfIntegrator) {
    for (const std::string& name : integratorNames()) {
        const bool maps = name == "drc-maps";
        EXPECT_EQ(traitsOf(name).maps, maps) << name;
        EXPECT_EQ(resolvedFor(name, Quality::Draft).spp, 16) << name;
        EXPECT_EQ(resolvedFor(name).spp, maps ? 64 : 128) << name;
        EXPECT_EQ(resolvedFor(name, Quality::High).spp, maps ? 256 : 1024) << name;
    }
}

TEST(RenderParams, OnlyLayersOfRadianceMapsHaveTheSurfaceFilter) {
    for (const std::string& name : integratorNames()) {
        RenderParams params;
        params.integrator = name;
        params.denoise = Denoise::Surface;
        const std::string error = errorOf([&] { resolved(params, sceneFor("path")->sensor.settings); });
        if (traitsOf(name).maps)
            EXPECT_EQ(error, "") << name;
        else
            EXPECT_THAT(error, HasSubstr("--denoise surface: it filters the layers of --integrator drc-maps")) << name;
    }
}

}  // namespace
}  // namespace drc
