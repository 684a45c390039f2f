// Matrices as attributes of EXR files.
//
// OpenEXR's matrices act on row vectors, q = p M, and so do worldToCamera and worldToNDC in the files of other
// renderers. A Transform acts on column vectors: these functions transpose.
#pragma once
#include <optional>
#include <string>

#include "image/exr_storage.h"
#include "math/transform.h"

namespace drc {

// Its type is m44f.
ExrAttribute matrixAttribute(const Transform& transform);
// From an attribute of type m44f or m44d; none if there is no such attribute, or if it is of another type or not
// finite.
std::optional<Transform> matrixIn(const ExrAttributes& attributes, const std::string& name);

}  // namespace drc
