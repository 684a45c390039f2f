#include "neural/packed_weights.h"

#include <fmt/core.h>

#include <cstring>

#include "neural/onednn_thread.h"

namespace drc {

dnnl::memory PackedWeights::weight(const UNetWeights::Conv& conv, int firstIn, int countIn,
                                   const dnnl::memory::desc& wanted) {
    const std::lock_guard lock(mutex_);
    auto& layouts = packed_[fmt::format("{}.weight {}+{}", conv.shape.name, firstIn, countIn)];
    for (const dnnl::memory& memory : layouts)
        if (memory.get_desc() == wanted) return memory;

    const SingleThreadScope single;
    using Dims = dnnl::memory::dims;
    const int k = conv.shape.kernel, in = conv.shape.inputsPerFilter();
    const Dims dims = conv.shape.depthwise ? Dims{conv.shape.out, 1, 1, k, k} : Dims{conv.shape.out, countIn, k, k};
    const Dims strides =
        conv.shape.depthwise ? Dims{k * k, k * k, k * k, k, 1} : Dims{dnnl::memory::dim(in) * k * k, k * k, k, 1};
    const dnnl::memory::desc plain(dims, dnnl::memory::data_type::f32, strides);
    dnnl::memory from(plain, cpuEngine(), const_cast<float*>(conv.weight.data()) + size_t(firstIn) * k * k);
    dnnl::memory to(wanted, cpuEngine());
    dnnl::stream stream(cpuEngine());
    dnnl::reorder(from, to).execute(stream, from, to);
    stream.wait();
    layouts.push_back(to);
    return to;
}

dnnl::memory PackedWeights::perChannel(const std::vector<float>& values, const dnnl::memory::desc& wanted) {
    const std::lock_guard lock(mutex_);
    const auto found = channels_.find(values.data());
    if (found != channels_.end()) return found->second;
    dnnl::memory memory(wanted, cpuEngine());
    std::memcpy(memory.get_data_handle(), values.data(), values.size() * sizeof(float));
    channels_.emplace(values.data(), memory);
    return memory;
}

}  // namespace drc
