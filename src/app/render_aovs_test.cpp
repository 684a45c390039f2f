// The layers of `drc render --aovs` that compositing and filters over time need, and the attributes beside them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/command.h"
#include "base/error.h"
#include "base/folder_testing.h"
#include "image/image_io.h"
#include "image/image_layers.h"
#include "image/motion_vectors.h"

namespace drc {
namespace {

using testing::HasSubstr;

constexpr FilmSize kSize{32, 24};

// Three objects, of which the camera sees each somewhere, before a mirror: a sphere, a mesh and an instance.
std::string worldOf(const std::string& move) {
    return "WorldBegin\n" + move + R"(
        LightSource "distant" "rgb L" [2 2 2] "point from" [1 2 -3] "point to" [0 0 0]
        Material "matte" "rgb Kd" [.5 .6 .7]
        AttributeBegin Translate -1 0 0 Rotate 20 0 0 1 Shape "sphere" "float radius" .6 AttributeEnd
        AttributeBegin Translate 1 .2 0 Shape "trianglemesh" "point P" [-.5 -.5 0 .5 -.5 .3 0 .6 0]
          "integer indices" [0 1 2] AttributeEnd
        TransformBegin Identity ObjectBegin "o" Shape "disk" "float radius" .6 ObjectEnd TransformEnd
        AttributeBegin Translate 0 1.2 .5 ObjectInstance "o" AttributeEnd
        AttributeBegin Material "mirror" Translate 0 0 3 Shape "disk" "float radius" 2 AttributeEnd
        WorldEnd)";
}
// The pixel filter is so narrow that all samples go through the pixels' centres.
std::string sceneOf(const std::string& camera, const std::string& move = "",
                    const std::string& type = "\"perspective\" \"float fov\" 30") {
    return camera + "\nCamera " + type + R"(
        PixelFilter "box" "float xwidth" .0001 "float ywidth" .0001
        Film "image" "integer xresolution" 32 "integer yresolution" 24 )" +
           worldOf(move);
}
constexpr const char* kLookAt = "LookAt .3 .4 -5  0 .2 0  0 1 0";

class RenderAovs : public FolderTest {
  protected:
    PictureFile rendered(const std::string& scene, const std::vector<std::string>& options = {"--aovs"},
                         const std::string& name = "scene.pbrt", const std::string& spp = "4") const {
        folder_.write(name, scene);
        std::vector<std::string> arguments{"render", path(name), "--quiet",   "-o", path("out.exr"),
                                           "--spp",  spp,        "--denoise", "off"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants a vector
        CLI::App app;
        addRenderCommand(app);
        app.parse(std::move(arguments));
        return readPictureFile(path("out.exr"));
    }
};

// Calls f(x, y, position, object) for all pixels that show a surface, and returns their number.
template <class F>
int forEachSurface(const PictureFile& file, const F& f) {
    const Image position = layerOf(file.image, kPositionLayer).value(),
                depth = layerOf(file.image, kDepthLayer).value(),
                object = layerOf(file.image, kObjectIndexLayer).value();
    int count = 0;
    for (int y = 0; y < position.height(); ++y)
        for (int x = 0; x < position.width(); ++x) {
            if (!(depth.at(x, y, 0) < kNoDepth)) continue;
            ++count;
            f(x, y, position.rgb(x, y), uint32_t(object.at(x, y, 0)));
        }
    return count;
}

TEST_F(RenderAovs, PositionsAreProjectedBackToTheirPixels) {
    for (const char* type :
         {"\"perspective\" \"float fov\" 30", "\"orthographic\" \"float screenwindow\" [-2 2 -1.5 1.5]"})
        for (const char* view : {kLookAt, "Scale -1 1 1 LookAt .3 .4 -5  0 .2 0  0 1 0"})
            for (const char* integrator : {"drc", "path", "direct", "bdpt", "drc-maps"}) {
                if (std::string(integrator) == "drc-maps" && view != kLookAt) continue;
                std::vector<std::string> options{"--aovs", "--integrator", integrator};
                if (std::string(integrator) == "drc-maps")
                    options.insert(options.end(), {"--passes", "1", "--map-denoiser", "none"});
                const PictureFile file = rendered(sceneOf(view, "", type), options);
                const FrameGeometry frame = frameGeometryIn(file).value();
                const Image depth = layerOf(file.image, kDepthLayer).value();
                const int count = forEachSurface(file, [&](int x, int y, const Vec3& p, uint32_t object) {
                    const auto at = pixelOf(p, frame, kSize);
                    ASSERT_TRUE(at);
                    EXPECT_NEAR(at->x, float(x) + 0.5f, 0.01f) << integrator;
                    EXPECT_NEAR(at->y, float(y) + 0.5f, 0.01f) << integrator;
                    EXPECT_NEAR(frame.worldToCamera.point(p).z, depth.at(x, y, 0), 1e-5f);
                    EXPECT_GE(object, 1u);
                });
                EXPECT_GT(count, 250) << integrator;
                EXPECT_LT(count, kSize.width * kSize.height) << integrator;
            }
}

TEST_F(RenderAovs, TellTheSurfaceOfAMirrorItself) {
    const PictureFile file = rendered(sceneOf(kLookAt));
    int mirror = 0;
    forEachSurface(file, [&](int, int, const Vec3& p, uint32_t object) {
        if (object != 4) return;
        ++mirror;
        EXPECT_NEAR(p.z, 3, 1e-4f);
    });
    EXPECT_GT(mirror, 50);
}

TEST_F(RenderAovs, WhereNothingIsSeenPositionIsZeroAndDepthFar) {
    const PictureFile file = rendered(sceneOf(kLookAt));
    const auto at = [&](const char* channel) { return file.image.at(0, 0, file.image.channelIndex(channel)); };
    EXPECT_EQ(at("Position.X"), 0);
    EXPECT_EQ(at("Depth.Z"), kNoDepth);
    EXPECT_EQ(at("IndexOB.X"), 0);
    EXPECT_EQ(at("IndexMA.X"), 0);
}

TEST_F(RenderAovs, WorldSpaceIsTheFiles) {
    const std::string there = "Translate 6000 -2000 0";
    const PictureFile file = rendered(sceneOf(std::string(kLookAt) + " Translate -6000 2000 0", there));
    double mean = 0;
    const int count = forEachSurface(file, [&](int, int, const Vec3& p, uint32_t) { mean += double(p.x); });
    EXPECT_NEAR(mean / count, 6000, 2);
    const FrameGeometry frame = frameGeometryIn(file).value();
    EXPECT_NEAR(length(frame.worldToCamera.point(Vec3(6000.3f, -1999.6f, -5))), 0, 2e-3f);
}

// Everything and the camera move together, so that the second frame shows the same point in each pixel.
TEST_F(RenderAovs, ObjectMatricesTakePositionsToTheNextFrame) {
    const std::vector<std::string> options{"--aovs", "--integrator", "path"};
    const PictureFile first = rendered(sceneOf(kLookAt), options);
    const PictureFile second = rendered(
        sceneOf(std::string(kLookAt) + " Rotate -20 0 1 0 Translate -.3 -.1 .2", "Translate .3 .1 -.2 Rotate 20 0 1 0"),
        options);
    const FrameGeometry before = frameGeometryIn(first).value(), after = frameGeometryIn(second).value();
    const Image moved = layerOf(second.image, kPositionLayer).value(), index = layerOf(second.image, "IndexOB").value();
    std::map<uint32_t, int> compared;
    forEachSurface(first, [&](int x, int y, const Vec3& p, uint32_t object) {
        if (uint32_t(index.at(x, y, 0)) != object) return;  // an edge, whose rays are rounded otherwise
        EXPECT_NEAR(length(pointInFrame(p, object, before, after) - moved.rgb(x, y)), 0, 1e-4f) << object;
        EXPECT_GT(length(p - moved.rgb(x, y)), 0.05f);
        ++compared[object];
    });
    for (const uint32_t object : {1u, 2u, 3u, 4u}) EXPECT_GT(compared[object], 10) << object;
}

TEST_F(RenderAovs, HalvesAverageToThePicture) {
    for (const char* integrator : {"path", "direct"}) {
        const PictureFile file = rendered(sceneOf(kLookAt), {"--aovs", "--integrator", integrator}, "scene.pbrt", "8");
        const auto compare = [&](const std::string& whole, const char* const* halves) {
            const Image all = rgbOfLayer(file.image, whole), a = rgbOfLayer(file.image, halves[0]),
                        b = rgbOfLayer(file.image, halves[1]);
            double difference = 0;
            for (size_t i = 0; i < all.data().size(); ++i) {
                EXPECT_NEAR((a.data()[i] + b.data()[i]) / 2, all.data()[i], 1e-5f) << integrator << whole;
                difference += double(std::abs(a.data()[i] - b.data()[i]));
            }
            EXPECT_GT(difference, 0) << integrator;
        };
        compare("", kHalfLayers);
        if (std::string(integrator) == "path") compare("direct", kDirectHalfLayers);
    }
}

TEST_F(RenderAovs, HalvesAreWrittenWhereAPictureHasThem) {
    const auto has = [](const PictureFile& file, const char* layer) { return layerOf(file.image, layer).has_value(); };
    const PictureFile drc = rendered(sceneOf(kLookAt));
    EXPECT_TRUE(has(drc, "Half A") && has(drc, "Half B") && has(drc, "direct Half A") && has(drc, "direct Half B"));
    EXPECT_FALSE(has(rendered(sceneOf(kLookAt), {"--aovs", "--integrator", "bdpt"}), "Half A"));
}

// One sample a pixel has no second half, which must not look like a black one.
TEST_F(RenderAovs, AHalfWithoutSamplesHasThePicturesMean) {
    const PictureFile file = rendered(sceneOf(kLookAt), {"--aovs", "--integrator", "path"}, "scene.pbrt", "1");
    EXPECT_EQ(rgbOfLayer(file.image, "Half A").data(), rgbOfLayer(file.image, "Half B").data());
}

TEST_F(RenderAovs, AreTheSameWithAnyNumberOfThreadsAndAfterAResume) {
    const std::string scene = sceneOf(kLookAt);
    const std::vector<float> whole = rendered(scene, {"--aovs", "--nthreads", "2"}, "scene.pbrt", "8").image.data();
    EXPECT_EQ(rendered(scene, {"--aovs", "--nthreads", "1"}, "scene.pbrt", "8").image.data(), whole);
    rendered(scene, {"--aovs", "--checkpoint", path("state")});
    EXPECT_EQ(rendered(scene, {"--aovs", "--resume", path("state")}, "scene.pbrt", "8").image.data(), whole);
}

TEST_F(RenderAovs, TheCameraIsInEveryFile) {
    const PictureFile file = rendered(sceneOf(kLookAt), {});
    EXPECT_TRUE(frameGeometryIn(file)->worldToNdc);
    EXPECT_EQ(frameGeometryIn(file)->objects.size(), 0);  // nothing tells which pixel shows which
    const PictureFile panorama = rendered(sceneOf(kLookAt, "", "\"environment\""));
    const FrameGeometry frame = frameGeometryIn(panorama).value();
    EXPECT_FALSE(frame.worldToNdc);
    const Image depth = layerOf(panorama.image, kDepthLayer).value();
    forEachSurface(panorama, [&](int x, int y, const Vec3& p, uint32_t) {
        EXPECT_NEAR(length(p - Vec3(.3f, .4f, -5)), depth.at(x, y, 0), 1e-4f);
    });
}

}  // namespace
}  // namespace drc
