// What the tests of the pbrt front end share.
#pragma once
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "base/error.h"
#include "pbrt/scene_file.h"

namespace drc::pbrt {

// The text of the Error that f throws; "" if it throws none.
template <typename F>
std::string errorOf(const F& f) {
    try {
        f();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

// A folder that is removed with everything in it.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        static std::atomic<int> count{0};
        path_ = std::filesystem::temp_directory_path() /
                ("drc-pbrt-test-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
        std::filesystem::create_directories(path_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    // The file's path.
    std::string write(const std::string& name, const std::string& contents) const {
        const auto file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << contents;
        return file.string();
    }
    std::string path() const { return path_.string(); }

  private:
    std::filesystem::path path_;
};

// The text of the Error for a scene called "s.pbrt".
inline std::string errorOfScene(const std::string& text, const std::string& directory = ".") {
    return errorOf([&] { loadPbrtString(text, directory, {}, "s.pbrt"); });
}
// The same for what stands between WorldBegin, on line 1, and WorldEnd; it begins on line 2.
inline std::string errorOfWorld(const std::string& text, const std::string& directory = ".") {
    return errorOfScene("WorldBegin\n" + text + "\nWorldEnd\n", directory);
}
inline std::unique_ptr<Scene> loadWorld(const std::string& text, const std::string& directory = ".") {
    return loadPbrtString("WorldBegin\n" + text + "\nWorldEnd\n", directory, {}, "s.pbrt");
}
// The same in pbrt-v4's words: between the film and WorldBegin, on line 1, and the end.
inline std::unique_ptr<Scene> loadWorldV4(const std::string& text, const std::string& directory = ".") {
    return loadPbrtString("Film \"rgb\" WorldBegin\n" + text + "\n", directory, {}, "s.pbrt");
}
inline std::string errorOfWorldV4(const std::string& text, const std::string& directory = ".") {
    return errorOf([&] { loadWorldV4(text, directory); });
}

}  // namespace drc::pbrt
