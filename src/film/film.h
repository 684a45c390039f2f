// The state of a render: sums over samples for each pixel, in named layers, and the number of completed sample passes
// for each row of pixels. Sums commute: adding films of different samples of one picture, in any order, gives the film
// of all their samples (exact layers to the bit, others up to rounding). A film that was saved and loaded continues
// where it stopped.
#pragma once
#include <atomic>
#include <memory>
#include <mutex>

#include "base/state_file.h"
#include "film/film_layer.h"

namespace drc {

class Film {
  public:
    // Throws Error, with the location of the film in the scene file, if memory cannot hold both a film of these layers
    // and the buffers that finishing the picture needs.
    static void requireMemory(const RenderSettings& settings, const std::vector<FilmLayerSpec>& layers);

    // Throws Error like requireMemory().
    Film(const RenderSettings& settings, std::vector<FilmLayerSpec> layers);

    const PixelRegion& region() const { return region_; }
    // Layers by index, in the order of the specs, or by name; an unknown name throws std::out_of_range.
    size_t layerCount() const { return layers_.size(); }
    FilmLayer& layer(size_t i) { return layers_[i]; }
    const FilmLayer& layer(size_t i) const { return layers_[i]; }
    FilmLayer& layer(std::string_view name);
    const FilmLayer& layer(std::string_view name) const { return const_cast<Film*>(this)->layer(name); }
    bool has(std::string_view name) const;
    size_t bytesPerPixel() const;

    // Hold this lock while adding to a row of pixels, or while reading it if other threads may add. Splats need no
    // lock.
    std::unique_lock<std::mutex> lockRow(int y) const { return std::unique_lock(rowMutexes_[size_t(y - region_.y0)]); }

    // The number of sample passes (SamplePass) that a row has completed. Threads may read and set it concurrently.
    int rowPasses(int y) const { return shared(rowPasses_[size_t(y - region_.y0)]).load(std::memory_order_relaxed); }
    void setRowPasses(int y, int passes) {
        shared(rowPasses_[size_t(y - region_.y0)]).store(passes, std::memory_order_relaxed);
    }
    // The number of passes that all rows have completed.
    int passes() const;
    // The number of complete map passes.
    int mapPasses() const { return shared(mapPasses_).load(std::memory_order_relaxed); }
    void setMapPasses(int passes) { shared(mapPasses_).store(passes, std::memory_order_relaxed); }

    // Removes all samples.
    void clear();
    // Copies a part of the region, or all of it. Safe while other threads add under lockRow().
    std::shared_ptr<const Film> snapshot() const { return snapshot(region_); }
    std::shared_ptr<const Film> snapshot(const PixelRegion& part) const;
    // Adds another film's sums, as if all its samples had been taken for this film. The two films must hold different
    // samples (RenderParams::firstSample). Their numbers of complete samples and of map passes add up. Throws Error if
    // the films differ in layers or region.
    void add(const Film& other);

    // Save the film to a file, whole or not at all, and load it again. identity: describes what was rendered (scene,
    // camera, settings). load() throws Error, and leaves the film unchanged, if the file is damaged or if its identity,
    // layers or region differ.
    void save(const std::string& path, const std::string& identity) const;
    void load(const std::string& path, const std::string& identity);
    // Save and load the film as the last part of a larger file, whose header must contain description().
    void save(StateWriter& to) const;
    void load(StateReader& from);
    // The region and the layers as text, and a hash of the identity.
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
