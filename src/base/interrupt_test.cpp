#include "base/interrupt.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

namespace drc {
namespace {

// Each runs in a child process: a handler installed here must not outlive the test.

struct SignalCase {
    int signal;
    const char* name;
    const char* message;
};
class InterruptDeathTest : public testing::TestWithParam<SignalCase> {};

TEST_P(InterruptDeathTest, FirstSignalRaisesTheTokenAndIsKnown) {
    EXPECT_EXIT(
        {
            installInterruptHandler();
            if (interruptToken().cancelled() || interruptSignal() != 0) std::_Exit(1);
            std::raise(GetParam().signal);
            std::_Exit(interruptToken().cancelled() && interruptSignal() == GetParam().signal ? 0 : 2);
        },
        testing::ExitedWithCode(0), GetParam().message);
}

TEST_P(InterruptDeathTest, IgnoredSignalsStayIgnored) {
    EXPECT_EXIT(
        {
            std::signal(GetParam().signal, SIG_IGN);  // as nohup does before it starts the program
            installInterruptHandler();
            std::raise(GetParam().signal);
            std::_Exit(interruptToken().cancelled() ? 1 : 0);
        },
        testing::ExitedWithCode(0), "");
}

TEST_P(InterruptDeathTest, SecondInterruptEndsTheProcess) {
    EXPECT_EXIT(
        {
            installInterruptHandler();
            std::raise(GetParam().signal);
            std::raise(SIGINT);
            std::_Exit(0);
        },
        testing::ExitedWithCode(130), GetParam().message);
}

TEST_P(InterruptDeathTest, RequestsThatComeTwiceCountOnce) {
    EXPECT_EXIT(
        {
            installInterruptHandler();
            std::raise(GetParam().signal);
            std::raise(SIGTERM);
            std::raise(SIGHUP);
            std::_Exit(interruptSignal() == GetParam().signal ? 0 : 1);
        },
        testing::ExitedWithCode(0), GetParam().message);
}

TEST_P(InterruptDeathTest, WithNothingToSaveTheFirstSignalEndsTheProcess) {
    EXPECT_EXIT(
        {
            installInterruptHandler();
            setSomethingToSave(false);
            std::raise(GetParam().signal);
            std::_Exit(0);
        },
        testing::ExitedWithCode(128 + GetParam().signal), "before there was a picture");
}

INSTANTIATE_TEST_SUITE_P(, InterruptDeathTest,
                         testing::Values(SignalCase{SIGINT, "Int", "interrupted"},
                                         SignalCase{SIGTERM, "Term", "asked to end"},
                                         SignalCase{SIGHUP, "Hup", "asked to end"}),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace drc
