#include "base/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "base/parallel.h"

namespace drc {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

TEST(Progress, FormatsDurations) {
    EXPECT_EQ(formatDuration(0.4), "0s");
    EXPECT_EQ(formatDuration(59.4), "59s");
    EXPECT_EQ(formatDuration(725), "12m05s");
    EXPECT_EQ(formatDuration(11220), "3h07m");
    EXPECT_EQ(formatDuration(-1), "?");
}

TEST(Progress, CountsFromManyThreadsAndDrawsSeldom) {
    std::ostringstream out;
    {
        Progress progress("render", 100000, ProgressMode::Bar, &out);
        parallelFor(0, 100000, 10, [&](int b, int e) { progress.add(e - b); });
        EXPECT_EQ(progress.done(), 100000);
    }
    const std::string text = out.str();
    EXPECT_THAT(text, HasSubstr("render [==============================] 100%"));
    EXPECT_THAT(text, EndsWith("\n"));
    // 10000 updates take far less than 10 s, so at most a hundred may be drawn.
    EXPECT_LT(std::count(text.begin(), text.end(), '\r'), 100);
}

TEST(Progress, ShowsWhereAnInterruptedJobStopped) {
    std::ostringstream out;
    Progress progress("render", 4, ProgressMode::Bar, &out);
    progress.setNote("pass 3");
    progress.set(3);
    progress.set(2);  // must not go back
    progress.finish();
    progress.finish();
    EXPECT_THAT(out.str(), HasSubstr(" 75%"));
    EXPECT_THAT(out.str(), HasSubstr("pass 3"));
    EXPECT_THAT(out.str(), Not(HasSubstr("100%")));
}

TEST(Progress, PlainLinesWithoutATerminalAndNothingWhenQuiet) {
    std::ostringstream lines, quiet;
    {
        Progress a("load", 2, ProgressMode::Auto, &lines), b("load", 2, ProgressMode::Quiet, &quiet);
        for (Progress* p : {&a, &b}) p->add(2);
    }
    const std::string text = lines.str();
    EXPECT_THAT(text, Not(HasSubstr("\r")));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
    EXPECT_EQ(quiet.str(), "");
}

}  // namespace
}  // namespace drc
