// Renders that are killed, and go on from their checkpoints, as a user sees them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "image/image_io.h"
#include "room_with_window.h"

namespace drc {
namespace {

using testing::HasSubstr;

class CheckpointedRender : public FolderTest {
  protected:
    // With an environment that is guided, and a file that the scene names.
    CheckpointedRender() {
        folder_.write("room.pbrt",
                      test::respelt(test::roomWithWindow(), "WorldEnd", "Include \"ball.pbrt\"\nWorldEnd"));
        folder_.write(
            "ball.pbrt",
            "Material \"matte\" \"rgb Kd\" [.6 .5 .4]\nTranslate 0 0 1\nShape \"sphere\" \"float radius\" .3\n");
    }

    std::string scene_ = "room.pbrt";

    // Starts `drc render room.pbrt` with these options. What it says goes to said.txt.
    pid_t start(const std::vector<std::string>& options, rlim_t mostBytes = RLIM_INFINITY) const {
        std::vector<std::string> words{DRC_PROGRAM, "render", path(scene_), "--denoise", "off", "-o", path("out.exr")};
        if (std::ranges::find(options, "--resolution") == options.end())
            words.insert(words.end(), {"--resolution", "64x48"});
        words.insert(words.end(), options.begin(), options.end());
        std::vector<char*> arguments;
        for (std::string& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        const std::string said = path("said.txt");
        const pid_t child = fork();
        if (child == 0) {
            if (freopen(said.c_str(), "w", stderr) == nullptr) _exit(98);
            if (mostBytes != RLIM_INFINITY) {
                const rlimit limit{mostBytes, mostBytes};
                setrlimit(RLIMIT_FSIZE, &limit);
                ::signal(SIGXFSZ, SIG_IGN);
            }
            execv(DRC_PROGRAM, arguments.data());
            _exit(99);
        }
        return child;
    }
    // Waits, and returns the exit status, or minus the signal that ended it.
    static int wait(pid_t child) {
        int status = 0;
        waitpid(child, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }
    int run(const std::vector<std::string>& options) const { return wait(start(options)); }
    std::string said() const { return readFile(path("said.txt")); }
    std::vector<float> pixels() const { return readLinearRgb(path("out.exr")).data(); }
    // Runs until there is a checkpoint, and kills it a while later.
    void killAfterCheckpoint(std::vector<std::string> options, double seconds) const {
        options.insert(options.end(), {"--checkpoint", path("state"), "--every", "1s"});
        const auto before = std::filesystem::exists(path("state")) ? std::filesystem::last_write_time(path("state"))
                                                                   : std::filesystem::file_time_type::min();
        const pid_t child = start(options);
        for (int i = 0; i < 6000; ++i) {
            std::error_code ignored;
            if (std::filesystem::exists(path("state"), ignored) &&
                std::filesystem::last_write_time(path("state")) > before)
                break;
            ASSERT_EQ(waitpid(child, nullptr, WNOHANG), 0) << "it ended before its first checkpoint:\n" << said();
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
        kill(child, SIGKILL);
        EXPECT_EQ(wait(child), -SIGKILL);
    }
};

// Killed in the middle of passes, also while a checkpoint is written; with other numbers of threads each time.
TEST_F(CheckpointedRender, GoesOnToTheSameBitsAfterBeingKilled) {
    for (const char* integrator : {"drc", "path"}) {
        std::filesystem::remove(path("state"));
        // So many that the checkpoints of all runs that are killed are reached before the end.
        killAfterCheckpoint({"--integrator", integrator, "--spp", "100000"}, 0.1);
        std::mt19937 random(5);
        std::uniform_real_distribution<double> moment(0, 0.9);
        for (int i = 0; i < 3; ++i) {
            const std::string threads = std::to_string(1 + i);
            killAfterCheckpoint(
                {"--integrator", integrator, "--spp", "100000", "--nthreads", threads, "--resume", path("state")},
                moment(random));
        }
        // What the last checkpoint has, and some more.
        ASSERT_EQ(run({"--integrator", integrator, "--spp", "1", "--resume", path("state")}), 0) << said();
        const int reached = std::stoi(readExrMetadata(path("out.exr")).at("drc:spp"));
        EXPECT_GT(reached, 1);
        const std::string spp = std::to_string(reached + 3);
        ASSERT_EQ(run({"--integrator", integrator, "--spp", spp, "--resume", path("state")}), 0) << said();
        const std::vector<float> resumed = pixels();
        ASSERT_EQ(run({"--integrator", integrator, "--spp", spp}), 0);
        EXPECT_EQ(resumed, pixels()) << integrator << " " << spp;
    }
}

TEST_F(CheckpointedRender, IsSavedWhenItIsInterrupted) {
    for (const int signal : {SIGINT, SIGTERM}) {
        std::filesystem::remove(path("state"));
        // A picture of more samples would be kept.
        std::filesystem::remove(path("out.exr"));
        const pid_t child = start({"--spp", "100000", "--checkpoint", path("state"), "--every", "1h"});
        std::this_thread::sleep_for(std::chrono::seconds(2));
        kill(child, signal);
        EXPECT_EQ(wait(child), 128 + signal);
        EXPECT_EQ(readExrMetadata(path("out.exr")).at("drc:interrupted"), "true");
        const std::vector<float> then = pixels();
        const int samples = std::stoi(readExrMetadata(path("out.exr")).at("drc:spp"));
        ASSERT_EQ(run({"--spp", "1", "--resume", path("state")}), 0) << said();
        EXPECT_EQ(std::stoi(readExrMetadata(path("out.exr")).at("drc:spp")), samples);
        EXPECT_EQ(then, pixels());
    }
}

// Also one that was shorter than the time between checkpoints, and with the defaults alone.
TEST_F(CheckpointedRender, AFinishedOneTakesMoreSamples) {
    for (const char* integrator : {"drc", "path", "bdpt", "drc-maps"}) {
        const auto spp = [&](const char* samples) {
            std::vector<std::string> options{"--integrator", integrator, "--spp", samples};
            if (integrator == std::string("drc-maps"))
                options.insert(options.end(), {"--map-denoiser", "none", "--passes", "2", "--spacing", "8"});
            return options;
        };
        const auto with = [](std::vector<std::string> options, const std::vector<std::string>& more) {
            options.insert(options.end(), more.begin(), more.end());
            return options;
        };
        std::filesystem::remove(path("state"));
        ASSERT_EQ(run(with(spp("5"), {"--checkpoint", path("state")})), 0) << said();
        const std::vector<float> five = pixels();
        // As it is, then with more samples, which are saved in turn, and with more still.
        ASSERT_EQ(run(with(spp("5"), {"--resume", path("state")})), 0) << said();
        EXPECT_THAT(said(), HasSubstr("that is all that is asked for"));
        EXPECT_EQ(pixels(), five) << integrator;
        ASSERT_EQ(run(with(spp("7"), {"--resume", path("state"), "--checkpoint", path("state")})), 0) << said();
        ASSERT_EQ(run(with(spp("9"), {"--resume", path("state")})), 0) << said();
        EXPECT_EQ(readExrMetadata(path("out.exr")).at("drc:spp"), "9");
        const std::vector<float> nine = pixels();
        ASSERT_EQ(run(spp("9")), 0) << said();
        EXPECT_EQ(pixels(), nine) << integrator;
    }
}

// Within the time that was given, which includes saving.
TEST_F(CheckpointedRender, AFinishedOneTakesMoreTime) {
    ASSERT_EQ(run({"--time", "2", "--checkpoint", path("state")}), 0) << said();
    const int before = std::stoi(readExrMetadata(path("out.exr")).at("drc:spp"));
    ASSERT_EQ(run({"--time", "2", "--resume", path("state")}), 0) << said();
    EXPECT_GT(std::stoi(readExrMetadata(path("out.exr")).at("drc:spp")), before);
}

// One line that says what differs. Nothing is rendered.
TEST_F(CheckpointedRender, RefusesWhatItIsNotOf) {
    killAfterCheckpoint({"--spp", "100000"}, 0);
    const auto error = [&](const std::vector<std::string>& options) {
        std::vector<std::string> all = options;
        all.insert(all.end(), {"--resume", path("state"), "--spp", "1", "--quiet"});
        EXPECT_EQ(run(all), 1);
        const std::string text = said();
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
        return text;
    };
    EXPECT_THAT(error({"--integrator", "path"}), HasSubstr("it was made with another integrator: 'drc', here 'path'"));
    EXPECT_THAT(error({"--resolution", "32x24"}), HasSubstr("another film: '64 x 48 pixels', here '32 x 24 pixels'"));
    EXPECT_THAT(error({"--crop", "0", ".5", "0", "1"}), HasSubstr("another part of the film"));
    EXPECT_THAT(error({"--seed", "2"}), HasSubstr("another --seed: '0', here '2'"));
    EXPECT_THAT(error({"--max-depth", "3"}), HasSubstr("another --max-depth"));
    EXPECT_THAT(error({"--cell-size", ".3"}), HasSubstr("another --cell-size"));
    EXPECT_THAT(error({"--aovs"}),
                HasSubstr("another layers: nothing, here 'G-buffer parts variance of independent halves surfaces'"));
    EXPECT_THAT(error({"-D", "film.scale=2"}), HasSubstr("another -D film.scale: nothing, here 'film.scale=2'"));
    const std::string ball = readFile(path("ball.pbrt"));
    folder_.write("ball.pbrt", ball + "# a word more\n");
    EXPECT_THAT(error({}), HasSubstr("the scene's file 'ball.pbrt' has changed since"));
    folder_.write("ball.pbrt", ball);
    folder_.write("room.pbrt", readFile(path("room.pbrt")) + "\n");
    EXPECT_THAT(error({}), HasSubstr("the scene's file 'room.pbrt' has changed since"));
    // Files that are no checkpoints, or damaged ones.
    const std::string state = readFile(path("state"));
    folder_.write("state", "no checkpoint");
    EXPECT_THAT(error({}), HasSubstr("not a drc render"));
    folder_.write("state", state.substr(0, 40));
    EXPECT_THAT(error({}), HasSubstr("damaged"));
    std::filesystem::remove(path("state"));
    EXPECT_THAT(error({}), HasSubstr("state"));
}

// The scene may be elsewhere by now.
TEST_F(CheckpointedRender, GoesOnWhereTheSceneHasBeenMoved) {
    killAfterCheckpoint({"--spp", "100000"}, 0);
    std::filesystem::create_directory(path("moved"));
    for (const char* file : {"room.pbrt", "ball.pbrt"})
        std::filesystem::rename(path(file), path("moved/" + std::string(file)));
    scene_ = "moved/room.pbrt";
    EXPECT_EQ(run({"--spp", "1", "--resume", path("state")}), 0) << said();
}

// A disk that is full: the render goes on with a warning, and the last good checkpoint stays.
TEST_F(CheckpointedRender, KeepsTheLastCheckpointWhereThereIsNoRoomForAnother) {
    killAfterCheckpoint({"--spp", "100000"}, 0);
    const std::string good = readFile(path("state"));
    constexpr rlim_t kRoom = 1 << 20;  // enough for the picture
    ASSERT_GT(good.size(), 2 * kRoom);
    const pid_t child = start(
        {"--spp", "100000", "--time", "5", "--resume", path("state"), "--checkpoint", path("state"), "--every", "1s"},
        kRoom);
    EXPECT_EQ(wait(child), 0);
    EXPECT_THAT(said(), HasSubstr("the render goes on"));
    EXPECT_TRUE(readFile(path("state")) == good);
    EXPECT_TRUE(std::filesystem::exists(path("out.exr")));
    for (const auto& entry : std::filesystem::directory_iterator(path("."))) {
        const std::string name = entry.path().filename().string();
        EXPECT_TRUE(name == "state" || name == "out.exr" || name == "said.txt" || name.ends_with(".pbrt")) << name;
    }
}

TEST_F(CheckpointedRender, SaysWhatIsWrongWithItsOptions) {
    const auto error = [&](int code, const std::vector<std::string>& options) {
        EXPECT_EQ(run(options), code);
        return said();
    };
    EXPECT_THAT(error(1, {"--checkpoint", path("nowhere/state")}), HasSubstr("there is no folder"));
    EXPECT_THAT(error(64, {"--checkpoint", path("state"), "--every", "soon"}),
                HasSubstr("--every soon: must be a time"));
    EXPECT_THAT(error(64, {"--checkpoint", path("state"), "--every", "0"}),
                HasSubstr("must be a time of a second or more"));
}

}  // namespace
}  // namespace drc
