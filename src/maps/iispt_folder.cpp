#include "maps/iispt_folder.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/limits.h"
#include "base/parallel.h"
#include "image/pfm.h"
#include "neural/safetensors.h"

namespace drc {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view kKinds = "dnzp";
constexpr const char* kInfo = "train.json";

struct IisptName {
    char kind;
    int x, y;
};

std::optional<IisptName> parseName(std::string_view name) {
    IisptName result{};
    if (name.size() < 9 || kKinds.find(name[0]) == kKinds.npos || name[1] != '_' || !name.ends_with(".pfm")) return {};
    result.kind = name[0];
    const char *begin = name.data() + 2, *end = name.data() + name.size() - 4;
    const auto x = std::from_chars(begin, end, result.x);
    if (x.ec != std::errc() || x.ptr == end || *x.ptr != '_') return {};
    const auto y = std::from_chars(x.ptr + 1, end, result.y);
    if (y.ec != std::errc() || y.ptr != end) return {};
    return result;
}

std::string fileName(const std::string& folder, char kind, int x, int y) {
    return fmt::format("{}/{}_{}_{}.pfm", folder, kind, x, y);
}

// Counts values of a magnitude that is plausible in maps. Floats with swapped bytes hardly ever are, so the count
// reveals the byte order.
size_t ordinaryNumbers(const Image& image) {
    return size_t(std::count_if(image.data().begin(), image.data().end(),
                                [](float v) { return v == 0 || (std::abs(v) > 1e-12f && std::abs(v) < 1e12f); }));
}

Image readMap(const std::string& path, uint64_t* hash) {
    const std::string bytes = readFile(path);
    if (hash) *hash = hashBytes(bytes.data(), bytes.size()) + 31 * *hash;
    Image named = decodePfm(bytes, path);
    Image other = decodePfm(bytes, path, PfmOrder::Other);
    return ordinaryNumbers(other) > ordinaryNumbers(named) ? std::move(other) : std::move(named);
}

// The image's values as planes, [channels][size * size]. Throws Error if the image is not size x size.
std::vector<float> planar(const Image& image, size_t channels, int size, const std::string& path) {
    if (image.width() != size || image.height() != size || size_t(image.channels()) < channels)
        throw Error(fmt::format("{}: {} x {} with {} channels, not {} x {} with {}", path, image.width(),
                                image.height(), image.channels(), size, size, channels));
    std::vector<float> values;
    for (size_t c = 0; c < channels; ++c)
        for (size_t i = 0; i < image.pixelCount(); ++i)
            values.push_back(image.data()[i * size_t(image.channels()) + c]);
    return values;
}

Image picture(const std::vector<float>& values, int channels, int size) {
    Image image = channels == 3 ? Image(size, size) : Image(size, size, {"Y"});
    for (size_t c = 0; c < size_t(channels); ++c)
        for (size_t i = 0; i < image.pixelCount(); ++i)
            image.data()[i * size_t(channels) + c] = values[c * image.pixelCount() + i];
    return image;
}

void faceOrigin(CapturedMap& map, const MapLayout& layout) {
    // Angle from a texel's centre to its corner. A surface seen at grazing incidence may face the actual ray, yet face
    // away from the direction of the texel's centre by up to this angle.
    const float grazing = kPi / float(layout.size()) * 0.75f;
    const auto texels = size_t(layout.texels());
    for (size_t i = 0; i < texels; ++i) {
        const Vec3 d = layout.direction(int(i) % layout.size(), int(i) / layout.size(), Vec2(0.5f, 0.5f));
        const Vec3 n(map.normal[i], map.normal[texels + i], map.normal[2 * texels + i]);
        if (dot(n, d) > grazing)
            for (size_t c = 0; c < 3; ++c) map.normal[c * texels + i] *= -1;
    }
}

bool isPowerOfTwo(int n) { return n > 0 && (n & (n - 1)) == 0; }

}  // namespace

bool isIisptFile(std::string_view name) { return parseName(name).has_value(); }

IisptFolder::IisptFolder(const std::string& path) {
    path_ = path;
    guides_ = false;
    scene_ = fs::absolute(path).lexically_normal().filename().string();
    if (scene_.empty()) scene_ = fs::absolute(path).lexically_normal().parent_path().filename().string();
    std::map<std::pair<int, int>, std::set<char>> found;  // kinds of files present, by (row, column)
    std::error_code failed;
    for (fs::directory_iterator i(path, failed), end; !failed && i != end; i.increment(failed))
        if (const auto name = parseName(i->path().filename().string())) found[{name->y, name->x}].insert(name->kind);
    if (failed) throw Error(SourceLocation{path}, failed.message());
    if (found.empty())
        throw Error(SourceLocation{path}, "no files d_X_Y.pfm, n_X_Y.pfm, z_X_Y.pfm and p_X_Y.pfm in it");
    std::vector<Pixel> whole;
    for (const auto& [at, kinds] : found)
        if (kinds.size() == kKinds.size()) whole.push_back({at.second, at.first});

    int size = 0;
    for (size_t i = 0; i < whole.size() && size == 0; ++i) {
        try {
            const Image first = readMap(fileName(path_, 'd', whole[i].x, whole[i].y), nullptr);
            if (isPowerOfTwo(first.width()) && first.width() <= limits::kExampleMapSize) size = first.width();
        } catch (const Error&) {
        }
    }
    layout_ = MapLayout(Projection::LatLong, size ? size : 32);
    std::vector<std::optional<uint64_t>> hashes(whole.size());
    parallelFor(0, int(whole.size()), 16, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) hashes[size_t(i)] = check(whole[size_t(i)]);
    });
    std::string all;
    for (size_t i = 0; i < whole.size(); ++i) {
        if (!hashes[i]) continue;
        pixels_.push_back(whole[i]);
        all += fmt::format("{}_{} {:016x}\n", whole[i].x, whole[i].y, *hashes[i]);
    }
    hash_ = fmt::format("{:016x}", hashBytes(all.data(), all.size()));
    count_ = int(pixels_.size());
    std::string wrong;
    if (whole.size() < found.size())
        wrong = fmt::format("{} viewpoints lack some of their files d, n, z, p", found.size() - whole.size());
    if (pixels_.size() < whole.size())
        wrong += fmt::format("{}{} are damaged", wrong.empty() ? "" : ", ", whole.size() - pixels_.size());
    if (!wrong.empty()) damage_ = fmt::format("{}: {}; {} examples are usable", path_, wrong, count_);
}

std::optional<uint64_t> IisptFolder::check(const Pixel& pixel) const {
    TrainingExample example;
    uint64_t hash = 0;
    try {
        read(pixel, example, &hash);
    } catch (const Error&) {
        return std::nullopt;
    }
    return hash;
}

void IisptFolder::read(const Pixel& pixel, TrainingExample& example, uint64_t* hash) const {
    const auto plane = [&](char kind, size_t channels) {
        const std::string file = fileName(path_, kind, pixel.x, pixel.y);
        return planar(readMap(file, hash), channels, layout_.size(), file);
    };
    example = TrainingExample();
    example.film = Vec2(float(pixel.x) + 0.5f, float(pixel.y) + 0.5f);
    CapturedMap& map = example.inputs.emplace_back();
    map.radiance = plane('d', 3);
    map.normal = plane('n', 3);
    map.distance = plane('z', 1);
    for (float& z : map.distance) z = z < 0 ? -1 : z;
    example.target = plane('p', 3);
    faceOrigin(map, layout_);
    if (!isSound(example))
        throw Error(
            fmt::format("{}: negative or non-finite radiance, or a black map", fileName(path_, 'p', pixel.x, pixel.y)));
}

void IisptFolder::load(int index, int first, int count, TrainingExample& example) const {
    if (first < 0 || count < 0 || first + count > 1) throw Error(SourceLocation{path_}, "no such input");
    try {
        read(pixels_.at(size_t(index)), example, nullptr);
    } catch (const Error& error) {
        throw Error(SourceLocation{path_}, error.what());
    }
    example.viewpoint = index;
    example.inputs.resize(size_t(count));
}

IisptWriter::IisptWriter(const std::string& path, const ShardHeader& header) : path_(path), layout_(header.layout) {
    const auto fail = [&](const std::string& message) { throw Error(SourceLocation{path}, message); };
    std::error_code failed;
    fs::create_directories(path, failed);
    if (failed) fail(failed.message());
    const std::string info = path + "/" + kInfo;
    if (!fs::exists(info)) {
        for (const auto& entry : fs::directory_iterator(path))
            if (isIisptFile(entry.path().filename().string())) fail("made by another program; name another folder");
        // The authors' format contains these two numbers, but nothing reads them.
        const Json json{{"normalization_intensity", 0.0},
                        {"normalization_distance", 0.0},
                        {"drc", Json::parse(headerJson(header))}};
        writeFileAtomically(info, json.dump() + "\n");
        return;
    }
    const Json json = Json::parse(readFile(info), nullptr, false);
    if (!json.is_object() || !json.contains("drc")) fail("made by another program; name another folder");
    std::string difference;
    try {
        difference = firstDifference(parseHeaderJson(json["drc"].dump()), header);
    } catch (const Error& error) {
        fail(fmt::format("{}: {}", kInfo, error.what()));
    }
    if (!difference.empty())
        fail(fmt::format("made with {}; ask for the same, name another folder, or remove this one", difference));
}

bool IisptWriter::has(const Vec2& film) const {
    // write() writes the file of the last kind last, so that all others exist.
    return fs::exists(fileName(path_, kKinds.back(), int(film.x), int(film.y)));
}

void IisptWriter::write(const TrainingExample& example) const {
    const CapturedMap& map = example.inputs.front();
    const auto put = [&](char kind, const std::vector<float>& values, int channels) {
        writeFileAtomically(fileName(path_, kind, int(example.film.x), int(example.film.y)),
                            encodePfm(picture(values, channels, layout_.size())));
    };
    put('d', map.radiance, 3);
    put('n', map.normal, 3);
    put('z', map.distance, 1);
    put('p', example.target, 3);
}

}  // namespace drc
