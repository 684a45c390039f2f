// The frames of a render: the first, from the command line, and then those of a list.
#pragma once
#include <optional>

#include "base/distinct_files.h"
#include "render/frame_list.h"
#include "render/frame_number.h"

namespace drc {

class FrameSequence {
  public:
    // present: the first frame's files, which next() replaces by those of the next frame; must outlive this object.
    // list: path of a frame list (FrameList); empty if there is only one frame. Warns where frames have the same number
    // (FrameNumbers). Throws Error if the list cannot be
    // opened.
    FrameSequence(FrameFiles& present, const std::string& list);

    bool isAnimation() const { return list_.has_value(); }
    // The number of the present frame, counted from 1.
    int number() const { return number_; }
    // If this is an animation, writes to standard output that the pictures of the present frame are finished.
    void finished() const;
    // Goes on to the next frame; false after the last. Throws Error as FrameList::next() does, and if the list gives
    // the frame a picture that an earlier frame has. On standard input, a name may be used again.
    bool next();
    // Goes on to the frame of a checkpoint; the frames before it were rendered earlier. checkpoint: its file, for
    // messages. Throws Error if the list has too few frames.
    void skipTo(int number, const std::string& checkpoint);

  private:
    // Claims the pictures and the number of the present frame.
    void begin();

    FrameFiles& present_;
    std::string listName_;
    std::optional<FrameList> list_;
    DistinctFiles pictures_;
    FrameNumbers numbers_;
    int number_ = 1;
};

}  // namespace drc
