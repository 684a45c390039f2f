// Training examples in the format of the method's authors: a folder per scene, with four PFM files per viewpoint, named
// by the pixel: d_X_Y.pfm (radiance, one sample per texel), n_X_Y.pfm (normals), z_X_Y.pfm (distances, one channel) and
// p_X_Y.pfm (the target). Where a ray hit nothing, the distance is -1 and the normal zero. The folder also contains a
// train.json, which is not needed for reading. Maps are latlong (projection.h), 32 x 32; the pole row, v = 0, is at the
// top of the image. Normals are in the map's frame.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "maps/example_source.h"
#include "maps/shard_format.h"

namespace drc {

// Whether a file name has the form "d_12_34.pfm", where d may also be n, z or p.
bool isIisptFile(std::string_view name);

// The examples of a folder, with one realisation each, in row-major order over the film. Every load reads the files
// again. The scene's name is the folder's name.
//
// Two deviations in older files are corrected: floats in the opposite byte order to the one that the file's header
// states, and normals that face away from the map's origin, which are flipped.
class IisptFolder final : public ExampleSource {
  public:
    // Reads all files. A viewpoint is left out and reported by damage() if one of its four files is missing, or if they
    // differ in size or contain values that are impossible in a capture. Throws Error if the path is not a folder with
    // such files.
    explicit IisptFolder(const std::string& path);

    void load(int index, int first, int count, TrainingExample& example) const override;
    std::string contentHash() const override { return hash_; }

  private:
    struct Pixel {
        int x, y;
    };
    // Hash of the viewpoint's files; none if the example is unusable.
    std::optional<uint64_t> check(const Pixel& pixel) const;
    void read(const Pixel& pixel, TrainingExample& example, uint64_t* hash) const;

    std::vector<Pixel> pixels_;
    std::string hash_;
};

// Writes such a folder, or completes an existing one.
class IisptWriter {
  public:
    // Creates the folder and stores the header in its train.json. Throws Error, beginning with the path, if the folder
    // exists with other settings or from another program.
    IisptWriter(const std::string& path, const ShardHeader& header);

    // Whether the viewpoint at this film position has been written.
    bool has(const Vec2& film) const;
    // Writes the target and the first input of the example. Several threads may write different pixels at the same
    // time.
    void write(const TrainingExample& example) const;

  private:
    std::string path_;
    MapLayout layout_;
};

}  // namespace drc
