// A shared object that uses oneDNN, as a Python module does: the test loads it without telling others of its symbols.
#include <dirent.h>

#include <memory>
#include <vector>

#include "neural/onednn_thread.h"

namespace {

int threadsOfThisProcess() {
    int count = 0;
    DIR* const tasks = opendir("/proc/self/task");
    while (const dirent* entry = readdir(tasks)) count += entry->d_name[0] != '.';
    closedir(tasks);
    return count;
}

}  // namespace

// How many threads there are after a product of matrices that is worth many, alone or not. Those of a team stay.
extern "C" int threadsAfterProduct(bool alone) {
    const std::unique_ptr<drc::SingleThreadScope> scope(alone ? new drc::SingleThreadScope : nullptr);
    constexpr int kSize = 512;
    const std::vector<float> a(kSize * kSize, 1.f);
    std::vector<float> product(kSize * kSize);
    dnnl::sgemm('N', 'N', kSize, kSize, kSize, 1, a.data(), kSize, a.data(), kSize, 0, product.data(), kSize);
    return product.front() == float(kSize) ? threadsOfThisProcess() : -1;
}
