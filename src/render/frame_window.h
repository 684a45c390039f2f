// Averages the frames of an animation with their neighbours in time, before they are denoised (temporal_filter.h). A
// frame is ready once the frames after it have been rendered; no more than the frames of one window are kept.
#pragma once
#include <deque>
#include <functional>

#include "film/layered_picture.h"
#include "reconstruct/temporal_frame.h"

namespace drc {

class FrameWindow {
  public:
    // Frames before and after a frame that it is averaged with.
    static constexpr int kRadius = 2;

    // Takes an averaged picture, whose light is in place of that of its samples.
    using Finish = std::function<void(LayeredPicture)>;

    // A frame that was rendered: with half buffers, a G-buffer and surfaces (RenderParams). finish is called, for
    // earlier frames first, when the frame's neighbours are there. Throws Error if the frames differ in size or place.
    void add(LayeredPicture picture, const FrameGeometry& geometry, const FilmGeometry& film, std::string name,
             Finish finish);
    // Finishes the frames that have waited for more.
    void end();

  private:
    struct Frame {
        LayeredPicture picture;  // empty once it is finished
        TemporalFrame light;
        Finish finish;
    };
    void finish(size_t index);

    std::deque<Frame> frames_;  // in their order in time
    size_t finished_ = 0;       // how many of them, from the first on, are finished
};

}  // namespace drc
