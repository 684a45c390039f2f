// Files of radiance cells (drc cells), as users and farms call them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "image/image_io.h"

namespace drc {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class CellsFile : public FolderTest {
  protected:
    void SetUp() override {
        for (const auto& [name, x] : {std::pair("a", 0.), std::pair("b", .3), std::pair("c", .6)})
            folder_.write(std::string(name) + ".pbrt", scene(x));
        folder_.write("rest.txt", path("b.pbrt") + "\tx.exr\n" + path("c.pbrt") + "\ty.exr\n");
    }
    // A lamp over a ball in a room, seen from x.
    static std::string scene(double x, const std::string& wall = ".5 .6 .7") {
        return "LookAt " + std::to_string(x) +
               " 0 -3  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 60\n"
               "Film \"image\" \"integer xresolution\" 48 \"integer yresolution\" 32\nWorldBegin\n"
               "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [8 8 8]\nTranslate 0 1.6 0\n"
               "Shape \"sphere\" \"float radius\" .4\nAttributeEnd\nMaterial \"matte\" \"rgb Kd\" [" +
               wall +
               "]\nShape \"sphere\" \"float radius\" 1\nReverseOrientation\nShape \"sphere\" \"float radius\" 4\n"
               "WorldEnd\n";
    }
    // Runs the program in the folder; returns what it said.
    std::string run(const std::string& arguments, int expected = 0) const {
        const std::string command = "cd " + path("") + " && " + DRC_PROGRAM + " " + arguments + " 2>&1";
        FILE* pipe = popen(command.c_str(), "r");
        std::string said;
        for (int c; (c = fgetc(pipe)) != EOF;) said += char(c);
        const int status = pclose(pipe);
        EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, expected) << command << "\n" << said;
        return said;
    }
    std::string train(const std::string& output, const std::string& options = "") const {
        return run("cells train a.pbrt --frames rest.txt --spp 24 --seed 1 " + options + " -o " + output);
    }
    std::vector<float> pixels(const std::string& name) const { return readLinearRgb(path(name)).data(); }
};

// With frozen cells a frame depends on the file, the seed and the samples, and on nothing that was rendered before.
TEST_F(CellsFile, FrozenFramesHaveTheSameBitsInAnyOrder) {
    train("shot.cells");
    const std::string render = " --denoise off --seed 5 --spp 4 --cells shot.cells --freeze-cells ";
    for (const std::string name : {"a", "b", "c"}) run("render " + name + ".pbrt" + render + "-o " + name + ".exr");
    folder_.write("forth.txt", path("b.pbrt") + "\tb1.exr\n" + path("c.pbrt") + "\tc1.exr\n");
    folder_.write("back.txt", path("b.pbrt") + "\tb2.exr\n" + path("a.pbrt") + "\ta2.exr\n");
    run("render a.pbrt" + render + "-o a1.exr --frames forth.txt --nthreads 1");
    run("render c.pbrt" + render + "-o c2.exr --frames back.txt --nthreads 3");
    for (const std::string name : {"a", "b", "c"})
        for (const std::string way : {"1", "2"}) EXPECT_EQ(pixels(name + ".exr"), pixels(name + way + ".exr")) << name;
    // Cells are asked, and those that go on learning give another picture.
    run("render a.pbrt --denoise off --seed 5 --spp 4 --cells shot.cells -o learning.exr");
    run("render a.pbrt --denoise off --seed 5 --spp 4 --cells off -o path.exr");
    EXPECT_NE(pixels("a.exr"), pixels("learning.exr"));
    EXPECT_NE(pixels("a.exr"), pixels("path.exr"));
}

TEST_F(CellsFile, FrozenCellsGiveThePathTracersMeans) {
    train("shot.cells", "--spp 256");
    run("render b.pbrt --denoise off --seed 5 --spp 256 --cells shot.cells --freeze-cells -o cells.exr");
    run("render b.pbrt --denoise off --seed 6 --spp 1024 --integrator path -o path.exr");
    const Image a = readLinearRgb(path("cells.exr")), b = readLinearRgb(path("path.exr"));
    // Blocks of 16 x 16 pixels.
    for (int y = 0; y < 32; y += 16)
        for (int x = 0; x < 48; x += 16) {
            double cells = 0, traced = 0;
            for (int i = 0; i < 256; ++i) {
                cells += double(luminance(a.rgb(x + i % 16, y + i / 16)));
                traced += double(luminance(b.rgb(x + i % 16, y + i / 16)));
            }
            EXPECT_NEAR(cells / traced, 1, 0.02) << x << " " << y;
        }
}

TEST_F(CellsFile, PartsAreMergedInAnyOrder) {
    for (const std::string part : {"1", "2", "3"}) train(part, "--part " + part + "/3");
    EXPECT_NE(readFile(path("1")), readFile(path("2")));
    run("cells merge 1 2 3 -o forth");
    run("cells merge 3 2 1 -o back");
    run("cells merge 2 3 -o some");
    run("cells merge some 1 -o twice");
    EXPECT_EQ(readFile(path("forth")), readFile(path("back")));
    EXPECT_EQ(readFile(path("forth")), readFile(path("twice")));
    EXPECT_THAT(run("cells info forth"), HasSubstr("nested sizes"));
    EXPECT_THAT(run("cells train a.pbrt --part 4/3 -o x", 64), HasSubstr("--part 4/3: must be as 2/5"));
    EXPECT_THAT(run("cells train a.pbrt --part 3000/4000 -o x", 64), HasSubstr("of which there are at most 1000"));
    train("other", "--cell-size 0.2");
    EXPECT_THAT(run("cells merge 1 other -o x", 1), HasSubstr("give all parts one --cell-size"));
    EXPECT_FALSE(std::filesystem::exists(path("x")));
}

TEST_F(CellsFile, OtherScenesAndDamagedFilesAreRefused) {
    train("shot.cells");
    folder_.write("red.pbrt", scene(0, ".9 .1 .1"));
    EXPECT_THAT(run("render red.pbrt --cells shot.cells -o x.exr", 1),
                HasSubstr("--cells shot.cells: it was made with another world (shapes, materials, lights, media)"));
    EXPECT_THAT(run("render a.pbrt --cells shot.cells --max-depth 3 -o x.exr", 1),
                HasSubstr("it was made with another --max-depth: '64', here '3'"));
    EXPECT_THAT(run("render a.pbrt --cells a.pbrt -o x.exr", 1), HasSubstr("a.pbrt: not a drc cells"));
    EXPECT_THAT(run("render a.pbrt --cells nowhere -o x.exr", 1), HasSubstr("nowhere"));
    EXPECT_THAT(run("render a.pbrt --freeze-cells -o x.exr", 64), HasSubstr("without --cells FILE"));
    EXPECT_THAT(run("render a.pbrt --cells shot.cells --cell-size 1 -o x.exr", 64), HasSubstr("--cell-size"));
    EXPECT_THAT(run("cells train a.pbrt --frames bad.txt -o x", 1), HasSubstr("bad.txt"));
    folder_.write("moved.txt", path("red.pbrt") + "\tx.exr\n");
    EXPECT_THAT(run("cells train a.pbrt --frames moved.txt -o x", 1), HasSubstr("its world is not that of a.pbrt"));
    const std::string whole = readFile(path("shot.cells"));
    folder_.write("cut.cells", whole.substr(0, whole.size() / 2));
    EXPECT_THAT(run("render a.pbrt --cells cut.cells -o x.exr", 1), HasSubstr("the file is damaged"));
    std::string flipped = whole;
    flipped[whole.size() / 2] ^= 1;
    folder_.write("flipped.cells", flipped);
    EXPECT_THAT(run("cells info flipped.cells", 1), HasSubstr("its checksum is wrong"));
    std::string later = whole;
    later[std::string("drc cells ").size()] = '9';
    folder_.write("later.cells", later);
    EXPECT_THAT(run("cells info later.cells", 1), HasSubstr("later.cells: it is of a later version of drc: format 9"));
    EXPECT_FALSE(std::filesystem::exists(path("x.exr")));
}

// A render that goes on learning from a file can be stopped and resumed.
TEST_F(CellsFile, ChangesOfTheFileAreNoticedByCheckpoints) {
    train("shot.cells");
    const std::string render = "render a.pbrt --denoise off --cells shot.cells -o a.exr --spp ";
    run(render + "4");
    const std::vector<float> whole = pixels("a.exr");
    run(render + "2 --checkpoint state");
    run(render + "4 --resume state");
    EXPECT_EQ(pixels("a.exr"), whole);
    train("shot.cells", "--part 2/2");
    EXPECT_THAT(run(render + "4 --resume state", 1), HasSubstr("it was made with another --cells file"));
}

}  // namespace
}  // namespace drc
