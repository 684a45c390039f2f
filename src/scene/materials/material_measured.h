// A surface whose BRDF was measured (pbrt-v4's "measured"; PBR 4e, section 10.5).
#pragma once
#include "scene/lobes/measured_table.h"
#include "scene/materials/material.h"

namespace drc {

// table: not null; may be shared.
MaterialPtr makeMeasured(std::shared_ptr<const MeasuredTable> table, Relief relief);

}  // namespace drc
