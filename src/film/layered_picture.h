// A picture as the sum of its layers, with the G-buffer and the variance that denoisers and compositing need. All
// images have the size of the film's region; radiance is linear RGB multiplied by the film's scale.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "film/film.h"
#include "film/surface_layers.h"
#include "image/image.h"
#include "transport/g_buffer_sample.h"

namespace drc {

struct PictureLayer {
    std::string name;
    // The kind of light in this layer, "direct" or "indirect". Empty: the layer contains both.
    std::string part;
    Image mean;                     // may be negative where the pixel filter has negative lobes
    std::optional<Image> variance;  // variance of the mean, for R, G and B, from the differences between groups
};

// The G-buffer: means of GBufferSample over a pixel's samples; zero where the camera sees no surface.
struct GBuffer {
    Image albedo;  // RGB, in [0, 1]
    Image normal;  // X, Y, Z, world space; length below 1 where a pixel shows several orientations
    Image depth;   // Z, world units
    // Noise of albedo and normal together, as a vector of six components: root mean square over the pixels of the
    // standard error of its mean. Large where few samples meet depth of field, motion, reflections or just edges.
    float noise = 0;
};

// Two independent pictures of half of the samples each, RGB. A pixel without samples in one half has the mean of all
// its samples there.
struct HalfBuffers {
    Image halves[2];
};

struct LayeredPicture {
    std::shared_ptr<const Film> film;  // the film that the picture was made from
    // Makes filters treat every pixel as sampled, whatever the film says. Used to measure how long they will take at
    // the end.
    bool takenAsComplete = false;
    float scale = 1;  // the film's scale; all images are already multiplied by it
    std::vector<PictureLayer> layers;
    Image beauty;  // sum of the layers, clamped at zero; denoisers may replace it
    std::optional<GBuffer> gBuffer;
    // Direct light (SampleParts::direct), from the same samples as the layers. Set in pictures whose layers each
    // contain both direct and indirect light.
    std::optional<Image> direct;
    // Set with RenderParams::surfaces; the halves of the picture and of the direct light also need independentHalves.
    std::optional<SurfaceLayers> surfaces;
    std::optional<HalfBuffers> halves, directHalves;
    // A: coverage of each pixel (GBufferSample::covered), in [0, 1]. Set with a transparent film. The colours
    // are premultiplied by it.
    std::optional<Image> alpha;
    std::optional<Image> samples;  // X: number of camera samples; present if a layer has variance
    std::optional<Image> error;    // X: DenoisedError::local, if estimated

    PictureLayer& layer(const std::string& name);
    // Whether direct and indirect light are available separately.
    bool hasParts() const { return direct || (!layers.empty() && !layers[0].part.empty()); }
    // The light of one part, "direct" or "indirect", or of the whole picture (""), as sums of layers.
    Image part(const std::string& name) const;
    // Variance of the sum of the layers.
    Image variance() const;
    // part() and variance() at one pixel; x and y count from the corner of the region.
    Rgb partAt(const std::string& name, int x, int y) const;
    Rgb varianceAt(int x, int y) const;
    // Sets beauty to the sum of the layers.
    void compose();
    // Applies a colour matrix to the layers and to the beauty image, which is clamped at zero again. Variances become
    // upper bounds. Call it after all filters, because they compare the picture with the film, whose colours stay
    // unchanged.
    void balance(const RgbMatrix& matrix);
};

// Applies a colour matrix to a beauty image and clamps the result at zero.
void balanceBeauty(Image& beauty, const RgbMatrix& matrix);

// Makes a picture layer from a film layer: means, and the variance of the mean if there are several groups.
PictureLayer pictureLayer(const Film& film, const std::string& name, const std::string& part, float scale);

// The halves of a film layer with two groups. scale: factor on all values.
HalfBuffers halvesOf(const FilmLayer& layer, float scale);

// The film layer that GBufferSamples are added to. Channels: albedo, normal, depth, and |albedo|^2 + |normal|^2, from
// which GBuffer::noise is computed.
inline constexpr const char* kGBufferLayer = "g-buffer";
void addGBufferSpec(std::vector<FilmLayerSpec>& layers, int groups = 1);
void addGBufferSample(FilmLayer& layer, int x, int y, const GBufferSample& sample, float filterWeight, int group = 0);
// Makes the G-buffer from that film layer. With a group, pixels that have samples in this group use only those.
GBuffer gBufferOf(const Film& film, std::optional<int> group = {});
// LayeredPicture::alpha from a film layer with one channel.
Image alphaOf(const FilmLayer& layer);
float alphaAt(const FilmLayer& layer, int x, int y);
// X: the number of samples of each pixel in a film layer.
Image sampleCounts(const FilmLayer& layer);

}  // namespace drc
