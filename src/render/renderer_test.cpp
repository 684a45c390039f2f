#include "render/renderer.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "cache/enhancer.h"
#include "pbrt/scene_file.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string errorOf(const Scene& scene) {
    RenderParams params;
    params.integrator = Integrator::Path;
    try {
        const Renderer renderer(scene, params, makeIdentityEnhancer(), nullptr);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

// The film of the largest size that a file may ask for: no machine has 2.5 TiB for all of it, and any has for a part.
TEST(Renderer, PicturesBeyondTheMemoryAreRefused) {
    const std::string text =
        "Film \"image\" \"integer xresolution\" 65536 \"integer yresolution\" 65536\n"
        "WorldBegin\nShape \"sphere\"\nWorldEnd\n";
    const auto scene = pbrt::loadPbrtString(text, ".", {}, "s.pbrt");
    EXPECT_THAT(
        errorOf(*scene),
        AllOf(StartsWith("s.pbrt:1:6: a picture of 65536 x 65536 pixels needs about 2560.0 GiB of memory, and "),
              HasSubstr("choose a smaller --resolution, or a part of it by --crop")));
    const float part[4] = {0.5f, 0.501f, 0.5f, 0.501f};
    std::copy(part, part + 4, scene->settings.cropWindow);
    EXPECT_EQ(errorOf(*scene), "");
    // What the command line asks for is no fault of the file.
    const auto other = pbrt::loadPbrtString(text, ".", {FilmGeometry{60000, 60000}}, "s.pbrt");
    EXPECT_THAT(errorOf(*other), StartsWith("a picture of 60000 x 60000 pixels needs"));
}

}  // namespace
}  // namespace drc
