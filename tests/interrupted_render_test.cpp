// Renders that are interrupted, as a user sees them: exit status, and what is in the files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "app/laboratory.h"
#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "image/image_io.h"

namespace drc {
namespace {

constexpr const char* kRoom = R"(
LookAt 0 0 -3  0 0 0  0 1 0
Camera "perspective" "float fov" 60
WorldBegin
AttributeBegin
AreaLightSource "diffuse" "rgb L" [8 8 8]
Translate 0 1.6 0 Shape "sphere" "float radius" .4
AttributeEnd
Shape "sphere" "float radius" 1
ReverseOrientation
Shape "sphere" "float radius" 4
WorldEnd
)";

class InterruptedRender : public FolderTest {
  protected:
    InterruptedRender() { folder_.write("room.pbrt", kRoom); }

    // Whether the process catches the signal. Until then the signal ends it without a word, as it ends any program.
    static bool catches(pid_t process, int signal) {
        std::ifstream status("/proc/" + std::to_string(process) + "/status");
        const std::string key = "SigCgt:";
        for (std::string line; std::getline(status, line);)
            if (line.compare(0, key.size(), key) == 0)
                return std::stoull(line.substr(key.size()), nullptr, 16) >> (signal - 1) & 1;
        return false;
    }

    // Renders the room without an end, with a signal so many seconds after the program began to catch it, and
    // returns the exit status.
    int interrupted(int signal, double seconds, const std::string& integrator,
                    const std::vector<std::string>& options = {}) const {
        std::vector<std::string> words{DRC_PROGRAM,
                                       "render",
                                       path("room.pbrt"),
                                       "--integrator",
                                       integrator,
                                       "--spp",
                                       "1000000",
                                       "--resolution",
                                       "32x32",
                                       "--nthreads",
                                       "1",
                                       "--quiet",
                                       "-o",
                                       path("out.exr"),
                                       "-o",
                                       path("out.png")};
        words.insert(words.end(), options.begin(), options.end());
        return interrupted(signal, seconds, words);
    }
    static int interrupted(int signal, double seconds, const std::vector<std::string>& words) {
        const pid_t child = start(words);
        while (!catches(child, signal)) {
            if (waitpid(child, nullptr, WNOHANG) == child) {
                ADD_FAILURE() << "the program ended before it was interrupted";
                return -1;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
        kill(child, signal);
        return exitOf(child);
    }
    static pid_t start(std::vector<std::string> words) {
        std::vector<char*> arguments;
        for (std::string& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        const pid_t child = fork();
        if (child == 0) {
            execv(DRC_PROGRAM, arguments.data());
            _exit(99);
        }
        return child;
    }
    static int exitOf(pid_t child) {
        int status = 0;
        waitpid(child, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }
};

// With a million samples a texel the first map pass, without which there is no picture, takes hours.
TEST_F(InterruptedRender, BeforeThereIsAPictureNothingIsWritten) {
    folder_.write("out.png", "an older picture");
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        EXPECT_EQ(interrupted(signal, 0.5, "drc-maps", {"--map-denoiser", "oracle", "--oracle-spp", "1000000"}),
                  128 + signal);
        EXPECT_EQ(readFile(path("out.png")), "an older picture");
        EXPECT_FALSE(std::filesystem::exists(path("out.exr")));
    }
}

TEST_F(InterruptedRender, APictureIsSavedAndSaysThatItIsPartial) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        std::filesystem::remove(path("out.exr"));
        std::filesystem::remove(path("out.png"));
        EXPECT_EQ(interrupted(signal, 2, "path"), 128 + signal);
        const ExrMetadata metadata = readExrMetadata(path("out.exr"));
        EXPECT_EQ(metadata.at("drc:interrupted"), "true");
        EXPECT_GT(std::stoi(metadata.at("drc:spp")), 1);
        const Image picture = readLinearRgb(path("out.exr"));
        double sum = 0;
        for (const float v : picture.data()) sum += v;
        EXPECT_GT(sum, 0);
        EXPECT_TRUE(std::filesystem::exists(path("out.png")));
    }
}

// Of a render with fewer samples than the picture that is there.
TEST_F(InterruptedRender, ABetterPictureIsKept) {
    writeExr(path("out.exr"), Image(4, 4), {{"drc:spp", "1000000000"}});
    const std::string before = readFile(path("out.exr"));
    EXPECT_EQ(interrupted(SIGINT, 1.5, "path"), 128 + SIGINT);
    EXPECT_EQ(readFile(path("out.exr")), before);
    EXPECT_EQ(readExrMetadata(path("out.interrupted.exr")).at("drc:interrupted"), "true");
}

TEST_F(InterruptedRender, OtherLongCommandsEndInTheSameWay) {
    EXPECT_EQ(interrupted(SIGTERM, 2,
                          {DRC_PROGRAM, "reference", path("room.pbrt"), "--viewpoints", "1000000", "-o",
                           path("examples"), "--quiet"}),
              128 + SIGTERM);
}

TEST_F(InterruptedRender, ComparisonsEndInTheSameWay) {
    if (runLaboratory("check") != 0) GTEST_SKIP() << "Python lacks a module of the laboratory";
    EXPECT_EQ(interrupted(SIGINT, 2,
                          {DRC_PROGRAM, "bench", path("room.pbrt"), "--methods", "path", "--seconds", "60",
                           "--resolution", "32x32", "--reference-error", "1e-9", "-o", path("bench")}),
              128 + SIGINT);
}

// The time is up, and its picture is being denoised and written: it is as good as it would have been.
TEST_F(InterruptedRender, AnInterruptAfterTheLastSampleTakesNothing) {
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    std::filesystem::create_symlink("pipe", path("pipe.exr"));
    const pid_t child = start({DRC_PROGRAM, "render", path("room.pbrt"), "--spp", "2", "--resolution", "32x32",
                               "--denoise", "off", "-o", path("pipe.exr"), "-o", path("out.exr")});
    // Nobody reads from the pipe, so the render waits in the middle of its outputs.
    std::this_thread::sleep_for(std::chrono::seconds(3));
    kill(child, SIGINT);
    EXPECT_EQ(exitOf(child), 1);  // for the pipe's sake
    EXPECT_EQ(readExrMetadata(path("out.exr")).count("drc:interrupted"), 0u);
    EXPECT_TRUE(std::filesystem::exists(path("pipe.rescued.exr")));
}

}  // namespace
}  // namespace drc
