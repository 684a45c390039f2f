// A rough diffuse BRDF is added to a Bsdf as the sum of two lobes: a separable one (see lobe.h), which is as large a
// part as a simple formula describes, and the rest, which is not a product of a function of wo and one of wi.
#pragma once

namespace drc {

enum class DiffusePart { Separable, Rest };

}  // namespace drc
