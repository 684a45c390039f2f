#include "maps/example_shard.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "base/parallel.h"
#include "maps/example_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const MapLayout kLayout(Projection::LatLong, 4);
constexpr int kViewpoints = 6, kInputs = 2;

class ExampleShards : public FolderTest {
  protected:
    ExampleShards() {
        header_.scene = "room-0001";
        header_.layout = kLayout;
        header_.inputs = kInputs;
        header_.targetSamples = 64;
        header_.seed = ~uint64_t(0);
        header_.viewpoints = kViewpoints;
        header_.settings = 0xfedcba9876543210;
    }
    // The record of a viewpoint; viewpoint 2 gives no example.
    static std::string record(int viewpoint) {
        if (viewpoint == 2) return "";
        TrainingExample example = randomExample(kLayout, kInputs, unsigned(viewpoint));
        example.viewpoint = viewpoint;
        return encodeExample(example, kLayout);
    }
    // Writes the missing part of the shard, but no more than `most` viewpoints.
    void write(int most = kViewpoints) const {
        ExampleShardWriter writer(path_, header_);
        for (int i = 0; i < most && !writer.finished(); ++i) writer.append(record(writer.next()));
    }
    static std::vector<int> viewpoints(const ExampleShard& shard) {
        std::vector<int> result;
        TrainingExample example;
        for (int i = 0; i < shard.count(); ++i) {
            shard.load(i, 0, kInputs, example);
            result.push_back(example.viewpoint);
        }
        return result;
    }
    std::string openError() const {
        return errorOf([&] { ExampleShard{path_}; });
    }
    std::string writeError() const {
        return errorOf([&] { ExampleShardWriter{path_, header_}; });
    }
    static int lines(const std::string& text) { return int(std::count(text.begin(), text.end(), '\n')); }

    const std::string path_ = path("room-0001.examples");
    ShardHeader header_;
};

TEST_F(ExampleShards, KeepWhatIsWritten) {
    write();
    EXPECT_TRUE(isFinishedShard(path_));
    const ExampleShard shard(path_);
    EXPECT_TRUE(shard.finished());
    EXPECT_EQ(shard.damage(), "");
    EXPECT_EQ(shard.scene(), "room-0001");
    EXPECT_EQ(shard.layout().projection(), Projection::LatLong);
    EXPECT_EQ(shard.layout().size(), 4);
    EXPECT_EQ(shard.inputs(), kInputs);
    EXPECT_EQ(shard.header().seed, header_.seed);
    EXPECT_EQ(shard.header().settings, header_.settings);
    EXPECT_EQ(firstDifference(shard.header(), header_), "");
    EXPECT_EQ(viewpoints(shard), (std::vector{0, 1, 3, 4, 5}));
    TrainingExample example, expected = randomExample(kLayout, kInputs, 3);
    shard.load(2, 1, 1, example);
    ASSERT_EQ(example.inputs.size(), 1u);
    EXPECT_NEAR(example.inputs[0].radiance[7], expected.inputs[1].radiance[7], 1e-2f);
    EXPECT_THROW(shard.load(2, 1, 2, example), Error);
    const std::string hash = shard.contentHash();
    EXPECT_EQ(hash.size(), 16u);
    header_.seed = 1;
    std::filesystem::remove(path_);
    write();
    EXPECT_NE(ExampleShard(path_).contentHash(), hash);
}

TEST_F(ExampleShards, AreLoadedByManyThreads) {
    write();
    const ExampleShard shard(path_);
    std::vector<TrainingExample> expected(size_t(shard.count()));
    for (int i = 0; i < shard.count(); ++i) shard.load(i, 0, 1, expected[size_t(i)]);
    std::atomic<int> wrong{0};
    setThreadCount(4);
    parallelFor(0, 2000, 1, [&](int i, int) {
        TrainingExample example;
        const int which = i * 7 % shard.count();
        shard.load(which, 0, 1, example);
        if (example.target != expected[size_t(which)].target) ++wrong;
    });
    setThreadCount(0);
    EXPECT_EQ(wrong, 0);
}

// Wherever a writer was killed, what it had written can be read, and continuing gives exactly the same file.
TEST_F(ExampleShards, GoOnAfterAnInterruptionAtAnyByte) {
    write();
    const std::string whole = readFile(path_);
    size_t header = 0;
    parseShardHeader(whole, header);
    for (size_t size = 0; size < whole.size(); size += size < header + 100 ? 1 : 7) {
        SCOPED_TRACE(size);
        std::ofstream(path_, std::ios::binary) << whole.substr(0, size);
        EXPECT_FALSE(isFinishedShard(path_));
        if (size >= header) {
            const ExampleShard cut(path_);
            EXPECT_FALSE(cut.finished());
            EXPECT_THAT(cut.damage(), StartsWith(path_ + ": "));
            EXPECT_THAT(cut.damage(), HasSubstr(std::to_string(cut.count()) + " examples are usable"));
            EXPECT_EQ(lines(cut.damage()), 0);
        } else {
            EXPECT_THAT(openError(), StartsWith(path_));
        }
        write();
        ASSERT_TRUE(readFile(path_) == whole);
    }
}

TEST_F(ExampleShards, GoOnAfterGarbageAtTheEnd) {
    write();
    const std::string whole = readFile(path_);
    std::filesystem::remove(path_);
    write(4);
    std::ofstream(path_, std::ios::binary | std::ios::app) << std::string(5000, '\0');  // as a power failure may leave
    write();
    EXPECT_TRUE(readFile(path_) == whole);
}

TEST_F(ExampleShards, OfFinishedOnesNothingIsChanged) {
    write();
    const auto time = std::filesystem::last_write_time(path_);
    const ExampleShardWriter writer(path_, header_);
    EXPECT_TRUE(writer.finished());
    EXPECT_EQ(writer.next(), kViewpoints);
    EXPECT_EQ(std::filesystem::last_write_time(path_), time);
}

TEST_F(ExampleShards, WithOtherSettingsAreNotGoneOnWith) {
    const ShardHeader made = header_;
    for (const int done : {2, kViewpoints}) {
        std::filesystem::remove(path_);
        header_ = made;
        write(done);
        const std::string before = readFile(path_);
        const auto expectRefused = [&](const char* why) {
            EXPECT_THAT(writeError(), StartsWith(path_ + ": made with "));
            EXPECT_THAT(writeError(), HasSubstr(why));
            EXPECT_EQ(lines(writeError()), 0);
            header_ = made;
        };
        header_.targetSamples = 32;
        expectRefused("--spp 64, not 32");
        header_.seed = 2;
        expectRefused("--seed 18446744073709551615, not 2");
        header_.inputs = 7;
        expectRefused("--inputs 2, not 7");
        header_.tiles = 5;
        expectRefused("--tiles 0, not 5");
        header_.layout = MapLayout(Projection::EqualArea, 4);
        expectRefused("--projection latlong, not equal-area");
        header_.layout = MapLayout(Projection::LatLong, 8);
        expectRefused("--map-size 4, not 8");
        header_.scene = "other";
        expectRefused("the scene room-0001, not other");
        header_.settings = 1;
        expectRefused("another scene file");
        EXPECT_TRUE(readFile(path_) == before);
    }
}

TEST_F(ExampleShards, HaveOneWriter) {
    const ExampleShardWriter writer(path_, header_);
    EXPECT_THAT(writeError(), HasSubstr("another program is writing this file"));
}

TEST_F(ExampleShards, OfOtherKindsAreRefusedAndNotWrittenTo) {
    for (const std::string& other : {std::string("nonsense"), std::string(500, 'x')}) {
        std::ofstream(path_, std::ios::binary) << other;
        EXPECT_THAT(openError(), StartsWith(path_ + ": not a file of examples"));
        EXPECT_THAT(writeError(), StartsWith(path_ + ": not a file of examples"));
        EXPECT_EQ(readFile(path_), other);
    }
    std::filesystem::remove(path_);
    EXPECT_THAT(openError(), StartsWith(path_));
    write();
    std::string later = readFile(path_);
    later[8] = 3;
    std::ofstream(path_, std::ios::binary) << later;
    EXPECT_THAT(openError(), HasSubstr("examples of version 3"));
    later[8] = 2;
    later[40] = '\x01';
    std::ofstream(path_, std::ios::binary) << later;
    EXPECT_THAT(openError(), HasSubstr("header is damaged"));
}

// With one wrong byte anywhere after the header, at most one example is lost, and no wrong one is read.
TEST_F(ExampleShards, LoseNoMoreThanWhatIsDamaged) {
    write();
    const std::string whole = readFile(path_);
    size_t header = 0;
    parseShardHeader(whole, header);
    for (size_t at = header; at < whole.size(); at += at < header + 100 ? 1 : 7) {
        SCOPED_TRACE(at);
        std::string damaged = whole;
        damaged[at] = char(damaged[at] ^ 0x41);
        std::ofstream(path_, std::ios::binary) << damaged;
        const ExampleShard shard(path_);
        EXPECT_GE(shard.count(), kViewpoints - 2);
        EXPECT_THAT(shard.damage(), StartsWith(path_ + ": "));
        for (const int v : viewpoints(shard)) EXPECT_THAT(v, testing::AnyOf(0, 1, 3, 4, 5));
    }
}

TEST_F(ExampleShards, ThatClaimMuchTakeLittle) {
    header_.layout = MapLayout(Projection::EqualArea, 256);
    header_.inputs = 64;
    std::string bytes = shardHeaderBytes(header_);
    bytes += recordHeaderBytes(RecordKind::Example, 0, 0xffffffff) + "few bytes";
    for (uint32_t i = 0; i < 1000; ++i) bytes += recordHeaderBytes(RecordKind::Example, i, 4) + "more";
    std::ofstream(path_, std::ios::binary) << bytes;
    rusage before{}, after{};
    getrusage(RUSAGE_SELF, &before);
    const ExampleShard shard(path_);
    getrusage(RUSAGE_SELF, &after);
    EXPECT_EQ(shard.count(), 0);
    EXPECT_THAT(shard.damage(), HasSubstr("1001 damaged places"));
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 50'000);  // kB
    header_.inputs = 65;
    std::ofstream(path_, std::ios::binary) << shardHeaderBytes(header_);
    EXPECT_THAT(openError(), HasSubstr("'inputs' is not a whole number from 1 to 64"));
}

TEST_F(ExampleShards, CanBeGoneOnWithAfterAFullDisk) {
    write();
    const std::string whole = readFile(path_);
    for (const size_t most : {size_t(10), whole.size() / 2, whole.size() - 1}) {
        std::filesystem::remove(path_);
        {
            const FileSizeLimit limit(most);
            EXPECT_THAT(errorOf([&] { write(); }), StartsWith(path_ + ": cannot write: "));
        }
        write();
        EXPECT_TRUE(readFile(path_) == whole);
    }
}

}  // namespace
}  // namespace drc
