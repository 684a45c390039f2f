#include "render/frame_window.h"

#include "image/picture_window.h"
#include "reconstruct/temporal_filter.h"

namespace drc {
namespace {

TemporalFrame lightOf(const LayeredPicture& picture, const FrameGeometry& geometry, const FilmGeometry& film,
                      std::string name) {
    const PixelRegion& region = picture.film->region();
    TemporalFrame frame;
    frame.surfaces = {.name = std::move(name),
                      .albedo = picture.gBuffer.value().albedo,
                      .normal = picture.gBuffer->normal,
                      .position = picture.surfaces.value().position,
                      .depth = picture.surfaces->depth,
                      .object = picture.surfaces->object,
                      .geometry = geometry,
                      .window = {region.x0, region.y0, film.width, film.height}};
    for (size_t half = 0; half < 2; ++half) {
        frame.direct[half] = picture.halves.value().halves[half];
        if (!picture.directHalves) continue;
        frame.indirect[half] = std::move(frame.direct[half]);
        frame.direct[half] = picture.directHalves->halves[half];
        for (size_t i = 0; i < frame.direct[half].data().size(); ++i)
            frame.indirect[half].data()[i] -= frame.direct[half].data()[i];
    }
    return frame;
}

// Puts averaged light in place of the picture's own.
void replaceLight(LayeredPicture& picture, const FilteredFrame& light) {
    picture.layers.clear();
    picture.layers.push_back({"averaged over time", "", light.beauty(), light.variance()});
    if (!light.indirect[0].empty()) picture.direct = light.directLight();
    for (size_t half = 0; half < 2; ++half) {
        picture.halves->halves[half] = light.half(half);
        if (picture.directHalves) picture.directHalves->halves[half] = light.direct[half];
    }
    picture.compose();
}

}  // namespace

void FrameWindow::add(LayeredPicture picture, const FrameGeometry& geometry, const FilmGeometry& film, std::string name,
                      Finish finish) {
    TemporalFrame light = lightOf(picture, geometry, film, std::move(name));
    if (!frames_.empty()) {
        const FrameSurfaces &first = frames_.front().light.surfaces, &its = light.surfaces;
        requireSamePlace({first.name, first.albedo, first.window}, {its.name, its.albedo, its.window},
                         "averaged over time");
    }
    frames_.push_back({std::move(picture), std::move(light), std::move(finish)});
    while (finished_ + size_t(kRadius) < frames_.size()) this->finish(finished_);
    while (finished_ > size_t(kRadius)) {
        frames_.pop_front();
        --finished_;
    }
}

void FrameWindow::end() {
    while (finished_ < frames_.size()) finish(finished_);
    frames_.clear();
    finished_ = 0;
}

void FrameWindow::finish(size_t index) {
    std::vector<const TemporalFrame*> neighbours;
    for (size_t i = index - std::min(index, size_t(kRadius)); i <= std::min(frames_.size() - 1, index + kRadius); ++i)
        if (i != index) neighbours.push_back(&frames_[i].light);
    Frame& frame = frames_[index];
    LayeredPicture picture = std::move(frame.picture);
    frame.picture = {};
    replaceLight(picture, filteredOverTime(frame.light, neighbours));
    ++finished_;
    frame.finish(std::move(picture));
}

}  // namespace drc
