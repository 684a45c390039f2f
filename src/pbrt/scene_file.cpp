#include "pbrt/scene_file.h"

#include "pbrt/parser.h"

namespace drc::pbrt {

std::unique_ptr<Scene> loadPbrtFile(const std::string& path, const LoadOptions& options) {
    return Parser(Source::fromFile(path)).parse(options);
}

std::unique_ptr<Scene> loadPbrtString(const std::string& text, const std::string& directory, const LoadOptions& options,
                                      const std::string& name) {
    return Parser(Source::fromText(text, name, directory)).parse(options);
}

}  // namespace drc::pbrt
