#include "render/picture_finisher.h"

#include <gtest/gtest.h>

#include "pbrt/scene_file.h"

namespace drc {
namespace {

// What it was asked to filter.
class NotingFilter final : public PictureFilter {
  public:
    void apply(LayeredPicture& picture) const override { asComplete.push_back(picture.takenAsComplete); }
    std::string name() const override { return "noting"; }
    mutable std::vector<bool> asComplete;
};

// During the first pass a picture has few pixels, and a denoiser is soon done with it. How long finishing will take is
// measured as if it had all.
TEST(PictureFinisher, MeasuresAsForACompletePicture) {
    const auto scene = pbrt::loadPbrtString(
        "Camera \"perspective\"\nFilm \"image\" \"integer xresolution\" 100 \"integer yresolution\" 80\nWorldBegin\n"
        "LightSource \"infinite\"\nWorldEnd\n");
    RenderParams params;
    params.integrator = "path";
    params.seconds = 1000;
    Session session(*scene, params);
    ASSERT_TRUE(session.step());
    ASSERT_EQ(session.samplesDone(), 0);
    const auto filter = std::make_shared<NotingFilter>();
    PictureWriter writer(scene->sensor.settings, {"picture.exr"}, {});
    PictureFinisher finisher({{{filter}, 0.5, true, 0}}, writer);
    finisher.measure(session);
    ASSERT_FALSE(filter->asComplete.empty());
    EXPECT_EQ(std::count(filter->asComplete.begin(), filter->asComplete.end(), true), int(filter->asComplete.size()));
    EXPECT_GT(session.schedule().reserved(), 0);
}

}  // namespace
}  // namespace drc
