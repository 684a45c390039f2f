#include "render/film.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/mapped_file.h"
#include "base/memory.h"
#include "render/sample_pass.h"

namespace drc {
namespace {

size_t bytesOf(const std::vector<FilmLayerSpec>& layers) {
    size_t bytes = 0;
    for (const FilmLayerSpec& spec : layers) bytes += spec.bytesPerPixel();
    return bytes;
}

// Called before the film is allocated. Finishing a picture takes about as much memory as the film itself.
void requireMemory(const RenderSettings& settings, const std::vector<FilmLayerSpec>& layers) {
    constexpr double kForPicture = 200;  // bytes a pixel: images, G-buffer and the encoded files
    const PixelRegion region = settings.region();
    try {
        const MemoryClaim memory(double(region.count()) * (2 * double(bytesOf(layers)) + kForPicture),
                                 fmt::format("a picture of {} x {} pixels", region.width(), region.height()));
    } catch (const Error& error) {
        throw Error(settings.filmAt,
                    std::string(error.what()) + "; choose a smaller --resolution, or a part of it by --crop");
    }
}

// FNV-1a over 64-bit words: it detects damage, not attacks.
uint64_t checksum(std::span<const std::byte> bytes, uint64_t sum) {
    size_t i = 0;
    for (; i + 8 <= bytes.size(); i += 8) {
        uint64_t word;
        std::memcpy(&word, bytes.data() + i, 8);
        sum = (sum ^ word) * 0x100000001b3ull;
        sum ^= sum >> 29;
    }
    for (; i < bytes.size(); ++i) sum = (sum ^ uint64_t(bytes[i])) * 0x100000001b3ull;
    return sum;
}
constexpr uint64_t kChecksumStart = 0xcbf29ce484222325ull;

}  // namespace

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
    mapPasses = other.mapPasses;
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

int Film::passes() const { return *std::min_element(rowPasses_.begin(), rowPasses_.end()); }

void Film::clear() {
    for (int y = region_.y0; y < region_.y1; ++y) {
        const auto lock = lockRow(y);
        for (FilmLayer& layer : layers_) std::ranges::fill(layer.row(y), std::byte{});
        setRowPasses(y, 0);
    }
    mapPasses = 0;
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
    mapPasses += other.mapPasses;
}

// A line of text, so that a person who opens the file can tell what it is.
std::string Film::header(const std::string& identity) const {
    std::string text = fmt::format("drc film 1 {} {} {} {} {:016x}", region_.x0, region_.y0, region_.x1, region_.y1,
                                   checksum(std::as_bytes(std::span(identity)), kChecksumStart));
    for (const FilmLayer& layer : layers_) {
        const FilmLayerSpec& s = layer.spec();
        text += fmt::format(" {}:{}x{}{}{}:{:a}", s.name, s.groups, s.channels, s.weighted ? "w" : "",
                            s.storage == FilmLayerSpec::Storage::Exact ? "i8" : "f4", s.quantum);
    }
    return text + "\n";
}

void Film::save(const std::string& path, const std::string& identity) const {
    AtomicFile file(path);
    uint64_t sum = kChecksumStart;
    const auto write = [&](std::span<const std::byte> bytes) {
        sum = checksum(bytes, sum);
        file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    };
    file.write(header(identity));
    const std::shared_ptr<const Film> still = snapshot();
    write(std::as_bytes(std::span(still->rowPasses_)));
    write(std::as_bytes(std::span(&still->mapPasses, 1)));
    for (const FilmLayer& layer : still->layers_)
        for (int y = region_.y0; y < region_.y1; ++y) write(layer.row(y));
    const uint64_t end = sum;
    file.write({reinterpret_cast<const char*>(&end), sizeof(end)});
    file.commit();
}

void Film::load(const std::string& path, const std::string& identity) {
    const MappedFile file(path);
    const std::span<const std::byte> bytes = std::as_bytes(std::span(file.bytes()));
    const std::string_view text = file.bytes();
    const std::string expected = header(identity);
    if (!text.starts_with("drc film ")) throw Error(fmt::format("{}: not a film of drc", path));
    if (!text.starts_with(expected))
        throw Error(fmt::format("{}: a film of another scene, other settings or another version", path));
    size_t size = rowPasses_.size() * sizeof(int32_t) + sizeof(mapPasses);
    size += region_.count() * bytesPerPixel();
    if (bytes.size() != expected.size() + size + sizeof(uint64_t))
        throw Error(fmt::format("{}: the file is damaged: it has {} bytes, {} were expected", path, bytes.size(),
                                expected.size() + size + sizeof(uint64_t)));
    std::span<const std::byte> rest = bytes.subspan(expected.size());
    // The checksum depends on how the bytes are divided, so it must see the same pieces that were written.
    uint64_t sum = kChecksumStart;
    const auto verify = [&](size_t count) {
        sum = checksum(rest.first(count), sum);
        rest = rest.subspan(count);
    };
    verify(rowPasses_.size() * sizeof(int32_t));
    verify(sizeof(mapPasses));
    for (const FilmLayer& layer : layers_)
        for (int y = region_.y0; y < region_.y1; ++y) verify(layer.row(y).size());
    uint64_t stored = 0;
    std::memcpy(&stored, rest.data(), sizeof(stored));
    if (stored != sum) throw Error(fmt::format("{}: the file is damaged: its checksum is wrong", path));
    rest = bytes.subspan(expected.size());
    const auto read = [&](std::span<std::byte> to) {
        std::memcpy(to.data(), rest.data(), to.size());
        rest = rest.subspan(to.size());
    };
    read(std::as_writable_bytes(std::span(rowPasses_)));
    read(std::as_writable_bytes(std::span(&mapPasses, 1)));
    for (FilmLayer& layer : layers_)
        for (int y = region_.y0; y < region_.y1; ++y) read(layer.row(y));
}

}  // namespace drc
