#include "base/interrupt.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

namespace drc {
namespace {

// Each runs in a child process: a handler installed here must not outlive the test.
TEST(InterruptDeathTest, FirstInterruptRaisesTheToken) {
    EXPECT_EXIT(
        {
            installInterruptHandler();
            if (interruptToken().cancelled()) std::_Exit(1);
            std::raise(SIGINT);
            std::_Exit(interruptToken().cancelled() ? 0 : 2);
        },
        testing::ExitedWithCode(0), "interrupted");
}

TEST(InterruptDeathTest, SecondInterruptEndsTheProcess) {
    EXPECT_EXIT(
        {
            installInterruptHandler();
            std::raise(SIGINT);
            std::raise(SIGINT);
            std::_Exit(0);
        },
        testing::ExitedWithCode(130), "interrupted");
}

}  // namespace
}  // namespace drc
