// Reads the directives of a scene in order and builds the scene.
#pragma once
#include <memory>

#include "pbrt/dialect_scan.h"
#include "pbrt/file_search.h"
#include "pbrt/param_parser.h"
#include "pbrt/scene_builder.h"
#include "pbrt/token_stream.h"

namespace drc::pbrt {

class Parser {
  public:
    // origin: Scene::origin.
    explicit Parser(std::shared_ptr<const Source> main, const Vec3& origin = Vec3(0.f));
    // Call either parse() or parseCamera(), once. Both parse in the dialect of the file.
    std::unique_ptr<Scene> parse(const LoadOptions& options);
    // Parses only up to WorldBegin: the camera and the settings, for a scene without a world.
    std::unique_ptr<Scene> parseCamera(const LoadOptions& options);

  private:
    Parser(std::shared_ptr<const Source> main, const FileSearch& files, const Vec3& origin);
    // untilWorld: stop before WorldBegin, if there is one.
    void readDirectives(bool untilWorld);
    std::unique_ptr<Scene> parse(const LoadOptions& options, bool untilWorld);
    void directive(const Token& word);
    // Ends the blocks of imported files whose end has been reached.
    void endImports();

    std::shared_ptr<const Source> main_;
    TokenStream tokens_;
    FileSearch files_;
    DialectFinding dialect_;
    SceneBuilder builder_;
    struct Import {
        size_t depth;  // include depth while the file is read
        SourcePos pos;
    };
    std::vector<Import> imports_;  // imports whose end has not been reached
    bool worldEnded_ = false;
};

}  // namespace drc::pbrt
