// What a render has found out: sums over samples for each pixel, in named layers, and which samples each row of pixels
// has had. All of it commutes: films of different samples of one picture add up to the film of all of them, in any
// order, and a film that was saved goes on where it was.
#pragma once
#include <memory>
#include <mutex>

#include "render/film_layer.h"

namespace drc {

class Film {
  public:
    // Throws Error, naming the film's place in the scene's file, if the layers do not fit into memory.
    Film(const RenderSettings& settings, std::vector<FilmLayerSpec> layers);

    const PixelRegion& region() const { return region_; }
    // In the order of the specs; or by name, for which it throws std::out_of_range if there is none.
    size_t layerCount() const { return layers_.size(); }
    FilmLayer& layer(size_t i) { return layers_[i]; }
    const FilmLayer& layer(size_t i) const { return layers_[i]; }
    FilmLayer& layer(std::string_view name);
    const FilmLayer& layer(std::string_view name) const { return const_cast<Film*>(this)->layer(name); }
    bool has(std::string_view name) const;
    size_t bytesPerPixel() const;

    // Held by whoever adds to a row of pixels, or reads it while others may add. Not needed for splats.
    std::unique_lock<std::mutex> lockRow(int y) const { return std::unique_lock(rowMutexes_[size_t(y - region_.y0)]); }

    // How far sampling is (SamplePass): for each row the number of passes that it has had.
    int rowPasses(int y) const { return rowPasses_[size_t(y - region_.y0)]; }
    void setRowPasses(int y, int passes) { rowPasses_[size_t(y - region_.y0)] = passes; }
    // That all rows have had.
    int passes() const;
    // Passes of radiance maps that are whole.
    int mapPasses = 0;

    // Forgets all samples.
    void clear();
    // A copy of the pixels of a part of the region; of all without one. Safe beside whoever adds under lockRow.
    std::shared_ptr<const Film> snapshot() const { return snapshot(region_); }
    std::shared_ptr<const Film> snapshot(const PixelRegion& part) const;
    // As if all samples of the other had been taken here. The films must have had different samples
    // (RenderParams::firstSample); passes that are whole in both count together. Throws Error if the films do not have
    // the same layers and region.
    void add(const Film& other);

    // A file of this film: all or nothing. identity: of what was rendered (scene, camera, settings); load throws Error
    // if the file's differs, if its layers or region differ, or if it is damaged. Nothing changes if it throws.
    void save(const std::string& path, const std::string& identity) const;
    void load(const std::string& path, const std::string& identity);

  private:
    Film(const Film& other, const PixelRegion& part);
    std::string header(const std::string& identity) const;

    PixelRegion region_;
    std::vector<FilmLayer> layers_;
    std::vector<int32_t> rowPasses_;
    std::unique_ptr<std::mutex[]> rowMutexes_;
};

}  // namespace drc
