#include "bench/measured_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "base/error.h"

namespace drc {
namespace {

ProcessUse shell(const std::string& script, std::optional<double> limit = {}, const CancelToken* cancel = nullptr) {
    return runMeasured({"sh", "-c", script}, limit, cancel);
}

TEST(MeasuredProcess, GivesTheExitCodeAndWhatWasWritten) {
    const ProcessUse use = shell("echo out; echo err >&2; exit 7");
    EXPECT_EQ(use.exitCode, 7);
    EXPECT_THAT(use.output, testing::HasSubstr("out\n"));
    EXPECT_THAT(use.output, testing::HasSubstr("err\n"));
    EXPECT_FALSE(use.stopped);
}

TEST(MeasuredProcess, ArgumentsArriveAsTheyAre) {
    EXPECT_EQ(runMeasured({"printf", "%s|", "a b", "$HOME", ""}).output, "a b|$HOME||");
}

TEST(MeasuredProcess, SleepTakesWallClockAndNoProcessor) {
    const ProcessUse use = shell("sleep 0.3");
    EXPECT_GE(use.seconds, 0.3);
    EXPECT_LT(use.cpuSeconds, 0.2);
}

TEST(MeasuredProcess, WorkOfChildrenCounts) {
    const ProcessUse use = shell("sh -c 'i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done'; true");
    EXPECT_GT(use.cpuSeconds, 0.02);
    EXPECT_LT(use.cpuSeconds, use.seconds + 0.05);  // one thread
}

TEST(MeasuredProcess, PeakMemoryIsThatOfTheProgram) {
    { std::vector<char>(300'000'000, 1); }  // a peak of our own before does not count
    // dd's block is its memory, and is written to.
    const double small = shell("dd if=/dev/zero of=/dev/null bs=1k count=1 2>&1").peakMegabytes;
    const double large = shell("dd if=/dev/zero of=/dev/null bs=100M count=1 2>&1").peakMegabytes;
    EXPECT_LT(small, 60);
    EXPECT_GT(large, 104.8);
    EXPECT_LT(large, 115);
}

TEST(MeasuredProcess, LimitEndsWholeGroups) {
    const ProcessUse use = shell("sleep 60 & sleep 60; true", 0.2);
    EXPECT_TRUE(use.stopped);
    EXPECT_LT(use.seconds, 30);
    EXPECT_NE(use.exitCode, 0);
}

TEST(MeasuredProcess, WhatIgnoresTheRequestIsKilled) {
    const ProcessUse use = shell("trap '' TERM; while :; do sleep 0.05; done", 0.1);
    EXPECT_EQ(use.exitCode, 128 + 9);
}

TEST(MeasuredProcess, CanBeCancelled) {
    CancelToken cancel;
    std::thread other([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        cancel.cancel();
    });
    const ProcessUse use = shell("sleep 60", {}, &cancel);
    other.join();
    EXPECT_TRUE(use.stopped);
    EXPECT_LT(use.seconds, 30);
}

TEST(MeasuredProcess, LongOutputKeepsItsEnd) {
    const ProcessUse use = shell("i=0; while [ $i -lt 30000 ]; do echo line $i; i=$((i+1)); done");
    EXPECT_LE(use.output.size(), 1u << 16);
    EXPECT_EQ(lastLine(use.output), "line 29999");
}

TEST(MeasuredProcess, BackgroundChildrenThatKeepTheOutputOpenAreNotWaitedFor) {
    EXPECT_LT(shell("sleep 60 & echo started").seconds, 30);
}

TEST(MeasuredProcess, UnknownProgramsAreAnError) {
    try {
        runMeasured({"drc-no-such-program"});
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("drc-no-such-program"));
    }
    EXPECT_THROW(runMeasured({}), Error);
}

TEST(LastLine, OfBlankEndsAndCarriageReturns) {
    EXPECT_EQ(lastLine(""), "");
    EXPECT_EQ(lastLine(" \n \n"), "");
    EXPECT_EQ(lastLine("one"), "one");
    EXPECT_EQ(lastLine("one\n  two \n\n"), "two");
    EXPECT_EQ(lastLine("10%\r20%\r99% \n"), "99%");
}

TEST(LastLine, IsTheMessageWhereTextWithACaretFollows) {
    EXPECT_EQ(lastLine("loading\nroom.pbrt:1:1: no such shape\n    Shape \"cube\"\n          ^\n"),
              "room.pbrt:1:1: no such shape");
    EXPECT_EQ(lastLine("one\n^\n"), "^");
    EXPECT_EQ(lastLine("^"), "^");
}

}  // namespace
}  // namespace drc
