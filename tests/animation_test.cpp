// Animations (--frames), as a program on the other side of a pipe sees them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "image/image_io.h"

namespace drc {
namespace {

class Animation : public FolderTest {
  protected:
    // A lamp in a room, seen from x.
    static std::string scene(double x, const std::string& wall = ".5 .6 .7") {
        return "LookAt " + std::to_string(x) +
               " 0 -3  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 60\n"
               "Film \"image\" \"integer xresolution\" 24 \"integer yresolution\" 16\nWorldBegin\n"
               "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [8 8 8]\nTranslate 0 1.6 0\n"
               "Shape \"sphere\" \"float radius\" .4\nAttributeEnd\nMaterial \"matte\" \"rgb Kd\" [" +
               wall +
               "]\nShape \"sphere\" \"float radius\" 1\nReverseOrientation\nShape \"sphere\" \"float radius\" 4\n"
               "WorldEnd\n";
    }

    // Renders the frames' scenes with these words before them; returns what was said on both outputs, and the status.
    std::string rendered(const std::string& scene, const std::string& output, const std::string& frames,
                         const std::string& options, int& status) const {
        folder_.write("frames.txt", frames);
        const std::string command = "echo $$ > " + path("pid") + "; exec " + DRC_PROGRAM +
                                    " render -v --seed 3 --denoise off --nthreads 1 " + options + " " + path(scene) +
                                    " -o " + path(output) + " --frames - < " + path("frames.txt") + " 2>&1";
        FILE* pipe = popen(command.c_str(), "r");
        std::string said;
        std::array<char, 4096> buffer;
        while (const size_t n = fread(buffer.data(), 1, buffer.size(), pipe)) said.append(buffer.data(), n);
        const int result = pclose(pipe);
        status = WIFEXITED(result) ? WEXITSTATUS(result) : -1;
        return said;
    }
    std::string frame(const std::string& scene, const std::string& output) const {
        return path(scene) + "\t" + path(output) + "\n";
    }
    std::vector<float> pixels(const std::string& name) const { return readLinearRgb(path(name)).data(); }
};

// With the path tracer, which learns nothing, each frame is what it is alone, whatever has been kept.
TEST_F(Animation, FramesAreTheScenesPictures) {
    folder_.write("a.pbrt", scene(0));
    folder_.write("b.pbrt", scene(.5));
    folder_.write("c.pbrt", scene(.5, ".9 .1 .1"));
    int status = 0;
    const std::string said =
        rendered("a.pbrt", "a.exr", frame("b.pbrt", "b.exr") + frame("c.pbrt", "c.exr") + frame("a.pbrt", "a2.exr"),
                 "--integrator path --spp 4", status);
    EXPECT_EQ(status, 0) << said;
    EXPECT_EQ(pixels("a.exr"), pixels("a2.exr"));
    EXPECT_NE(pixels("a.exr"), pixels("b.exr"));
    EXPECT_NE(pixels("b.exr"), pixels("c.exr"));
    // A line for each picture, in order.
    for (const char* name : {"a.exr", "b.exr", "c.exr", "a2.exr"})
        EXPECT_THAT(said, testing::HasSubstr("\n" + path(name) + "\n"));
    // The camera alone differs once: the others have another wall.
    EXPECT_EQ(said.find("keeps the scene"), said.rfind("keeps the scene")) << said;
    EXPECT_NE(said.find("keeps the scene"), std::string::npos) << said;
    int alone = 0;
    rendered("b.pbrt", "alone.exr", "", "--integrator path --spp 4", alone);
    EXPECT_EQ(pixels("alone.exr"), pixels("b.exr"));
}

// What the radiance cells have learnt is kept: the second frame's differ from what it finds out by itself.
TEST_F(Animation, RadianceCellsAreKeptWhereOnlyTheCameraMoves) {
    folder_.write("a.pbrt", scene(0));
    folder_.write("b.pbrt", scene(.5));
    int status = 0;
    rendered("a.pbrt", "a.exr", frame("b.pbrt", "b.exr"), "--spp 8", status);
    EXPECT_EQ(status, 0);
    rendered("b.pbrt", "alone.exr", "", "--spp 8", status);
    EXPECT_NE(pixels("b.exr"), pixels("alone.exr"));
}

TEST_F(Animation, AFrameThatCannotBeRenderedEndsIt) {
    folder_.write("a.pbrt", scene(0));
    int status = 0;
    const std::string said =
        rendered("a.pbrt", "a.exr", frame("none.pbrt", "b.exr"), "--integrator path --spp 1", status);
    EXPECT_EQ(status, 1);
    EXPECT_THAT(said, testing::HasSubstr("none.pbrt"));
    EXPECT_TRUE(std::filesystem::exists(path("a.exr")));
    EXPECT_FALSE(std::filesystem::exists(path("b.exr")));
}

// An animation that is stopped within a frame, or killed between two, goes on there, to the same bits: cells that
// frames have left to each other included.
TEST_F(Animation, GoesOnFromACheckpoint) {
    folder_.write("a.pbrt", scene(0));
    folder_.write("b.pbrt", scene(.3));
    folder_.write("c.pbrt", scene(.6));
    folder_.write("d.pbrt", scene(.6, ".9 .1 .1"));
    const std::string options = "--resolution 48x32 --spp 60 ";
    const auto render = [&](const std::string& folder, const std::string& more, int& status) {
        std::string frames;
        for (const char* name : {"b", "c", "d"}) frames += frame(name + std::string(".pbrt"), folder + name + ".exr");
        return rendered("a.pbrt", folder + "a.exr", frames, options + more, status);
    };
    int status = 0;
    for (const char* folder : {"whole", "parts"}) std::filesystem::create_directory(path(folder));
    const std::string whole = render("whole/", "", status);
    ASSERT_EQ(status, 0) << whole;
    for (const int signal : {SIGINT, SIGKILL}) {
        const std::string checkpoint = "--checkpoint " + path("state") + " ";
        for (const char* name : {"a", "b", "c", "d"})
            std::filesystem::remove(path("parts/" + std::string(name) + ".exr"));
        std::thread stopping([&] {
            for (int i = 0; i < 30000 && !std::filesystem::exists(path("parts/a.exr")); ++i)
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
            std::this_thread::sleep_for(std::chrono::milliseconds(signal == SIGINT ? 100 : 0));
            kill(pid_t(std::stoi(readFile(path("pid")))), signal);
        });
        const std::string said = render("parts/", checkpoint, status);
        stopping.join();
        ASSERT_FALSE(std::filesystem::exists(path("parts/d.exr"))) << "it was stopped too late";
        EXPECT_EQ(status, signal == SIGINT ? 130 : -1) << said;
        const std::string rest = render("parts/", checkpoint + "--resume " + path("state"), status);
        ASSERT_EQ(status, 0) << rest;
        for (const char* name : {"a", "b", "c", "d"}) {
            const std::string file = std::string(name) + ".exr";
            EXPECT_EQ(pixels("parts/" + file), pixels("whole/" + file)) << signal << " " << file << "\n" << rest;
            EXPECT_THAT(rest, testing::HasSubstr("\n" + path("parts/" + file) + "\n"));
        }
    }
}

// With --temporal, frames are averaged with their neighbours: all are written, in their order, with less noise.
TEST_F(Animation, TemporalFramesAreWrittenLate) {
    std::string frames;
    for (const int i : {0, 1, 2, 3}) folder_.write(fmt::format("f{}.pbrt", i), scene(.05 * i));
    for (const int i : {1, 2, 3}) frames += frame(fmt::format("f{}.pbrt", i), fmt::format("t{}.exr", i));
    int status = 0;
    const std::string options = "--resolution 96x64 --integrator path --spp 16 ";
    const std::string said = rendered("f0.pbrt", "t0.exr", frames, options + "--temporal", status);
    ASSERT_EQ(status, 0) << said;
    size_t at = 0;
    for (const int i : {0, 1, 2, 3}) {
        const size_t found = said.find("\n" + path(fmt::format("t{}.exr", i)) + "\n", at);
        ASSERT_NE(found, std::string::npos) << said;
        at = found;
    }
    EXPECT_LT(said.find("/t0.exr\n"), said.find("f3.pbrt keeps the scene"));
    rendered("f0.pbrt", "s0.exr", frame("f1.pbrt", "s1.exr"), options, status);
    rendered("f1.pbrt", "long.exr", frame("f2.pbrt", "s2.exr"), "--resolution 96x64 --integrator path --spp 128",
             status);
    const std::vector<float> expected = pixels("long.exr");
    const auto error = [&](const std::string& name) {
        const std::vector<float> found = pixels(name);
        double sum = 0;
        for (size_t i = 0; i < found.size(); ++i)
            sum += std::pow(double(found[i] - expected[i]), 2) / (std::pow(double(expected[i]), 2) + .01);
        return sum;
    };
    EXPECT_LT(error("t1.exr"), .5 * error("s1.exr"));
}

// Frames that wait for their neighbours are not lost where a later one cannot be rendered.
TEST_F(Animation, TemporalFramesSurviveAFault) {
    for (const char* name : {"a", "b"}) folder_.write(std::string(name) + ".pbrt", scene(0));
    folder_.write("bad.pbrt", "Camera \"none\"");
    std::string large = scene(0);
    large.replace(large.find("24"), 2, "26");  // pixels wide
    folder_.write("large.pbrt", large);
    for (const std::string last : {"bad", "large"}) {
        int status = 0;
        const std::string said = rendered("a.pbrt", "a.exr", frame("b.pbrt", "b.exr") + frame(last + ".pbrt", "c.exr"),
                                          "--integrator path --spp 1 --temporal", status);
        EXPECT_EQ(status, 1) << said;
        EXPECT_THAT(said, testing::HasSubstr(last + ".pbrt"));
        for (const char* name : {"a.exr", "b.exr"}) EXPECT_TRUE(std::filesystem::remove(path(name))) << name << said;
        EXPECT_FALSE(std::filesystem::exists(path("c.exr")));
    }
}

}  // namespace
}  // namespace drc
