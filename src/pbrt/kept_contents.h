// Meshes, shapes and images of textures that the frames of an animation have in common. A scene that is loaded with the
// KeptContents of the frame before shares with it all that both files describe in the same way, so that it is neither
// read again nor kept twice, and so that Accel can tell what has changed.
#pragma once
#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "base/file_stamp.h"
#include "math/vec.h"
#include "pbrt/texture_files.h"
#include "scene/shapes/shape.h"
#include "scene/shapes/triangle_mesh.h"

namespace drc::pbrt {

struct ShapeContext;

// Identifies a shape by all that its geometry depends on: a hash of 128 bits.
struct ContentKey {
    uint64_t first = 0, second = 0;
    auto operator<=>(const ContentKey&) const = default;
    ContentKey with(const ContentKey& other) const;
};

// The key of a shape's geometry. file: the file that it is read from; none: it is in its parameters alone.
ContentKey contentKeyOf(const std::string& type, const ShapeContext& context, const std::optional<FileStamp>& file);

class KeptContents {
  public:
    // Each returns null if nothing is kept under the key.
    TriangleMeshPtr mesh(const ContentKey& key) const;
    ShapePtr shape(const ContentKey& key) const;
    template <typename T>
    std::shared_ptr<MipPyramid<T>> pyramid(const FileStamp& file, const TexelReading& how) const {
        const auto& known = std::get<Pyramids<T>>(pyramids_);
        const auto found = known.find({file, how});
        return found != known.end() ? found->second : nullptr;
    }
    // Scene::origin of the latest scene; none: no scene has been loaded.
    const std::optional<Vec3>& origin() const { return origin_; }

    // The contents of one scene, collected while it is loaded, in place of those of the scene before.
    struct Contents {
        std::map<ContentKey, TriangleMeshPtr> meshes;
        std::map<ContentKey, ShapePtr> shapes;
    };
    template <typename T>
    using Pyramids = std::map<std::pair<FileStamp, TexelReading>, std::shared_ptr<MipPyramid<T>>>;
    void replace(Contents contents, const Vec3& origin);
    template <typename T>
    void replace(Pyramids<T> pyramids) {
        std::get<Pyramids<T>>(pyramids_) = std::move(pyramids);
    }

  private:
    Contents contents_;
    std::tuple<Pyramids<Rgb>, Pyramids<float>> pyramids_;
    std::optional<Vec3> origin_;
};

}  // namespace drc::pbrt
