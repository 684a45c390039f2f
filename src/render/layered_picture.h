// A picture by the layers that it is the sum of, with what denoisers and compositing need. All images have the size of
// the film's region; radiance is linear RGB times the film's scale.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "integrators/path_sinks.h"
#include "render/film.h"

namespace drc {

struct PictureLayer {
    std::string name;
    std::string part;  // "direct" or "indirect": what it belongs to in files; empty: the picture has no parts
    Image mean;        // may be below zero, by filters with negative lobes
    std::optional<Image> variance;  // of the mean, R, G and B, from half buffers or groups of samples
};

// Of what each pixel shows, as GBufferSample defines it: means over the samples; zero where there is no surface.
struct GBuffer {
    Image albedo;  // RGB, in [0, 1]
    Image normal;  // X, Y, Z, world space; shorter than 1 where a pixel shows several surfaces
    Image depth;   // Z, world units
};

struct LayeredPicture {
    std::shared_ptr<const Film> film;  // that it was made of
    float scale = 1;                   // of the film
    std::vector<PictureLayer> layers;
    Image beauty;  // their sum, nowhere below zero; filters may replace it by something better
    std::optional<GBuffer> gBuffer;
    std::optional<Image> samples;  // X: number of camera samples; there if a layer has variance

    PictureLayer& layer(const std::string& name);
    // The sum of the layers of a part.
    Image part(const std::string& name) const;
    // Variance of the sum of the layers.
    Image variance() const;
    // Sets beauty to the sum of the layers.
    void compose();
};

// The picture's layer of a film's layer: means, and variances where it has several groups.
PictureLayer pictureLayer(const Film& film, const std::string& name, const std::string& part, float scale);

// The film's layer that GBufferSamples are added to: albedo, normal, depth.
inline constexpr const char* kGBufferLayer = "g-buffer";
void addGBufferSpec(std::vector<FilmLayerSpec>& layers);
void addGBufferSample(FilmLayer& layer, int x, int y, const GBufferSample& sample, float filterWeight);
// Sets picture.gBuffer from it.
void addGBuffer(LayeredPicture& picture);
// X: the number of samples that a layer has had in each pixel.
Image sampleCounts(const FilmLayer& layer);

}  // namespace drc
