// Where the objects of a picture are: the matrix to world space of each object that the layer IndexOB names. Those of
// two frames tell how each object has moved rigidly from one to the other.
//
// World space is that of the scene file, of which the layer Position has the points.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "image/exr_storage.h"
#include "math/transform.h"

namespace drc {

class ObjectPlacements {
  public:
    // The largest number that a float, and so the layer IndexOB, holds exactly together with all smaller ones.
    static constexpr uint32_t kMostObjects = 1 << 24;

    // Pictures tell the places of all objects up to this number of them, 7 MB, and else of those alone that they show.
    static constexpr size_t kMostWritten = 1 << 17;

    // Places an object, each once, by an affine transformation to world space, of which floats are kept. Fast where
    // numbers ascend from call to call. An object that is placed by the identity takes no memory.
    void add(uint32_t object, const Transform& toWorld);
    // The transformation of an object to world space: the identity if the object has not been added.
    Transform of(uint32_t object) const;
    // Those of the given objects alone.
    ObjectPlacements only(const std::set<uint32_t>& objects) const;
    // These and the others, which must be of other objects.
    ObjectPlacements with(const ObjectPlacements& others) const;
    size_t size() const { return rows_.size(); }

    // As the attribute of an EXR. Of type floatvector: for each object its number, and the three upper rows of the
    // matrix that acts on column vectors, the last number of each row being the translation.
    static constexpr const char* kAttribute = "drc:objects";
    ExrAttribute attribute() const;
    // The contents of this attribute; empty if there is none. Throws Error if it is damaged.
    static ObjectPlacements in(const ExrAttributes& attributes);

  private:
    struct Row {
        float object;
        std::array<float, 12> toWorld;
    };
    std::vector<Row> rows_;  // by object, ascending
};

}  // namespace drc
