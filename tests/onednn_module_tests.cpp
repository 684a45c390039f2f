// oneDNN inside a module of another program, with other libraries beside it: its work stays on the calling thread.
// Each test runs in a child process, as what is loaded stays loaded.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace {

void load(const char* path, int flags) {
    if (!dlopen(path, RTLD_NOW | flags)) std::_Exit(100);
}

int threadsAfterProduct(bool alone) {
    void* const module = dlopen(DRC_ONEDNN_MODULE, RTLD_NOW | RTLD_LOCAL);
    auto* const run = module ? reinterpret_cast<int (*)(bool)>(dlsym(module, "threadsAfterProduct")) : nullptr;
    return run ? run(alone) : 101;
}

class OneDnnModuleDeathTest : public testing::Test {
  protected:
    OneDnnModuleDeathTest() { setenv("OMP_NUM_THREADS", "4", 1); }  // read when the library is loaded
};

TEST_F(OneDnnModuleDeathTest, TakesAllThreadsIfItMay) {
    EXPECT_EXIT(std::_Exit(threadsAfterProduct(false)), testing::ExitedWithCode(4), "");
}

TEST_F(OneDnnModuleDeathTest, StaysOnItsThread) {
    EXPECT_EXIT(std::_Exit(threadsAfterProduct(true)), testing::ExitedWithCode(1), "");
}

TEST_F(OneDnnModuleDeathTest, StaysOnItsThreadBesideAnOpenMpThatCameLater) {
    EXPECT_EXIT(
        {
            load(DRC_ONEDNN_MODULE, RTLD_LOCAL);
            load(DRC_FOREIGN_OPENMP, RTLD_GLOBAL);
            std::_Exit(threadsAfterProduct(true));
        },
        testing::ExitedWithCode(1), "");
}

TEST_F(OneDnnModuleDeathTest, StaysOnItsThreadWithAnOpenMpThatCameFirst) {
    EXPECT_EXIT(
        {
            load(DRC_FOREIGN_OPENMP, RTLD_GLOBAL);
            std::_Exit(threadsAfterProduct(true));
        },
        testing::ExitedWithCode(1), "");
}

}  // namespace
