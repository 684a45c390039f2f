// The frames of an animation after the first, as a list that is read while they are rendered: from a file, or from
// standard input, where another program may ask for each frame when the last one is there.
#pragma once
#include <fstream>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace drc {

class FrameList {
  public:
    struct Frame {
        std::string scene;
        std::vector<std::string> outputs;
    };

    // path: of the list; -: standard input. Throws Error if it cannot be opened.
    explicit FrameList(const std::string& path);

    // Waits for the next frame; none at the end of the list. Each has a line: a scene file, and the pictures to write,
    // with tabs between them. Empty lines do not count. Throws Error, naming the line, if it has no picture, or one
    // that cannot be written.
    std::optional<Frame> next();
    // Writes the paths of pictures that are there to standard output, with tabs between them.
    static void finished(const std::vector<std::string>& outputs);

  private:
    std::string name_;
    std::ifstream file_;
    std::istream& in_;
    int line_ = 0;
};

}  // namespace drc
