#include "render/checkpoint.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/folder_testing.h"

namespace drc {
namespace {

TEST(DurationOf, ReadsUnits) {
    EXPECT_EQ(durationOf("--every", "60").count(), 60);
    EXPECT_EQ(durationOf("--every", "90s").count(), 90);
    EXPECT_EQ(durationOf("--every", "1.5m").count(), 90);
    EXPECT_EQ(durationOf("--every", "2h").count(), 7200);
    for (const char* wrong : {"", "s", "-5", "5x", "5 s", "1.2.3", "0.5s", "1e3", "nan", "99999999999h"})
        EXPECT_THAT(errorOf([&] { durationOf("--every", wrong); }), testing::HasSubstr("must be a time")) << wrong;
}

}  // namespace
}  // namespace drc
