// Reads a scene's directives one after the other and has the scene built.
#pragma once
#include <memory>

#include "pbrt/file_search.h"
#include "pbrt/param_parser.h"
#include "pbrt/scene_builder.h"
#include "pbrt/token_stream.h"

namespace drc::pbrt {

class Parser {
  public:
    explicit Parser(std::unique_ptr<Source> main);
    // To be called once.
    std::unique_ptr<Scene> parse(const LoadOptions& options);

  private:
    void directive(const Token& word);

    TokenStream tokens_;
    FileSearch files_;
    SceneBuilder builder_;
    bool worldEnded_ = false;
};

}  // namespace drc::pbrt
