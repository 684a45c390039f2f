#include "pbrt/world_key.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/folder_testing.h"
#include "pbrt/scene_file.h"

namespace drc::pbrt {
namespace {

class WorldKey : public FolderTest {
  protected:
    std::optional<uint64_t> keyOf(const std::string& text, const std::string& name = "s.pbrt") const {
        folder_.write(name, text);
        return worldKey(path(name));
    }
    const std::string before_ =
        "LookAt 0 0 -3 0 0 0 0 1 0\nCamera \"perspective\" \"float fov\" 40\nSampler \"halton\"\n";
    const std::string world_ = "WorldBegin\nTranslate 1 2 3\nShape \"sphere\"\nWorldEnd\n";
};

TEST_F(WorldKey, KnowsNothingOfTheCamera) {
    const auto key = keyOf(before_ + world_);
    ASSERT_TRUE(key);
    for (const char* camera :
         {"Sampler \"halton\"\n", "Camera \"orthographic\" Sampler \"halton\"\n",
          "Scale -1 1 1 Rotate 3 0 1 0 Translate 1 1 1 Transform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1]\nSampler "
          "\"halton\"\n",
          "ActiveTransform EndTime Identity ActiveTransform All ConcatTransform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1] "
          "CoordinateSystem \"c\" Camera \"perspective\" # a comment\nSampler \"halton\"\n",
          "Film \"image\" \"string filename\" \"b.exr\" \"integer xresolution\" 9 Sampler \"halton\"\n"})
        EXPECT_EQ(keyOf(camera + world_), key) << camera;
    // Also of files that are included.
    folder_.write("camera.pbrt", "LookAt 9 9 9 0 0 0 0 1 0\nCamera \"environment\"\n");
    folder_.write("world.pbrt", "Translate 1 2 3\nShape \"sphere\"\n");
    EXPECT_EQ(keyOf("Include \"camera.pbrt\" Sampler \"halton\"\nWorldBegin Include \"world.pbrt\" WorldEnd"), key);
}

TEST_F(WorldKey, KnowsAllElse) {
    const auto key = keyOf(before_ + world_);
    for (const std::string& text :
         {before_ + "WorldBegin\nTranslate 1 2 4\nShape \"sphere\"\nWorldEnd\n",
          before_ + "WorldBegin\nTranslate 1 2 3\nShape \"disk\"\nWorldEnd\n",
          before_ + "WorldBegin\nTranslate 1 2 3\nShape \"sphere\" \"float radius\" 2\nWorldEnd\n",
          before_ + "WorldBegin\nTranslate 1 2 3\nLookAt 0 0 1 0 0 0 0 1 0\nShape \"sphere\"\nWorldEnd\n",
          before_ + "TransformTimes 0 1\n" + world_, before_ + "Integrator \"path\"\n" + world_,
          before_ + "PixelFilter \"box\"\n" + world_,
          before_ + "MakeNamedMedium \"m\" \"string type\" \"homogeneous\"\n" + world_})
        EXPECT_NE(keyOf(text), key) << text;
    // A scene that is moved stays the same.
    std::filesystem::create_directory(path("other"));
    EXPECT_EQ(keyOf(before_ + world_, "other/s.pbrt"), key);
    // The world is where the camera is.
    EXPECT_FALSE(keyOf(before_ + "WorldBegin CoordSysTransform \"camera\" Shape \"sphere\" WorldEnd"));
    EXPECT_THROW(worldKey(path("none.pbrt")), Error);
}

TEST_F(WorldKey, TheCameraAloneIsThatOfTheWholeScene) {
    // Far from the origin, which is moved there.
    folder_.write("s.pbrt",
                  "LookAt 1000 2 -3 1000 2 0 0 1 0\nCamera \"perspective\" \"float fov\" 40\n"
                  "Film \"image\" \"integer xresolution\" 40 \"integer yresolution\" 30\n"
                  "WorldBegin\nTranslate 1000 2 3\nShape \"sphere\"\nWorldEnd\n");
    const auto whole = loadPbrtFile(path("s.pbrt"));
    EXPECT_NE(whole->origin, Vec3(0.f));
    const auto camera = loadPbrtCamera(path("s.pbrt"), whole->origin);
    EXPECT_TRUE(camera->primitives.empty());
    EXPECT_EQ(camera->sensor.settings.film.width, 40);
    for (const Vec2& film : {Vec2(3, 4), Vec2(20, 15)}) {
        const Ray a = whole->sensor.camera->generateRay(film, Vec2(0.5f), 0.5f).ray;
        const Ray b = camera->sensor.camera->generateRay(film, Vec2(0.5f), 0.5f).ray;
        EXPECT_EQ(a.o, b.o);
        EXPECT_EQ(a.d, b.d);
    }
}

}  // namespace
}  // namespace drc::pbrt
