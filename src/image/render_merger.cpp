#include "image/render_merger.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

#include "base/error.h"
#include "base/log.h"
#include "base/memory.h"
#include "image/frame_geometry.h"
#include "image/image_layers.h"
#include "image/picture_window.h"

namespace drc {
namespace {

constexpr const char* kColours[] = {"R", "G", "B"};

std::string valueOf(const ExrMetadata& metadata, const std::string& key) {
    const auto found = metadata.find(key);
    return found == metadata.end() ? "" : found->second;
}

// The seeds of a render. A merged file lists several, as "0,3".
std::vector<std::string> seedsOf(const PictureFile& render) {
    std::vector<std::string> seeds;
    const std::string text = valueOf(render.metadata, "drc:seed");
    for (size_t begin = 0; begin < text.size();) {
        const size_t end = std::min(text.find(',', begin), text.size());
        seeds.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return seeds;
}

// Samples per pixel from the metadata; 0 if they are missing or invalid.
int64_t sppOf(const PictureFile& render) {
    const std::string text = valueOf(render.metadata, "drc:spp");
    char* end = nullptr;
    const long long spp = std::strtoll(text.c_str(), &end, 10);
    return !text.empty() && *end == '\0' && spp > 0 && spp <= int64_t(1) << 40 ? spp : 0;
}

// Denoised pixels are not independent, and their variance is unknown.
bool isDenoised(const PictureFile& render) {
    const std::string denoiser = valueOf(render.metadata, "drc:denoiser");
    return denoiser.starts_with("oidn") || denoiser == "surface";
}

std::string missingChannel(const Image& from, const std::vector<std::string>& names) {
    for (const std::string& name : names)
        if (from.channelIndex(name) < 0) return name;
    return "";
}

}  // namespace

void RenderMerger::requireFit(const PictureFile& render) const {
    const Image& image = render.image;
    if (image.width() != first_.image.width() || image.height() != first_.image.height())
        throw Error(fmt::format("{} is {}, but {} is {}: only pictures of one size can be merged", render.path,
                                placeString(image, render.window), first_.path,
                                placeString(first_.image, first_.window)));
    const ExrWindow &a = render.window, &b = first_.window;
    if (a.x != b.x || a.y != b.y || a.fullWidth != b.fullWidth || a.fullHeight != b.fullHeight)
        throw Error(fmt::format("{} and {} show different parts of the film", render.path, first_.path));
    const auto complain = [](const std::string& path, const std::string& channel, const std::string& other) {
        throw Error(
            fmt::format("{} has no channel {}, which {} has: give all renders the same --aovs", path, channel, other));
    };
    if (const std::string name = missingChannel(image, first_.image.channelNames()); !name.empty())
        complain(render.path, name, first_.path);
    if (const std::string name = missingChannel(first_.image, image.channelNames()); !name.empty())
        complain(first_.path, name, render.path);
    if (valueOf(render.metadata, "drc:integrator") != valueOf(first_.metadata, "drc:integrator"))
        logWarning(fmt::format("{} and {} are of different integrators, whose samples are not worth the same",
                               first_.path, render.path));
}

void RenderMerger::requireSameFrame(const PictureFile& render) const {
    const int mine = frameNumberIn(render.metadata), first = frameNumberIn(first_.metadata);
    if (mine == first) return;
    throw Error(fmt::format(
        "{} is of frame {}, but {} is of frame {}: renders of one frame are merged; drc image average makes "
        "the mean of several, and drc render --frame numbers what is one frame in files of several names",
        render.path, mine, first_.path, first));
}

void RenderMerger::requireNewSamples(const PictureFile& render) {
    const auto bytes = std::as_bytes(std::span(render.image.data()));
    const size_t hash = std::hash<std::string_view>()({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    if (!contents_.insert(hash).second)
        throw Error(fmt::format("{} is the same picture as one before it: its samples would count twice", render.path));
    for (const std::string& seed : seedsOf(render)) {
        for (const auto& [other, path] : seedsOf_)
            if (other == seed)
                throw Error(
                    fmt::format("{} and {} have the same seed {}, so that samples would count twice: render one with "
                                "another --seed",
                                path, render.path, seed));
        seedsOf_.insert({seed, render.path});
        seeds_.push_back(seed);
    }
}

void RenderMerger::setSurfaceChannels() {
    const Image& image = first_.image;
    for (const std::string& channel : image.channelNames()) {
        const std::string layer = layerOfChannel(channel);
        const int index = image.channelIndex(channel);
        if (layer == kPositionLayer) surface_.push_back(index);
        if (layer == kObjectIndexLayer || layer == kMaterialIndexLayer) indices_.push_back(index);
    }
    // Without a depth, nothing tells where a position is one.
    const int depth = image.channelIndex(std::string(kDepthLayer) + ".Z");
    if (depth < 0)
        surface_.clear();
    else
        surface_.push_back(depth);
}

Image RenderMerger::sampleCounts(const PictureFile& render) const {
    Image counts(render.image.width(), render.image.height(), {"X"});
    const int64_t spp = sppOf(render);
    if (count_ < 0 && spp == 0)
        throw Error(
            fmt::format("{} does not tell its number of samples: it has neither a layer \"{}\" nor metadata "
                        "drc:spp; drc image average weighs all pictures alike",
                        render.path, kSampleCountLayer));
    const int channel = count_ < 0 ? -1 : render.image.channelIndex(first_.image.channelNames()[size_t(count_)]);
    for (int y = 0; y < counts.height(); ++y)
        for (int x = 0; x < counts.width(); ++x) {
            const float n = channel < 0 ? float(spp) : render.image.at(x, y, channel);
            if (!(n >= 0) || n > 1e12f)
                throw Error(fmt::format("{}: the layer \"{}\" has {} at ({}, {}), which is no number of samples",
                                        render.path, kSampleCountLayer, n, x, y));
            counts.at(x, y, 0) = n;
        }
    return counts;
}

void RenderMerger::add(const PictureFile& render) {
    const Image& image = render.image;
    if (paths_.empty()) {
        first_ = {render.path,     Image(image.width(), image.height(), image.channelNames()),
                  render.encoding, render.metadata,
                  render.window,   render.storage};
        first_.storage.halfChannels.clear();  // a merged render needs more digits than a half has
        count_ = image.channelIndex(std::string(kSampleCountLayer) + ".X");
        for (const char* colour : kColours) beauty_.push_back(image.channelIndex(colour));
        if (*std::min_element(beauty_.begin(), beauty_.end()) < 0)
            throw Error(
                fmt::format("{} has no channels R, G and B; its layers are: {}", render.path, layerList(image)));
        for (const char* colour : kColours)
            if (const int c = image.channelIndex(fmt::format("{}.{}", kVarianceLayer, colour)); c >= 0)
                variance_.push_back(c);
        if (variance_.size() < 3) variance_.clear();
        setSurfaceChannels();
        const size_t pixels = image.pixelCount(), channels = size_t(image.channels());
        const MemoryClaim memory(double(pixels) * (16.0 * double(channels) + 76), "merging pictures");
        samples_.resize(pixels), knownSamples_.resize(pixels), renders_.resize(pixels);
        sums_.resize(pixels * channels), plainSums_.resize(pixels * channels);
        metSamples_.resize(pixels);
        varianceSums_.resize(pixels * 3), squares_.resize(pixels * 3);
    } else {
        requireFit(render);
        requireSameFrame(render);
    }
    requireNewSamples(render);
    const Image counts = sampleCounts(render);
    if (isDenoised(render))
        logWarning(
            fmt::format("{} is denoised: merge pictures of --denoise off, then use drc image denoise", render.path));
    spp_ += sppOf(render);
    allTellSpp_ &= sppOf(render) > 0;
    // For each channel in the first file's order, which the members use, its index in this file.
    std::vector<int> order;
    for (const std::string& name : first_.image.channelNames()) order.push_back(image.channelIndex(name));
    std::vector<float> values(order.size());
    int64_t bad = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            for (size_t c = 0; c < order.size(); ++c) values[c] = image.at(x, y, order[c]);
            const auto isRadianceFinite = [&](int c) { return std::isfinite(values[size_t(c)]); };
            if (std::all_of(beauty_.begin(), beauty_.end(), isRadianceFinite))
                addPixel(size_t(y) * size_t(image.width()) + size_t(x), values.data(), double(counts.at(x, y, 0)));
            else
                ++bad;
        }
    if (bad > 0) logWarning(fmt::format("{}: {} pixel(s) are NaN or infinite and are left out", render.path, bad));
    paths_.push_back(render.path);
}

void RenderMerger::addPixel(size_t pixel, const float* values, double n) {
    const size_t channels = size_t(first_.image.channels());
    const bool meets = surface_.empty() || values[surface_.back()] < kNoDepth;
    if (meets) metSamples_[pixel] += n;
    for (size_t c = 0; c < channels; ++c) {
        if (!meets && std::ranges::find(surface_, int(c)) != surface_.end()) continue;
        // NaN or infinity in another layer must not spoil the sum.
        const double value = std::isfinite(values[c]) ? double(values[c]) : 0;
        sums_[pixel * channels + c] += n * value;
        plainSums_[pixel * channels + c] += value;
    }
    if (renders_[pixel] == 0)
        for (const int c : indices_) first_.image.data()[pixel * channels + size_t(c)] = values[c];
    ++renders_[pixel];
    samples_[pixel] += n;
    for (size_t i = 0; i < 3; ++i) {
        const double radiance = double(values[beauty_[i]]);
        squares_[pixel * 3 + i] += n * radiance * radiance;
    }
    const auto isKnown = [&](int c) { return std::isfinite(values[c]) && values[c] >= 0; };
    if (n < 2 || variance_.empty() || !std::all_of(variance_.begin(), variance_.end(), isKnown)) return;
    knownSamples_[pixel] += n;
    for (size_t i = 0; i < 3; ++i) varianceSums_[pixel * 3 + i] += n * n * double(values[variance_[i]]);
}

PictureFile RenderMerger::merged() const {
    PictureFile result = first_;
    const size_t channels = size_t(first_.image.channels());
    for (size_t pixel = 0; pixel < samples_.size(); ++pixel) {
        const double n = samples_[pixel];
        float* to = result.image.data().data() + pixel * channels;
        for (size_t c = 0; c < channels; ++c)
            to[c] = float(n > 0 ? sums_[pixel * channels + c] / n
                                : plainSums_[pixel * channels + c] / std::max(1, renders_[pixel]));
        for (const int c : surface_)
            to[c] = metSamples_[pixel] > 0 ? float(sums_[pixel * channels + size_t(c)] / metSamples_[pixel])
                    : c == surface_.back() ? kNoDepth
                                           : 0.f;
        for (const int c : indices_) to[c] = first_.image.data()[pixel * channels + size_t(c)];
        if (count_ >= 0) to[count_] = float(n);
        for (size_t i = 0; i < variance_.size(); ++i) {
            double ofSample = 0;  // the variance of a single sample
            if (knownSamples_[pixel] > 0) {
                ofSample = varianceSums_[pixel * 3 + i] / knownSamples_[pixel];
            } else if (renders_[pixel] > 1 && n > 0) {
                const double mean = sums_[pixel * channels + size_t(beauty_[i])] / n;
                ofSample = std::max(0.0, squares_[pixel * 3 + i] - n * mean * mean) / (renders_[pixel] - 1);
            }
            to[variance_[i]] = n > 0 ? float(ofSample / n) : 0.f;
        }
    }
    std::string seeds;
    for (const std::string& seed : seeds_) seeds += (seeds.empty() ? "" : ",") + seed;
    if (!seeds.empty()) result.metadata["drc:seed"] = seeds;
    result.metadata.erase("drc:spp");
    if (allTellSpp_) result.metadata["drc:spp"] = std::to_string(spp_);
    result.metadata.erase("drc:interrupted");
    result.metadata.erase("drc:passes");
    // Errors that all renders have in common do not average out, and their size is unknown, so there is no error
    // estimate.
    result.metadata.erase("drc:error");
    result.image = withoutLayers(result.image, {kErrorLayer});
    return result;
}

}  // namespace drc
