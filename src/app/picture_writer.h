// Encodes and writes the pictures of a render.
#pragma once
#include <string>
#include <vector>

#include "image/image_io.h"
#include "render/layered_picture.h"

namespace drc {

enum class OutputKind { Exr, Png };
// By the extension. Throws Error on any other.
OutputKind outputKind(const std::string& path);
// Before the work, not after it: a wrong extension, a folder that is missing. option: that named the path.
void checkOutput(const std::string& option, const std::string& path);

class PictureWriter {
  public:
    PictureWriter(const RenderSettings& settings, std::vector<std::string> outputs, bool aovs)
        : settings_(settings), outputs_(std::move(outputs)), aovs_(aovs) {}

    // Encodes the picture for every output: the bytes of each file.
    std::vector<std::string> encode(const LayeredPicture& picture, const ExrMetadata& metadata) const;
    // Writes what encode() gave, each file whole or not at all.
    void write(const std::vector<std::string>& files) const;
    const std::vector<std::string>& outputs() const { return outputs_; }

    // For a render that was interrupted with so many samples a pixel: a file that may be the better picture is not
    // replaced, NAME.interrupted.EXT is written beside it. It may be better unless its metadata has fewer samples.
    void divertFromBetterPictures(int samples);

  private:
    RenderSettings const& settings_;
    std::vector<std::string> outputs_;
    bool aovs_;
};

}  // namespace drc
