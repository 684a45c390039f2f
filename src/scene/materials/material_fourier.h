// A surface whose BSDF is a table (pbrt-v3's "fourier"; PBR 3e, section 9.2).
#pragma once
#include "scene/lobes/fourier_table.h"
#include "scene/materials/material.h"

namespace drc {

// table: not null; may be shared.
MaterialPtr makeFourier(std::shared_ptr<const FourierTable> table, Relief relief);

}  // namespace drc
