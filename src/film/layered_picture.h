// A picture as the sum of its layers, with the G-buffer and variance that denoisers and compositing need. All images
// have the size of the film's region; radiance is linear RGB times the film's scale.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "film/film.h"
#include "image/image.h"
#include "transport/g_buffer_sample.h"

namespace drc {

struct PictureLayer {
    std::string name;
    // The part of the picture that this layer is added to: "direct" or "indirect". Empty: it has light of both.
    std::string part;
    Image mean;                     // may be negative, where the pixel filter has negative lobes
    std::optional<Image> variance;  // of the mean, for R, G and B, from the differences between groups of samples
};

// The G-buffer: means of GBufferSample over a pixel's samples; zero where no surface is seen.
struct GBuffer {
    Image albedo;  // RGB, in [0, 1]
    Image normal;  // X, Y, Z, world space; shorter than 1 where a pixel shows several surfaces
    Image depth;   // Z, world units
    // The root mean square, over the pixels, of the standard error of albedo and normal, taken as one vector. Large
    // where depth of field, motion, reflections or mere edges meet few samples.
    float noise = 0;
};

struct LayeredPicture {
    std::shared_ptr<const Film> film;  // that the picture was made from
    // Whether filters take every pixel as sampled, whatever the film says: to measure how long they will take.
    bool takenAsComplete = false;
    float scale = 1;  // the film's, already applied to all images
    std::vector<PictureLayer> layers;
    Image beauty;  // the sum of the layers, clamped at zero; denoisers may replace it
    std::optional<GBuffer> gBuffer;
    // Direct light (SampleParts::direct), of the same samples as the layers; for pictures whose layers have light of
    // both parts.
    std::optional<Image> direct;
    // A: the share of each pixel that is covered (GBufferSample::covered), in [0, 1]; with a transparent film. The
    // colours are premultiplied by it.
    std::optional<Image> alpha;
    std::optional<Image> samples;  // X: number of camera samples; present if a layer has variance
    std::optional<Image> error;    // X: DenoisedError::local, if it was estimated

    PictureLayer& layer(const std::string& name);
    // Whether direct and indirect light can be told apart.
    bool hasParts() const { return direct || (!layers.empty() && !layers[0].part.empty()); }
    // "direct", "indirect", or "" for all: parts of the sum of the layers.
    Image part(const std::string& name) const;
    // Variance of the sum of the layers.
    Image variance() const;
    // part() and variance() of one pixel, counted from the region's corner.
    Rgb partAt(const std::string& name, int x, int y) const;
    Rgb varianceAt(int x, int y) const;
    // Sets beauty to the sum of the layers.
    void compose();
    // Maps the colours of the layers and of the beauty, which is clamped at zero again. Variances become upper bounds.
    // For the finished picture: filters compare it with the film, which stays as it is.
    void balance(const RgbMatrix& matrix);
};

// Maps the colours of a beauty and clamps them at zero.
void balanceBeauty(Image& beauty, const RgbMatrix& matrix);

// Makes a picture's layer from a film's layer: means, and the variance of the mean if there are several groups.
PictureLayer pictureLayer(const Film& film, const std::string& name, const std::string& part, float scale);

// The film's layer that GBufferSamples are added to: albedo, normal, depth, and the squared length of albedo and normal
// as one vector, from which follows how noisy they are.
inline constexpr const char* kGBufferLayer = "g-buffer";
void addGBufferSpec(std::vector<FilmLayerSpec>& layers, int groups = 1);
void addGBufferSample(FilmLayer& layer, int x, int y, const GBufferSample& sample, float filterWeight, int group = 0);
// The G-buffer from that layer, of all samples or, where a pixel has any, of those of a group alone.
GBuffer gBufferOf(const Film& film, std::optional<int> group = {});
// LayeredPicture::alpha from a layer of one channel.
Image alphaOf(const FilmLayer& layer);
float alphaAt(const FilmLayer& layer, int x, int y);
// X: the number of samples in each pixel of a layer.
Image sampleCounts(const FilmLayer& layer);

}  // namespace drc
