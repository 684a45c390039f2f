// Chooses the denoiser of radiance maps from the options of `drc render`.
#pragma once
#include "app/render_options.h"

namespace drc {

// Sets the denoiser and, unless --projection gives another one, the map layout that its network was trained for.
// Returns the hash of the network's weights; empty if there is no network. Throws Error if the network cannot be found
// or read.
std::string chooseMapDenoiser(const RenderOptions& options, IndirectSettings& indirect);

}  // namespace drc
