// Denoises pictures whose first sample is not complete (SamplePass): in parts of such a picture, only every second or
// fourth pixel of every second or fourth row has a sample. Noise there is two or four pixels wide, and a denoiser would
// leave it. So those parts are denoised as a smaller picture, and enlarged.
#pragma once
#include <functional>

#include "film/film.h"
#include "image/image.h"

namespace drc {

// Denoises color in place. All images have one size.
using ImageDenoiser = std::function<void(Image& color, const Image& albedo, const Image& normal)>;

// Denoises a picture of the film's region, in place. If every pixel has a whole sample, this calls the denoiser once.
void denoiseByLattices(Image& color, const Image& albedo, const Image& normal, const Film& film,
                       const ImageDenoiser& denoise);

}  // namespace drc
