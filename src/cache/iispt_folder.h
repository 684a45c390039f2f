// Examples as the method's authors store them: a folder for each scene, with four PFM files for each viewpoint, named
// by its pixel: d_X_Y.pfm (light, one sample a texel), n_X_Y.pfm (normals), z_X_Y.pfm (distances, one channel; -1 and a
// zero normal where nothing was hit), p_X_Y.pfm (the target), and a train.json that nothing depends on. Maps are
// latlong (projection.h), 32 x 32; the row at the pole, v = 0, is on top. Normals are in the map's frame.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "cache/example_source.h"
#include "cache/shard_format.h"

namespace drc {

// "d_12_34.pfm", and so on with n, z and p.
bool isIisptFile(std::string_view name);

// Examples with one realisation, row by row over the film. The files are read anew for each load. The scene is called
// as the folder is.
//
// Two habits of older files are understood: floats whose byte order is not the one that the file names, and normals
// that face away from the map's origin, which are turned, as ours never do.
class IisptFolder final : public ExampleSource {
  public:
    // Reads every file. Viewpoints that lack one of the four, or whose files are not of one size or hold what no
    // capture yields, are left out, see damage(). Throws Error if it is no such folder.
    explicit IisptFolder(const std::string& path);

    void load(int index, int first, int count, TrainingExample& example) const override;
    std::string contentHash() const override { return hash_; }

  private:
    struct Pixel {
        int x, y;
    };
    // Hash of the files, or nothing if the example cannot be used.
    std::optional<uint64_t> check(const Pixel& pixel) const;
    void read(const Pixel& pixel, TrainingExample& example, uint64_t* hash) const;

    std::vector<Pixel> pixels_;
    std::string hash_;
};

// Writes such a folder, or what is missing of it.
class IisptWriter {
  public:
    // Makes the folder. Its train.json keeps the header: a folder that was made with other settings, or by another
    // program, is refused. Throws Error that begins with the path.
    IisptWriter(const std::string& path, const ShardHeader& header);

    // Whether the viewpoint at this place of the film is there.
    bool has(const Vec2& film) const;
    // The first input of the example and its target. By any number of threads, for different pixels.
    void write(const TrainingExample& example) const;

  private:
    std::string path_;
    MapLayout layout_;
};

}  // namespace drc
