// Runs `drc reference` as a user would: examples of scenes, and continuation of interrupted runs.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <chrono>
#include <thread>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "maps/example_shard.h"

extern char** environ;

namespace drc {
namespace {

using testing::HasSubstr;

// A lamp in an open box, so that some camera rays escape.
constexpr const char* kScene = R"(
LookAt 0 -3 1  0 0 1  0 0 1
Camera "perspective" "float fov" 60
Film "image" "integer xresolution" 64 "integer yresolution" 64
WorldBegin
AttributeBegin
  AreaLightSource "diffuse" "rgb L" [3 3 3]
  Translate 0 0 1.5
  Shape "sphere" "float radius" 0.1
AttributeEnd
Material "matte" "rgb Kd" [0.7 0.6 0.5]
Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point P" [-1 -1 0  1 -1 0  1 1 0  -1 1 0]
Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point P" [-1 1 0  1 1 0  1 1 2  -1 1 2]
WorldEnd
)";

class Reference : public FolderTest {
  protected:
    Reference() { folder_.write("room/scene.pbrt", kScene); }

    pid_t start(const std::vector<std::string>& arguments, const std::string& subcommand = "reference") const {
        std::vector<std::string> words{DRC_PROGRAM, subcommand};
        words.insert(words.end(), arguments.begin(), arguments.end());
        std::vector<char*> argv;
        for (std::string& word : words) argv.push_back(word.data());
        argv.push_back(nullptr);
        posix_spawn_file_actions_t files;
        posix_spawn_file_actions_init(&files);
        posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_addopen(&files, STDERR_FILENO, path("log").c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                         0666);
        pid_t child = 0;
        EXPECT_EQ(posix_spawn(&child, DRC_PROGRAM, &files, nullptr, argv.data(), environ), 0);
        posix_spawn_file_actions_destroy(&files);
        return child;
    }
    // The exit code; -1 if the process was killed.
    static int wait(pid_t child) {
        int status = 0;
        waitpid(child, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    int run(const std::vector<std::string>& arguments) const { return wait(start(arguments)); }
    std::string log() const { return readFile(path("log")); }
    std::vector<std::string> command(const std::string& folder, const std::string& threads = "1") const {
        return {path("room/scene.pbrt"),
                "--tiles",
                "8",
                "--spp",
                "16",
                "--inputs",
                "2",
                "--map-size",
                "8",
                "--nthreads",
                threads,
                "-o",
                path(folder)};
    }
    static size_t size(const std::string& file) {
        std::error_code missing;
        const auto bytes = std::filesystem::file_size(file, missing);
        return missing ? 0 : bytes;
    }
    std::string shard(const std::string& folder) const { return path(folder + "/room.examples"); }
};

TEST_F(Reference, WritesAnExampleForEachTileThatHasOne) {
    ASSERT_EQ(run(command("out")), 0) << log();
    const ExampleShard examples(shard("out"));
    EXPECT_TRUE(examples.finished());
    EXPECT_EQ(examples.damage(), "");
    EXPECT_EQ(examples.scene(), "room");
    EXPECT_EQ(examples.inputs(), 2);
    EXPECT_GT(examples.count(), 20);
    EXPECT_LT(examples.count(), 64);  // above the wall, rays escape
    EXPECT_THAT(log(), HasSubstr(std::to_string(examples.count()) + " examples"));
    EXPECT_THAT(log(), HasSubstr(" an hour"));
    EXPECT_THAT(log(), HasSubstr(std::to_string(64 - examples.count()) + " viewpoints without one"));
    TrainingExample example;
    for (int i = 0; i < examples.count(); ++i) {
        examples.load(i, 0, 2, example);
        EXPECT_EQ(int(example.film.x / 8), example.viewpoint % 8);
        EXPECT_EQ(int(example.film.y / 8), example.viewpoint / 8);
        EXPECT_NE(example.inputs[0].radiance, example.inputs[1].radiance);
        const Vec3 p = example.inputs[0].origin;
        EXPECT_TRUE(std::abs(p.z) < 1e-3f || std::abs(p.y - 1) < 1e-3f || length(p - Vec3(0, 0, 1.5f)) < 0.11f);
    }
}

TEST_F(Reference, DoesNotDependOnThreads) {
    ASSERT_EQ(run(command("one", "1")), 0) << log();
    ASSERT_EQ(run(command("four", "4")), 0) << log();
    EXPECT_TRUE(readFile(shard("one")) == readFile(shard("four")));
}

TEST_F(Reference, GoesOnAsIfItHadNotBeenKilled) {
    ASSERT_EQ(run(command("whole")), 0) << log();
    const std::string whole = readFile(shard("whole"));
    int interrupted = 0;
    for (const int signal : {SIGKILL, SIGINT, SIGKILL, SIGKILL}) {
        const size_t before = size(shard("cut"));
        const pid_t child = start(command("cut", "2"));
        const auto most = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (std::chrono::steady_clock::now() < most && size(shard("cut")) < before + 4000 &&
               !isFinishedShard(shard("cut")))
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        kill(child, signal);
        interrupted += wait(child) != 0;
    }
    EXPECT_GE(interrupted, 2);
    ASSERT_EQ(run(command("cut")), 0) << log();
    EXPECT_TRUE(readFile(shard("cut")) == whole);
    // A complete shard must not be touched.
    const auto time = std::filesystem::last_write_time(shard("cut"));
    ASSERT_EQ(run(command("cut")), 0);
    EXPECT_EQ(std::filesystem::last_write_time(shard("cut")), time);
}

TEST_F(Reference, RefusesToGoOnWithAnotherScene) {
    ASSERT_EQ(run(command("out")), 0) << log();
    folder_.write("room/scene.pbrt", std::string(kScene) + "# changed\n");
    EXPECT_EQ(run(command("out")), 1);
    EXPECT_THAT(log(), HasSubstr(shard("out") + ": made with another scene file"));
}

TEST_F(Reference, GoesOnWithTheOtherScenesWhenOneIsBad) {
    folder_.write("bad/scene.pbrt", "WorldBegin Shape \"nonsense\" }");
    std::vector<std::string> arguments = command("out");
    arguments.insert(arguments.begin(), {path("missing.pbrt"), path("bad/scene.pbrt")});
    EXPECT_EQ(run(arguments), 1);
    EXPECT_THAT(log(), HasSubstr("missing.pbrt"));
    EXPECT_THAT(log(), HasSubstr("bad/scene.pbrt"));
    EXPECT_THAT(log(), HasSubstr("2 of 3 scenes failed"));
    EXPECT_TRUE(isFinishedShard(shard("out")));
    EXPECT_FALSE(std::filesystem::exists(path("out/bad.examples")));
}

TEST_F(Reference, TakesTilesOrANumber) {
    std::vector<std::string> arguments = command("out");
    arguments.insert(arguments.end(), {"--viewpoints", "9"});
    EXPECT_NE(run(arguments), 0);
    arguments.erase(arguments.begin() + 1, arguments.begin() + 3);
    EXPECT_EQ(run(arguments), 0) << log();
    EXPECT_EQ(ExampleShard(shard("out")).header().viewpoints, 9);
}

TEST_F(Reference, WritesTheAuthorsLayout) {
    const std::vector<std::string> common{path("room/scene.pbrt"), "--tiles", "4", "--spp", "16", "--nthreads", "2"};
    std::vector<std::string> pfm = common, shards = common;
    pfm.insert(pfm.end(), {"--layout", "iispt", "-o", path("pfm")});
    shards.insert(shards.end(), {"--projection", "latlong", "--inputs", "1", "-o", path("out")});
    ASSERT_EQ(run(pfm), 0) << log();
    ASSERT_EQ(run(shards), 0) << log();
    EXPECT_EQ(findExamples({path("pfm")}), std::vector<std::string>{path("pfm/room")});
    const auto a = openExamples(path("pfm/room")), b = openExamples(shard("out"));
    EXPECT_EQ(a->damage(), "");
    EXPECT_EQ(a->scene(), "room");
    ASSERT_EQ(a->count(), b->count());
    // Both contain the same maps; the shard sorts them by viewpoint, the folder by pixel.
    TrainingExample x, y;
    for (int i = 0; i < a->count(); ++i) {
        a->load(i, 0, 1, x);
        int same = 0;
        for (int j = 0; j < b->count(); ++j) {
            b->load(j, 0, 1, y);
            if (std::floor(y.film.x) + 0.5f != x.film.x || std::floor(y.film.y) + 0.5f != x.film.y) continue;
            ++same;
            for (size_t t = 0; t < 3 * 1024; ++t) {
                EXPECT_NEAR(x.inputs[0].radiance[t], y.inputs[0].radiance[t], 1e-3f * x.inputs[0].radiance[t]);
                EXPECT_NEAR(x.inputs[0].normal[t], y.inputs[0].normal[t], 1e-4f);
                EXPECT_NEAR(x.inputs[0].distance[t / 3], y.inputs[0].distance[t / 3], 1e-2f);
                EXPECT_NEAR(x.target[t], y.target[t], 1e-3f * x.target[t]);
            }
        }
        EXPECT_EQ(same, 1);
    }
    EXPECT_EQ(wait(start({path("pfm"), path("out")}, "evaluate")), 0) << log();
    // Missing files are written again.
    const std::string hash = a->contentHash();
    for (const auto& entry : std::filesystem::directory_iterator(path("pfm/room")))
        if (entry.path().filename().string().starts_with("p_1")) std::filesystem::remove(entry.path());
    ASSERT_EQ(run(pfm), 0) << log();
    EXPECT_EQ(openExamples(path("pfm/room"))->contentHash(), hash);
    pfm[4] = "8";
    EXPECT_EQ(run(pfm), 1);
    EXPECT_THAT(log(), HasSubstr("made with --spp 16, not 8"));
    pfm.insert(pfm.end(), {"--inputs", "2"});
    EXPECT_EQ(run(pfm), 64);
    EXPECT_THAT(log(), HasSubstr("leave out --inputs"));
}

}  // namespace
}  // namespace drc
