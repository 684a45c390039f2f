// The state of a render: for each pixel sums over samples, in named layers, and for each row of pixels the number of
// sample passes that it has had. Sums commute: films of different samples of one picture add up, in any order, to the
// film of all of them (exact layers to the bit, others to rounding), and a film that was saved and loaded continues
// where it was.
#pragma once
#include <atomic>
#include <memory>
#include <mutex>

#include "base/state_file.h"
#include "film/film_layer.h"

namespace drc {

class Film {
  public:
    // Throws Error, naming the film's place in the scene's file, if a picture of these layers does not fit into memory:
    // the film, and what it takes to finish it.
    static void requireMemory(const RenderSettings& settings, const std::vector<FilmLayerSpec>& layers);

    // Throws Error, naming the film's place in the scene's file, if the layers do not fit into memory.
    Film(const RenderSettings& settings, std::vector<FilmLayerSpec> layers);

    const PixelRegion& region() const { return region_; }
    // Layers by index, in the order of the specs, or by name, which throws std::out_of_range if there is no such layer.
    size_t layerCount() const { return layers_.size(); }
    FilmLayer& layer(size_t i) { return layers_[i]; }
    const FilmLayer& layer(size_t i) const { return layers_[i]; }
    FilmLayer& layer(std::string_view name);
    const FilmLayer& layer(std::string_view name) const { return const_cast<Film*>(this)->layer(name); }
    bool has(std::string_view name) const;
    size_t bytesPerPixel() const;

    // Must be held while adding to a row of pixels, or while reading it when others may add. Not needed for splats.
    std::unique_lock<std::mutex> lockRow(int y) const { return std::unique_lock(rowMutexes_[size_t(y - region_.y0)]); }

    // The number of sample passes (SamplePass) that a row has had. These counts may be read while others change them.
    int rowPasses(int y) const { return shared(rowPasses_[size_t(y - region_.y0)]).load(std::memory_order_relaxed); }
    void setRowPasses(int y, int passes) {
        shared(rowPasses_[size_t(y - region_.y0)]).store(passes, std::memory_order_relaxed);
    }
    // The number of passes that every row has had.
    int passes() const;
    // The number of complete map passes.
    int mapPasses() const { return shared(mapPasses_).load(std::memory_order_relaxed); }
    void setMapPasses(int passes) { shared(mapPasses_).store(passes, std::memory_order_relaxed); }

    // Removes all samples.
    void clear();
    // A copy of a part of the region, or of all of it. Safe while others add under lockRow.
    std::shared_ptr<const Film> snapshot() const { return snapshot(region_); }
    std::shared_ptr<const Film> snapshot(const PixelRegion& part) const;
    // Adds another film's sums, as if all of its samples had been taken here. The films must have had different samples
    // (RenderParams::firstSample); their complete passes are counted together. Throws Error if the films do not have
    // the same layers and region.
    void add(const Film& other);

    // Writes the film to a file, whole or not at all, and reads it back. identity: describes what was rendered (scene,
    // camera, settings). load throws Error, and changes nothing, if the file's identity, layers or region differ, or if
    // it is damaged.
    void save(const std::string& path, const std::string& identity) const;
    void load(const std::string& path, const std::string& identity);
    // Write and read the film as the last part of a larger file, whose header must contain description().
    void save(StateWriter& to) const;
    void load(StateReader& from);
    // Region, layers and identity in words, the latter as a hash.
    std::string description(const std::string& identity) const;

  private:
    Film(const Film& other, const PixelRegion& part);
    static std::atomic_ref<int32_t> shared(const int32_t& count) {
        return std::atomic_ref(const_cast<int32_t&>(count));
    }

    PixelRegion region_;
    std::vector<FilmLayer> layers_;
    std::vector<int32_t> rowPasses_;
    std::unique_ptr<std::mutex[]> rowMutexes_;
    int32_t mapPasses_ = 0;
};

}  // namespace drc
