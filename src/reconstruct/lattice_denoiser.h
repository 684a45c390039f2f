// Denoising of pictures whose first sample is not complete (SamplePass): parts of such a picture are known on every
// second or fourth pixel alone. There, what a denoiser takes for noise is two or four pixels wide, and it would leave
// that. So those parts are denoised as a smaller picture, and enlarged.
#pragma once
#include <functional>

#include "film/film.h"
#include "image/image.h"

namespace drc {

// Denoises color in place. All images have one size.
using ImageDenoiser = std::function<void(Image& color, const Image& albedo, const Image& normal)>;

// Denoises a picture of the film's region, in place. For a film with a whole sample in every pixel, that is one call of
// the denoiser.
void denoiseByLattices(Image& color, const Image& albedo, const Image& normal, const Film& film,
                       const ImageDenoiser& denoise);

}  // namespace drc
