#include "image/exr_channels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace drc {
namespace {

using testing::ElementsAre;

std::vector<std::string> namesOf(const std::vector<ExrPartChannels>& parts) {
    std::vector<std::string> names;
    for (const ExrChannel& channel : exrChannels(parts).channels) names.push_back(channel.name);
    return names;
}

TEST(ExrChannels, OfOnePartKeepTheirNames) {
    EXPECT_THAT(namesOf({{"rgba", {"A", "B", "G", "N.X", "R"}}}), ElementsAre("R", "G", "B", "A", "N.X"));
    EXPECT_THAT(namesOf({{"depth", {"Z"}}}), ElementsAre("Z"));
}

TEST(ExrChannels, PartsAreLayersAndTheBeautyComesFirst) {
    EXPECT_THAT(namesOf({{"depth", {"Z"}}, {"rgba", {"A", "B", "G", "R"}}, {"N", {"X", "Y", "Z"}}}),
                ElementsAre("R", "G", "B", "A", "depth.Z", "N.X", "N.Y", "N.Z"));
    EXPECT_EQ(exrChannels({{"depth", {"Z"}}, {"rgba", {"B", "G", "R"}}}).beautyPart, 1u);
    EXPECT_THAT(namesOf({{"left", {"B", "G", "R"}}, {"right", {"B", "G", "R"}}}),
                ElementsAre("R", "G", "B", "right.R", "right.G", "right.B"));
    EXPECT_THAT(namesOf({{"grey", {"Y"}}, {"depth", {"Z"}}}), ElementsAre("Y", "depth.Z"));
    EXPECT_THAT(namesOf({{"a", {"Z"}}, {"b", {"Z"}}}), ElementsAre("a.Z", "b.Z"));
    EXPECT_EQ(exrChannels({{"a", {"Z"}}, {"b", {"Z"}}}).beautyPart, 2u);
}

TEST(ExrChannels, NamesOfPartsAreNotRepeated) {
    EXPECT_THAT(namesOf({{"rgba", {"B", "G", "R"}}, {"depth", {"depth.Z"}}}), ElementsAre("R", "G", "B", "depth.Z"));
    EXPECT_THAT(namesOf({{"rgba", {"B", "G", "R", "depth.Z"}}, {"depth", {"Z"}}}),
                ElementsAre("R", "G", "B", "depth.Z", "part2.depth.Z"));
    EXPECT_THAT(namesOf({{"", {"Z"}}, {"", {"Z"}}}), ElementsAre("part1.Z", "part2.Z"));
}

}  // namespace
}  // namespace drc
