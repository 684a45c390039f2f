#include "pbrt/texture_files.h"

#include <gmock/gmock.h>

#include <random>

#include "image/image_io.h"
#include "pbrt/scene_file.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;

// PNG files of noise, and one that is cut short.
class TextureFilesTest : public testing::Test {
  protected:
    TextureFilesTest() {
        std::mt19937 rng(3);
        for (int i = 0; i < kImages; ++i) {
            Image image(61 + i, 300);
            for (float& v : image.data()) v = float(rng() % 256) / 255;
            const std::string bytes = encodePng(image);
            paths_.push_back(folder_.write("t" + std::to_string(i) + ".png", bytes));
            if (i == 0) folder_.write("damaged.png", bytes.substr(0, bytes.size() / 2));
        }
    }
    ~TextureFilesTest() override { setThreadCount(threads_); }

    static constexpr int kImages = 6;
    const int threads_ = threadCount();
    TemporaryFolder folder_;
    std::vector<std::string> paths_;
};

TEST_F(TextureFilesTest, AnyNumberOfThreadsReadsTheSame) {
    std::vector<Rgb> first;
    for (const int threads : {1, 2, 4}) {
        setThreadCount(threads);
        TextureFiles files;
        std::vector<std::shared_ptr<const RgbPyramid>> colors;
        std::vector<std::shared_ptr<const FloatPyramid>> scalars;
        for (const std::string& path : paths_) {
            colors.push_back(files.color(path, {}, {}));
            scalars.push_back(files.scalar(path, {.gamma = TexelGamma::Linear}, {}));
            EXPECT_EQ(files.color(path, {}, {}), colors.back());
        }
        files.finish();
        std::vector<Rgb> values;
        size_t bytes = 0;
        for (int i = 0; i < kImages; ++i) {
            bytes += colors[size_t(i)]->bytes() + scalars[size_t(i)]->bytes();
            for (float x = 0; x < 1; x += 0.03f)
                for (const float width : {0.f, 0.02f, 0.3f}) {
                    const Vec2 st(x, 7 * x);
                    values.push_back(colors[size_t(i)]->lookup(st, width, ImageWrap::Repeat));
                    values.push_back(Rgb(scalars[size_t(i)]->lookup(st, width, ImageWrap::Repeat)));
                }
        }
        EXPECT_EQ(files.bytes(), bytes);
        if (first.empty()) first = values;
        EXPECT_EQ(values, first) << threads;
    }
    // The finest level has what the files say.
    const Image image = readImage(paths_[2]);
    const float s = 10.5f / float(image.width()), t = 1 - 20.5f / float(image.height());
    TextureFiles files;
    const auto texture = files.color(paths_[2], {.gamma = TexelGamma::Linear}, {});
    files.finish();
    EXPECT_LT(length(texture->lookup(Vec2(s, t), 0, ImageWrap::Repeat) - image.rgb(10, 20)), 1e-4f);
}

// Errors come in the order of the file, whatever is found first.
TEST_F(TextureFilesTest, TheFirstErrorOfTheFileIsReported) {
    const auto texture = [](const std::string& name, const std::string& file) {
        return "Texture \"" + name + "\" \"spectrum\" \"imagemap\" \"string filename\" \"" + file + "\"\n";
    };
    const std::string begin = "Camera \"perspective\"\nWorldBegin\n" + texture("a", "t0.png");
    const std::string damaged = texture("b", "damaged.png"), more = texture("c", "t1.png"), end = "WorldEnd\n";
    const std::string mesh = "Shape \"plymesh\" \"string filename\" \"bad.ply\"\n";
    folder_.write("bad.ply", "ply\n");
    const auto error = [&](const std::string& world) {
        return errorOf([&] { loadPbrtString(begin + world + end, folder_.path(), {}, "s.pbrt"); });
    };
    for (const int threads : {1, 3}) {
        setThreadCount(threads);
        EXPECT_EQ(error(more), "");
        EXPECT_THAT(error(damaged + more), HasSubstr("s.pbrt:4:53"));
        EXPECT_THAT(error(damaged + more), HasSubstr("damaged.png"));
        // A fault of the syntax, or a damaged mesh, that comes later.
        EXPECT_THAT(error(damaged + more + "Nonsense\n"), HasSubstr("damaged.png"));
        EXPECT_THAT(error(damaged + mesh), HasSubstr("damaged.png"));
        EXPECT_THAT(error(mesh), HasSubstr("cannot load the mesh"));
        EXPECT_THAT(error("Nonsense\n" + damaged), HasSubstr("Nonsense"));
        EXPECT_THAT(error(damaged + texture("d", "absent.png")), HasSubstr("damaged.png"));
    }
}

}  // namespace
}  // namespace drc::pbrt
