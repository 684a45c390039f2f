#include "base/log.h"

#include <gmock/gmock.h>

#include "base/warning_batch.h"

namespace drc {
namespace {

using testing::HasSubstr;

TEST(Log, WhatFilesSayCannotCommandATerminal) {
    forgetWarnings();  // identical warnings are printed once, so earlier tests must not have given these
    testing::internal::CaptureStderr();
    logError("file \"\x1b[2J\x07\" is\n\tdamaged\x7f");
    logWarning({"a\rb.pbrt", 1, 2}, "unknown \x1b[31m");
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_THAT(text, HasSubstr("drc: error: file \"?[2J?\" is\n\tdamaged?\n"));
    EXPECT_THAT(text, HasSubstr("a?b.pbrt:1:2: warning: unknown ?[31m\n"));
}

TEST(Log, MessagesOfMegabytesAreCut) {
    testing::internal::CaptureStderr();
    logError(std::string(1 << 20, 'x'));
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_LT(text.size(), 5000u);
    EXPECT_THAT(text, HasSubstr("xxx...\n"));
}

TEST(Log, WhatIsSaidOnceNamesTheFirstPlace) {
    forgetWarnings();
    testing::internal::CaptureStderr();
    for (int line = 1; line < 100; ++line) {
        logWarningOnce({"a.pbrt", line, 1}, "nothing is built");
        logWarningOnce({"a.pbrt", line, 1}, "nothing else is built");
    }
    EXPECT_EQ(warningCount(), 2);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "drc: a.pbrt:1:1: warning: nothing is built (said once)\n"
              "drc: a.pbrt:1:1: warning: nothing else is built (said once)\n");
}

TEST(Log, ABatchSaysEachMessageOnceWithTheNumberOfItsPlaces) {
    forgetWarnings();
    testing::internal::CaptureStderr();
    {
        const WarningBatch batch;
        for (int line = 1; line <= 130; ++line) {
            logWarningOnce({"a.pbrt", line, 1}, "is not built");
            logWarning({"a.pbrt", line, 2}, "is unknown");
        }
        logWarning({"a.pbrt", 130, 2}, "is unknown");
        logWarning({"a.pbrt", 7, 3}, "is alone");
        logWarning("has no place");
        logWarning("has no place");
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
        testing::internal::CaptureStderr();
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "drc: a.pbrt:1:1: warning: is not built (and 129 more)\n"
              "drc: a.pbrt:1:2: warning: is unknown (and 129 more)\n"
              "drc: a.pbrt:7:3: warning: is alone\n"
              "drc: warning: has no place\n");
    EXPECT_EQ(warningCount(), 133) << "each place of what may differ from place to place, and three";
}

TEST(Log, AThousandWarningsAreEnough) {
    forgetWarnings();
    testing::internal::CaptureStderr();
    for (int i = 0; i < 5000; ++i) logWarning("number " + std::to_string(i));
    logWarning("number 3");
    EXPECT_EQ(warningCount(), 5000) << "it was kept, and is known";
    logWarning("number 4999");
    EXPECT_EQ(warningCount(), 5001) << "it was not";
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1001);
    EXPECT_THAT(text, HasSubstr("number 999\ndrc: warning: there are more warnings than these; they are not shown\n"));
    forgetWarnings();
    EXPECT_EQ(warningCount(), 0);
}

}  // namespace
}  // namespace drc
