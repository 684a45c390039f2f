// Training examples in the format of the method's authors: a folder per scene, with four PFM files per viewpoint, named
// by the pixel: d_X_Y.pfm (radiance, one sample per texel), n_X_Y.pfm (normals), z_X_Y.pfm (distances, one channel; -1,
// and a zero normal, where nothing was hit) and p_X_Y.pfm (the target). There is also a train.json, which is not needed
// to read them. Maps are latlong (projection.h), 32 x 32, with the row at the pole, v = 0, at the top of the image.
// Normals are in the map's frame.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "maps/example_source.h"
#include "maps/shard_format.h"

namespace drc {

// Whether a file name has the form "d_12_34.pfm", or the same with n, z or p.
bool isIisptFile(std::string_view name);

// The examples of a folder, with one realisation each, in row-major order over the film. Files are read again for each
// load. The scene's name is that of the folder.
//
// Two deviations in older files are corrected: floats in the byte order opposite to that in the file's header, and
// normals that face away from the map's origin, which are flipped.
class IisptFolder final : public ExampleSource {
  public:
    // Reads every file. Viewpoints that lack one of the four files, or whose files differ in size or contain values
    // that no capture gives, are left out and reported by damage(). Throws Error if the path is no such folder.
    explicit IisptFolder(const std::string& path);

    void load(int index, int first, int count, TrainingExample& example) const override;
    std::string contentHash() const override { return hash_; }

  private:
    struct Pixel {
        int x, y;
    };
    // Hash of the pixel's files; none if the example cannot be used.
    std::optional<uint64_t> check(const Pixel& pixel) const;
    void read(const Pixel& pixel, TrainingExample& example, uint64_t* hash) const;

    std::vector<Pixel> pixels_;
    std::string hash_;
};

// Writes such a folder, or the missing part of one.
class IisptWriter {
  public:
    // Creates the folder, and keeps the header in its train.json. Throws Error, beginning with the path, if the folder
    // exists and was made with other settings or by another program.
    IisptWriter(const std::string& path, const ShardHeader& header);

    // Whether the viewpoint at this film position has been written.
    bool has(const Vec2& film) const;
    // Writes the first input of the example and its target. Several threads may write different pixels at the same
    // time.
    void write(const TrainingExample& example) const;

  private:
    std::string path_;
    MapLayout layout_;
};

}  // namespace drc
