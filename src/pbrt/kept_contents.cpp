#include "pbrt/kept_contents.h"

#include <bit>

#include "math/sampler.h"
#include "pbrt/param_set.h"
#include "pbrt/shape_factory.h"

namespace drc::pbrt {
namespace {

// Two hashes with different starts. A collision would show the geometry of another shape, so 64 bits are too few for
// millions of shapes in thousands of frames.
class Hasher {
  public:
    void add(uint64_t value) {
        key_.first = hashCombine(key_.first, value);
        key_.second = hashCombine(key_.second, value ^ 0x9e3779b97f4a7c15ull);
    }
    void add(double value) { add(std::bit_cast<uint64_t>(value)); }
    void add(std::string_view text) {
        add(uint64_t(text.size()));
        for (const char c : text) add(uint64_t(uint8_t(c)));
    }
    const ContentKey& key() const { return key_; }

  private:
    ContentKey key_{0x243f6a8885a308d3ull, 0x13198a2e03707344ull};
};

template <typename Map, typename Key>
auto valueAt(const Map& map, const Key& key) -> typename Map::mapped_type {
    const auto found = map.find(key);
    return found != map.end() ? found->second : nullptr;
}

}  // namespace

ContentKey ContentKey::with(const ContentKey& other) const {
    return {hashCombine(first, other.first), hashCombine(second, other.second)};
}

ContentKey contentKeyOf(const std::string& type, const ShapeContext& context, const std::optional<FileStamp>& file) {
    Hasher hasher;
    hasher.add(type);
    hasher.add(uint64_t(context.dialect));
    hasher.add(uint64_t(context.reverseOrientation));
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) hasher.add(double(context.objectToWorld.at(row, column)));
    for (const Param& param : context.params.all()) {
        hasher.add(param.typeName);
        hasher.add(param.name);
        hasher.add(uint64_t(param.numbers.size()));
        for (const double number : param.numbers) hasher.add(number);
        for (const std::string& text : param.strings) hasher.add(text);
        for (const bool value : param.bools) hasher.add(uint64_t(value));
        for (const Rgb& color : param.colors)
            for (int c = 0; c < 3; ++c) hasher.add(double(color[c]));
    }
    if (file) {
        hasher.add(file->path);
        hasher.add(file->size);
        hasher.add(uint64_t(file->time));
    }
    return hasher.key();
}

TriangleMeshPtr KeptContents::mesh(const ContentKey& key) const { return valueAt(contents_.meshes, key); }
ShapePtr KeptContents::shape(const ContentKey& key) const { return valueAt(contents_.shapes, key); }

void KeptContents::replace(Contents contents, const Vec3& origin) {
    contents_ = std::move(contents);
    origin_ = origin;
}

}  // namespace drc::pbrt
