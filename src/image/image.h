// An image in memory: interleaved float channels with names, the first row at the top.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "math/vec.h"

namespace drc {

class Image {
  public:
    Image() = default;
    // Filled with zeros. Channel names as in OpenEXR: "R", "normal.X". Throws Error if the size is not positive, if
    // there are no channels, or if a name repeats.
    Image(int width, int height, std::vector<std::string> channelNames);
    // R, G, B.
    Image(int width, int height) : Image(width, height, {"R", "G", "B"}) {}

    int width() const { return width_; }
    int height() const { return height_; }
    int channels() const { return static_cast<int>(names_.size()); }
    size_t pixelCount() const { return size_t(width_) * size_t(height_); }
    bool empty() const { return data_.empty(); }
    const std::vector<std::string>& channelNames() const { return names_; }
    // -1 if there is none of that name.
    int channelIndex(const std::string& name) const;

    // Not checked: 0 <= x < width(), 0 <= y < height(), 0 <= c < channels().
    float& at(int x, int y, int c) { return data_[index(x, y) + size_t(c)]; }
    float at(int x, int y, int c) const { return data_[index(x, y) + size_t(c)]; }
    float* pixel(int x, int y) { return &data_[index(x, y)]; }
    const float* pixel(int x, int y) const { return &data_[index(x, y)]; }
    // The first three channels; a grey image (one or two channels) gives its first channel thrice.
    Rgb rgb(int x, int y) const {
        const float* p = pixel(x, y);
        return channels() < 3 ? Rgb(p[0], p[0], p[0]) : Rgb(p[0], p[1], p[2]);
    }
    // Needs at least three channels.
    void setRgb(int x, int y, const Rgb& c) {
        float* p = pixel(x, y);
        p[0] = c.x, p[1] = c.y, p[2] = c.z;
    }

    std::vector<float>& data() { return data_; }
    const std::vector<float>& data() const { return data_; }

    // The part [x0, x1) x [y0, y1). Throws Error if it is empty or reaches outside.
    Image crop(int x0, int y0, int x1, int y1) const;
    // Three channels R, G, B as rgb() gives them: alpha and other channels are dropped.
    Image toRgb() const;

  private:
    size_t index(int x, int y) const { return (size_t(y) * size_t(width_) + size_t(x)) * names_.size(); }

    int width_ = 0, height_ = 0;
    std::vector<std::string> names_;
    std::vector<float> data_;
};

// "640x480", for messages.
std::string sizeString(const Image& image);

// Throws Error, naming both sizes, if they differ or an image is empty.
void requireSameSize(const Image& reference, const Image& test);

}  // namespace drc
