// The frames of an animation after the first, as a list: from a file, or from standard input or a pipe, which are read
// while the frames are rendered, so that another program may ask for each frame when the last one is there.
#pragma once
#include <deque>
#include <fstream>
#include <istream>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace drc {

// The files of a frame.
struct FrameFiles {
    std::string scene;
    std::vector<std::string> outputs;
};

class FrameList {
  public:
    // path: of the list; -: standard input. A file is read and checked as a whole. Throws Error if it cannot be opened,
    // and, naming the line, if a frame has no picture, a scene that does not exist, or a picture that cannot be written
    // or is another frame's.
    explicit FrameList(const std::string& path);

    // Waits for the next frame; none at the end of the list. Each has a line: a scene file, and the pictures to write,
    // with tabs between them. Empty lines, and those that begin with '#', do not count. Throws Error as the constructor
    // does, for a list that is read meanwhile.
    std::optional<FrameFiles> next();
    // Writes the paths of pictures that are there to standard output, with tabs between them.
    static void finished(const std::vector<std::string>& outputs);

  private:
    std::optional<FrameFiles> read();
    void check(const FrameFiles& frame);

    std::string name_;
    std::ifstream file_;
    std::istream& in_;
    int line_ = 0;
    std::map<std::string, int> lineOfOutput_;
    bool isWhole_ = false;           // all frames have been read
    std::deque<FrameFiles> frames_;  // if so, those to come
};

}  // namespace drc
