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
    const int k = conv.shape.kernel;
    const dnnl::memory::desc plain({conv.shape.out, countIn, k, k}, dnnl::memory::data_type::f32,
                                   dnnl::memory::dims{dnnl::memory::dim(conv.shape.in) * k * k, k * k, k, 1});
    dnnl::memory from(plain, cpuEngine(), const_cast<float*>(conv.weight.data()) + size_t(firstIn) * k * k);
    dnnl::memory to(wanted, cpuEngine());
    dnnl::stream stream(cpuEngine());
    dnnl::reorder(from, to).execute(stream, from, to);
    stream.wait();
    layouts.push_back(to);
    return to;
}

dnnl::memory PackedWeights::bias(const UNetWeights::Conv& conv) {
    const std::lock_guard lock(mutex_);
    auto& layouts = packed_[conv.shape.name + ".bias"];
    if (layouts.empty()) {
        layouts.emplace_back(
            dnnl::memory::desc({conv.shape.out}, dnnl::memory::data_type::f32, dnnl::memory::format_tag::a),
            cpuEngine());
        std::memcpy(layouts[0].get_data_handle(), conv.bias.data(), conv.bias.size() * sizeof(float));
    }
    return layouts[0];
}

}  // namespace drc
