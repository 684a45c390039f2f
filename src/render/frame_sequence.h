// The frames of a render: the first, which the command line names, and those of a list after it.
#pragma once
#include <optional>

#include "base/distinct_files.h"
#include "render/frame_list.h"

namespace drc {

class FrameSequence {
  public:
    // present: the files of the first frame, then those of each one after it; must outlive this object. list: as
    // FrameList takes it; empty: there is one frame. Throws Error if the list cannot be opened.
    FrameSequence(FrameFiles& present, const std::string& list);

    bool isAnimation() const { return list_.has_value(); }
    // The number of the present frame, counted from 1.
    int number() const { return number_; }
    // Tells on standard output that the pictures of the present frame are there, if this is an animation.
    void finished() const;
    // Goes on to the next frame; false after the last. Throws Error as FrameList::next() does, and if a list that is a
    // file gives the frame a picture that an earlier one has. On standard input, whoever asks for frames may use a name
    // again.
    bool next();
    // Goes on to the frame of a checkpoint, whose predecessors were rendered before. checkpoint: its file, for
    // messages. Throws Error if there are not as many frames.
    void skipTo(int number, const std::string& checkpoint);

  private:
    void claimPictures();

    FrameFiles& present_;
    std::string listName_;
    std::optional<FrameList> list_;
    DistinctFiles pictures_;
    int number_ = 1;
};

}  // namespace drc
