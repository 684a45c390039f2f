#include "reconstruct/lattice_denoiser.h"

#include <algorithm>

#include "film/sample_pass.h"

namespace drc {
namespace {

// Every `step`th pixel of an image.
Image latticeOf(const Image& image, int step) {
    Image lattice((image.width() + step - 1) / step, (image.height() + step - 1) / step, image.channelNames());
    for (int y = 0; y < lattice.height(); ++y)
        for (int x = 0; x < lattice.width(); ++x)
            std::copy_n(image.pixel(x * step, y * step), image.channels(), lattice.pixel(x, y));
    return lattice;
}

// Sets a row of a picture of twice the size, interpolated between the pixels that both pictures have.
void enlargeRow(const Image& half, int y, Image& whole) {
    const int above = y / 2, below = std::min(above + y % 2, half.height() - 1);
    for (int x = 0; x < whole.width(); ++x) {
        const int left = x / 2, right = std::min(left + x % 2, half.width() - 1);
        for (int c = 0; c < whole.channels(); ++c)
            whole.at(x, y, c) = 0.25f * (half.at(left, above, c) + half.at(right, above, c) + half.at(left, below, c) +
                                         half.at(right, below, c));
    }
}

}  // namespace

void denoiseByLattices(Image& color, const Image& albedo, const Image& normal, const Film& film,
                       const ImageDenoiser& denoise) {
    const int first = std::min(std::max(film.passes() - 1, 0), SamplePass::kLattices - 1);
    Image coarser;
    for (int lattice = first; lattice < SamplePass::kLattices; ++lattice) {
        const int step = SamplePass::stepOf(lattice);
        const bool whole = step == 1;
        Image picture = whole ? std::move(color) : latticeOf(color, step);
        // The rows without samples on this lattice yet. They are interpolated from the coarser lattice: first as
        // neighbours for the denoiser, and again in the result.
        std::vector<int> missing;
        if (!coarser.empty())
            for (int y = 0; y < picture.height(); ++y)
                if (film.rowPasses(film.region().y0 + y * step) <= lattice) missing.push_back(y);
        const auto fillMissing = [&] {
            for (const int y : missing) enlargeRow(coarser, y, picture);
        };
        fillMissing();
        if (int(missing.size()) < picture.height()) {
            if (whole)
                denoise(picture, albedo, normal);
            else
                denoise(picture, latticeOf(albedo, step), latticeOf(normal, step));
            fillMissing();
        }
        coarser = std::move(picture);
    }
    color = std::move(coarser);
}

}  // namespace drc
