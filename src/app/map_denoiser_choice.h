// Chooses the denoiser of radiance maps by the options of `drc render`.
#pragma once
#include "app/render_options.h"

namespace drc {

// Sets the denoiser, and the layout of the maps to the one that it was made for. Returns the hash of its network's
// weights; empty if it has no network. Throws Error if the network cannot be found or read.
std::string chooseMapDenoiser(const RenderOptions& options, IndirectSettings& indirect);

}  // namespace drc
