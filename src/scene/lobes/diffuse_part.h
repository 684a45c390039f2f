// Rough diffuse reflection is added to a Bsdf as two lobes, whose sum it is: one that is separable (see lobe.h), as
// large as is simply told, and the rest, which no factor of the view alone describes.
#pragma once

namespace drc {

enum class DiffusePart { Separable, Rest };

}  // namespace drc
