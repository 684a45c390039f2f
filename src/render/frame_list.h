// The list of an animation's frames after the first. It comes from a file, or from standard input or a pipe, which are
// read while the frames are rendered: another program may ask for each frame after the last one is finished.
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
    // and, naming the line, if a frame has no picture, a scene that does not exist, a picture that cannot be written,
    // or a picture that another frame has too.
    explicit FrameList(const std::string& path);

    // Waits for the next frame; none at the end of the list. Each line is a frame: a scene file and the pictures to
    // write, separated by tabs. Empty lines, and lines that begin with '#', are skipped. For a list that is read during
    // rendering, throws Error as the constructor does for a file.
    std::optional<FrameFiles> next();
    // Writes the paths of finished pictures to standard output, separated by tabs.
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
    std::deque<FrameFiles> frames_;  // the frames to come, if isWhole_
};

}  // namespace drc
