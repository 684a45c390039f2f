// libFuzzer's entry point. DRC_FUZZ_TARGET is one of the functions in targets.h.
#include <cstddef>
#include <cstdint>

#include "base/log.h"
#include "fuzz/targets.h"

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    drc::setLogLevel(drc::LogLevel::Quiet);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    drc::forgetWarnings();  // otherwise the warnings of millions of inputs would accumulate
    drc::fuzz::DRC_FUZZ_TARGET(std::string_view(reinterpret_cast<const char*>(data), size));
    return 0;
}
