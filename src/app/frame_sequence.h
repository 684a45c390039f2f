// The frames that `drc render` renders: the one of the command line, and those of --frames after it.
#pragma once
#include <optional>

#include "app/distinct_files.h"
#include "app/frame_list.h"
#include "app/render_options.h"

namespace drc {

class FrameSequence {
  public:
    // options: have the scene and the pictures of the present frame. Throws Error if the list cannot be opened.
    explicit FrameSequence(RenderOptions& options);

    bool isAnimation() const { return list_.has_value(); }
    // The number of the present frame, counted from 1.
    int number() const { return number_; }
    // Tells on standard output that the pictures of the present frame are there, if this is an animation.
    void finished() const;
    // Goes on to the next frame; false after the last. Throws Error as FrameList::next() does, and if a list that is a
    // file gives the frame a picture that an earlier one has. On standard input, whoever asks for frames may use a name
    // again.
    bool next();
    // Goes on to a frame whose predecessors were rendered before a checkpoint was saved. Throws Error if there are not
    // as many.
    void skipTo(int number);

  private:
    void claimPictures();

    RenderOptions& options_;
    std::optional<FrameList> list_;
    DistinctFiles pictures_;
    int number_ = 1;
};

}  // namespace drc
