#include "film/film.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "base/error.h"
#include "base/memory.h"
#include "film/sample_pass.h"
#include "math/rng.h"

namespace drc {
namespace {

size_t bytesOf(const std::vector<FilmLayerSpec>& layers) {
    size_t bytes = 0;
    for (const FilmLayerSpec& spec : layers) bytes += spec.bytesPerPixel();
    return bytes;
}

// The first words of files that contain only a film; kHeader adds the version of the format.
const std::string kKind = "drc film", kHeader = kKind + " 3 ";

}  // namespace

void Film::requireMemory(const RenderSettings& settings, const std::vector<FilmLayerSpec>& layers) {
    // Finishing a picture needs about as much memory as the film itself: hence the factor 2 below.
    constexpr double kForPicture = 200;  // bytes per pixel: images, G-buffer and the encoded files
    const PixelRegion region = settings.region();
    try {
        const MemoryClaim memory(double(region.count()) * (2 * double(bytesOf(layers)) + kForPicture),
                                 fmt::format("a picture of {} x {} pixels", region.width(), region.height()));
    } catch (const Error& error) {
        throw Error(settings.filmAt,
                    std::string(error.what()) + "; choose a smaller --resolution, or a part of it by --crop");
    }
}

Film::Film(const RenderSettings& settings, std::vector<FilmLayerSpec> layers) : region_(settings.region()) {
    requireMemory(settings, layers);
    for (const FilmLayerSpec& spec : layers) layers_.emplace_back(region_, spec);
    rowPasses_.resize(size_t(region_.height()));
    rowMutexes_ = std::make_unique<std::mutex[]>(size_t(region_.height()));
}

Film::Film(const Film& other, const PixelRegion& part) : region_(part) {
    for (const FilmLayer& layer : other.layers_) layers_.emplace_back(region_, layer.spec());
    rowPasses_.resize(size_t(region_.height()));
    rowMutexes_ = std::make_unique<std::mutex[]>(size_t(region_.height()));
    for (int y = region_.y0; y < region_.y1; ++y) {
        const auto lock = other.lockRow(y);
        for (size_t i = 0; i < layers_.size(); ++i) layers_[i].copyRow(other.layers_[i], y);
        setRowPasses(y, other.rowPasses(y));
    }
    setMapPasses(other.mapPasses());
}

FilmLayer& Film::layer(std::string_view name) {
    for (FilmLayer& layer : layers_)
        if (layer.spec().name == name) return layer;
    throw std::out_of_range("the film has no layer " + std::string(name));
}

bool Film::has(std::string_view name) const {
    return std::any_of(layers_.begin(), layers_.end(), [&](const FilmLayer& l) { return l.spec().name == name; });
}

size_t Film::bytesPerPixel() const {
    size_t bytes = 0;
    for (const FilmLayer& layer : layers_) bytes += layer.spec().bytesPerPixel();
    return bytes;
}

int Film::passes() const {
    int least = std::numeric_limits<int>::max();
    for (int y = region_.y0; y < region_.y1; ++y) least = std::min(least, rowPasses(y));
    return least;
}

void Film::clear() {
    for (int y = region_.y0; y < region_.y1; ++y) {
        const auto lock = lockRow(y);
        for (FilmLayer& layer : layers_) std::ranges::fill(layer.row(y), std::byte{});
        setRowPasses(y, 0);
    }
    setMapPasses(0);
}

std::shared_ptr<const Film> Film::snapshot(const PixelRegion& part) const {
    return std::shared_ptr<const Film>(new Film(*this, part));
}

void Film::add(const Film& other) {
    const auto same = [](const FilmLayer& a, const FilmLayer& b) { return a.spec() == b.spec(); };
    if (other.region_ != region_ ||
        !std::equal(layers_.begin(), layers_.end(), other.layers_.begin(), other.layers_.end(), same))
        throw Error("the films to be added have different sizes or layers");
    for (size_t i = 0; i < layers_.size(); ++i) layers_[i].add(other.layers_[i]);
    for (size_t i = 0; i < rowPasses_.size(); ++i)
        rowPasses_[i] = SamplePass::passesFor(SamplePass::wholeSamples(rowPasses_[i]) +
                                              SamplePass::wholeSamples(other.rowPasses_[i]));
    setMapPasses(mapPasses() + other.mapPasses());
}

std::string Film::description(const std::string& identity) const {
    uint64_t sum = identity.size();
    for (const char c : identity) sum = hash(sum, uint8_t(c));
    std::string text = fmt::format("{} {} {} {} {:016x}", region_.x0, region_.y0, region_.x1, region_.y1, sum);
    for (const FilmLayer& layer : layers_) {
        const FilmLayerSpec& s = layer.spec();
        text += fmt::format(" {}:{}x{}{}{}:{:a}", s.name, s.groups, s.channels, s.weighted ? "w" : "",
                            s.storage == FilmLayerSpec::Storage::Exact ? "i8" : "f4", s.quantum);
    }
    return text;
}

void Film::save(StateWriter& to) const {
    const std::shared_ptr<const Film> still = snapshot();
    to.values(std::span(still->rowPasses_));
    to.value(int32_t(still->mapPasses()));
    for (const FilmLayer& layer : still->layers_)
        for (int y = region_.y0; y < region_.y1; ++y) to.bytes(layer.row(y));
}

void Film::load(StateReader& from) {
    const size_t size = (rowPasses_.size() + 1) * sizeof(int32_t) + region_.count() * bytesPerPixel();
    if (from.remaining() != size)
        from.fail(fmt::format("it has {} bytes for the film, {} were expected", from.remaining(), size));
    from.values(std::span(rowPasses_));
    setMapPasses(from.value<int32_t>());
    for (FilmLayer& layer : layers_)
        for (int y = region_.y0; y < region_.y1; ++y) from.bytes(layer.row(y));
}

void Film::save(const std::string& path, const std::string& identity) const {
    StateWriter file(path, kHeader + description(identity));
    save(file);
    file.commit();
}

void Film::load(const std::string& path, const std::string& identity) {
    StateReader file(path, kKind, kHeader + description(identity));
    load(file);
}

}  // namespace drc
