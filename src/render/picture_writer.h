// Encodes and writes the pictures of a render.
#pragma once
#include <string>
#include <vector>

#include "film/layered_picture.h"
#include "image/display.h"
#include "image/frame_geometry.h"
#include "image/image_io.h"

namespace drc {

enum class OutputKind { Exr, Png };
// The kind of file by its extension. Throws Error on any other extension.
OutputKind outputKind(const std::string& path);
// Throws Error if the file cannot be written (write_probe.h), before any work is done for it. option: the option that
// names the path, or the place in a file.
void checkOutput(const std::string& option, const std::string& path);

class PictureWriter {
  public:
    // settings: must outlive the writer. scene: the scene's file, beside which pictures are written that cannot be
    // written at their own place.
    PictureWriter(const RenderSettings& settings, std::vector<std::string> outputs, bool aovs = false,
                  const DisplaySettings& display = {}, std::string scene = "")
        : settings_(settings), outputs_(std::move(outputs)), aovs_(aovs), display_(display), scene_(std::move(scene)) {}

    // Adds the camera, and where the objects are, to EXR files.
    void setGeometry(FrameGeometry geometry) { geometry_ = std::move(geometry); }

    // Encodes the picture for every output and returns the bytes of each file: EXR files with linear radiance, PNG
    // files according to the display settings. All files contain the metadata, including displayMetadata() of the
    // picture.
    std::vector<std::string> encode(const LayeredPicture& picture, const ExrMetadata& metadata) const;
    // Writes the files that encode() returned, each whole or not at all. A file that cannot be written at its place is
    // written to another, which outputs() then returns, or is left out (rescued_file.h); an error message says so. The
    // other files are written all the same.
    void write(const std::vector<std::string>& files);
    // Whether all files were written where the user wanted them.
    bool allInPlace() const { return allInPlace_; }
    const std::vector<std::string>& outputs() const { return outputs_; }
    const RenderSettings& settings() const { return settings_; }

    // For a render that was interrupted after this many samples per pixel: keeps existing files that may be better
    // pictures, and writes NAME.interrupted.EXT beside them instead, or NAME.interrupted-2.EXT if that may be better
    // too. A file may be better unless its metadata has fewer samples.
    void divertFromBetterPictures(int samples);

  private:
    RenderSettings const& settings_;
    std::vector<std::string> outputs_;
    bool aovs_;
    DisplaySettings display_;
    std::string scene_;
    std::optional<FrameGeometry> geometry_;
    bool allInPlace_ = true;
};

// The metadata that PNG files keep: all except empty entries and command lines, because PNG files are shown around.
PngTexts pngTexts(const ExrMetadata& metadata);

}  // namespace drc
