#include "neural/graph.h"

#include <algorithm>
#include <utility>

#include "neural/memory_plan.h"
#include "neural/onednn_thread.h"

namespace drc {
namespace {

using Desc = dnnl::memory::desc;
using Tag = dnnl::memory::format_tag;
using Type = dnnl::memory::data_type;

}  // namespace

Graph::Graph(PackedWeights& packed, Type type) : packed_(packed), type_(type), stream_(cpuEngine()) {
    // oneDNN's default scratchpad belongs to the thread that created the primitive, but a network may run on any
    // thread.
    plainAttributes_.set_scratchpad_mode(dnnl::scratchpad_mode::user);
}

Graph::TensorId Graph::addTensor(const Desc& desc, bool external) {
    Tensor tensor;
    tensor.desc = desc;
    tensor.external = external;
    tensors_.push_back(std::move(tensor));
    return TensorId(tensors_.size()) - 1;
}

void Graph::addStep(Step step) {
    const int index = int(steps_.size());
    for (const auto& argument : step.tensors) {
        Tensor& tensor = tensors_[size_t(argument.second)];
        if (tensor.firstStep < 0) tensor.firstStep = index;
        tensor.lastStep = index;
    }
    steps_.push_back(std::move(step));
}

void Graph::reorder(TensorId source, TensorId target) {
    const dnnl::reorder::primitive_desc pd(cpuEngine(), tensors_[size_t(source)].desc, cpuEngine(),
                                           tensors_[size_t(target)].desc, plainAttributes_);
    Step step;
    step.primitive = dnnl::reorder(pd);
    step.scratchpad = pd.scratchpad_desc();
    step.tensors = {{DNNL_ARG_FROM, source}, {DNNL_ARG_TO, target}};
    addStep(std::move(step));
}

Graph::TensorId Graph::reordered(TensorId source, const Desc& wanted) {
    if (tensors_[size_t(source)].desc == wanted) return source;
    const TensorId target = addTensor(wanted);
    reorder(source, target);
    return target;
}

Graph::TensorId Graph::input(int batch, int channels, int size) {
    return input_ = addTensor(Desc({batch, channels, size, size}, Type::f32, Tag::nchw), true);
}

Graph::TensorId Graph::conv(TensorId source, const UNetWeights::Conv& conv, const ConvOptions& options) {
    const int countIn = options.countIn ? options.countIn : conv.shape.in;
    const int k = conv.shape.kernel;
    dnnl::memory::dims dims = tensors_[size_t(source)].desc.dims();
    const Desc src(dims, type_, Tag::any);
    dims[1] = conv.shape.out;
    const Desc dst = options.addTo < 0 ? Desc(dims, options.inFloat ? Type::f32 : type_, Tag::any)
                                       : tensors_[size_t(options.addTo)].desc;
    const Desc weight = conv.shape.depthwise ? Desc({conv.shape.out, 1, 1, k, k}, type_, Tag::any)
                                             : Desc({conv.shape.out, countIn, k, k}, type_, Tag::any);
    const Desc bias = options.bias ? Desc({conv.shape.out}, Type::f32, Tag::a) : Desc();
    const Desc perChannel({1, conv.shape.out, 1, 1}, Type::f32, Tag::nchw);
    const dnnl::memory::dims padding{k / 2, k / 2};

    dnnl::post_ops after;
    std::vector<std::pair<int, dnnl::memory>> constants;
    if (options.addTo >= 0) after.append_sum(1.f);
    if (options.slope != 1) after.append_eltwise(1.f, dnnl::algorithm::eltwise_relu, options.slope, 0.f);
    if (options.affine && conv.shape.affine) {
        const auto then = [&](dnnl::algorithm operation, const std::vector<float>& values) {
            const int place = after.len();
            after.append_binary(operation, perChannel);
            constants.emplace_back(DNNL_ARG_ATTR_MULTIPLE_POST_OP(place) | DNNL_ARG_SRC_1,
                                   packed_.perChannel(values, perChannel));
        };
        then(dnnl::algorithm::binary_mul, conv.scale);
        then(dnnl::algorithm::binary_add, conv.shift);
    }
    dnnl::primitive_attr withPostOps;
    withPostOps.set_scratchpad_mode(dnnl::scratchpad_mode::user);
    withPostOps.set_post_ops(after);

    const dnnl::convolution_forward::desc desc(dnnl::prop_kind::forward_inference, dnnl::algorithm::convolution_direct,
                                               src, weight, bias, dst, {1, 1}, padding, padding);
    const dnnl::convolution_forward::primitive_desc pd(desc, withPostOps, cpuEngine());

    const TensorId from = reordered(source, pd.src_desc());
    const TensorId to = options.addTo < 0 ? addTensor(pd.dst_desc()) : options.addTo;
    Step step;
    step.primitive = dnnl::convolution_forward(pd);
    step.scratchpad = pd.scratchpad_desc();
    step.tensors = {{DNNL_ARG_SRC, from}, {DNNL_ARG_DST, to}};
    step.constants = std::move(constants);
    step.constants.emplace_back(DNNL_ARG_WEIGHTS, packed_.weight(conv, options.firstIn, countIn, pd.weights_desc()));
    if (options.bias) step.constants.emplace_back(DNNL_ARG_BIAS, packed_.perChannel(conv.bias, bias));
    addStep(std::move(step));
    return to;
}

Graph::TensorId Graph::maxPool2(TensorId source) {
    const Desc& src = tensors_[size_t(source)].desc;
    dnnl::memory::dims dims = src.dims();
    dims[2] /= 2, dims[3] /= 2;
    const dnnl::pooling_forward::desc desc(dnnl::prop_kind::forward_inference, dnnl::algorithm::pooling_max, src,
                                           Desc(dims, type_, Tag::any), {2, 2}, {2, 2}, {0, 0}, {0, 0});
    const dnnl::pooling_forward::primitive_desc pd(desc, plainAttributes_, cpuEngine());
    const TensorId target = addTensor(pd.dst_desc());
    Step step;
    step.primitive = dnnl::pooling_forward(pd);
    step.scratchpad = pd.scratchpad_desc();
    step.tensors = {{DNNL_ARG_SRC, source}, {DNNL_ARG_DST, target}};
    addStep(std::move(step));
    return target;
}

Graph::TensorId Graph::upsample2(TensorId source) {
    const Desc& src = tensors_[size_t(source)].desc;
    dnnl::memory::dims dims = src.dims();
    dims[2] *= 2, dims[3] *= 2;
    const dnnl::resampling_forward::desc desc(dnnl::prop_kind::forward_inference, dnnl::algorithm::resampling_linear,
                                              src, Desc(dims, type_, Tag::any));
    const dnnl::resampling_forward::primitive_desc pd(desc, plainAttributes_, cpuEngine());
    const TensorId target = addTensor(pd.dst_desc());
    Step step;
    step.primitive = dnnl::resampling_forward(pd);
    step.scratchpad = pd.scratchpad_desc();
    step.tensors = {{DNNL_ARG_SRC, source}, {DNNL_ARG_DST, target}};
    addStep(std::move(step));
    return target;
}

void Graph::output(TensorId source) {
    output_ = addTensor(Desc(tensors_[size_t(source)].desc.dims(), Type::f32, Tag::nchw), true);
    reorder(source, output_);
}

void Graph::compile() {
    std::vector<BufferUse> uses;
    for (const Tensor& tensor : tensors_)
        uses.push_back({tensor.external ? 0 : tensor.desc.get_size(), tensor.firstStep, tensor.lastStep});
    for (size_t i = 0; i < steps_.size(); ++i) uses.push_back({steps_[i].scratchpad.get_size(), int(i), int(i)});
    const MemoryPlan plan = planMemory(uses);
    arena_.assign(plan.bytes / sizeof(Line), Line{});
    auto* base = reinterpret_cast<std::byte*>(arena_.data());

    for (size_t i = 0; i < tensors_.size(); ++i) {
        Tensor& tensor = tensors_[i];
        tensor.memory = dnnl::memory(tensor.desc, cpuEngine(), tensor.external ? nullptr : base + plan.offsets[i]);
    }
    for (size_t i = 0; i < steps_.size(); ++i) {
        Step& step = steps_[i];
        step.scratchpadMemory = dnnl::memory(step.scratchpad, cpuEngine(), base + plan.offsets[tensors_.size() + i]);
        step.arguments.push_back({DNNL_ARG_SCRATCHPAD, step.scratchpadMemory.get()});
        for (const auto& [key, id] : step.tensors) step.arguments.push_back({key, tensors_[size_t(id)].memory.get()});
        for (const auto& [key, memory] : step.constants) step.arguments.push_back({key, memory.get()});
    }
}

void Graph::run(const float* input, float* output) {
    tensors_[size_t(input_)].memory.set_data_handle(const_cast<float*>(input));
    tensors_[size_t(output_)].memory.set_data_handle(output);
    for (const Step& step : steps_)
        // Calls the C function directly, because dnnl::primitive::execute takes a hash map and converts it to an array
        // at every call.
        dnnl::error::wrap_c_api(dnnl_primitive_execute(step.primitive.get(), stream_.get(), int(step.arguments.size()),
                                                       step.arguments.data()),
                                "could not execute a layer of the network");
    stream_.wait();
}

}  // namespace drc
