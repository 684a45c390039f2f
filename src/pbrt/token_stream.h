// The tokens of a scene: those of its file with every Include replaced by the tokens of the file it names.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/limits.h"
#include "pbrt/tokenizer.h"

namespace drc::pbrt {

// What all Includes of a scene may come to: see limits.h.
struct IncludeLimit {
    size_t files = limits::kIncludes;
    uint64_t bytes = limits::kIncludedBytes;
    uint64_t ratio = limits::kIncludedRatio;  // to the bytes of different files
};

class TokenStream {
  public:
    explicit TokenStream(std::shared_ptr<const Source> main, const IncludeLimit& limit = {});

    const Token& peek();
    Token next();
    // Goes on with the tokens of this file, then with those after the Include. Throws Error, at pos, for a file that
    // cannot be read, includes itself, lies too deep, or goes beyond the limit. To be called with nothing peeked.
    void include(const std::string& path, const SourcePos& pos);

    // Each throws Error, with what the token is for, if the next token is something else.
    Token expectString(const std::string& purpose);
    double expectNumber(const std::string& purpose);

    // How many files are open: 1 in the main one. A file is left when the token after its last is peeked at.
    size_t depth() const { return stack_.size(); }
    const Source& mainSource() const { return *main_; }

  private:
    struct Frame {
        Tokenizer tokenizer;
        std::string canonicalPath;
    };

    IncludeLimit limit_;
    size_t includes_ = 0;
    uint64_t bytes_ = 0, differentBytes_ = 0;  // of them
    std::shared_ptr<const Source> main_;
    // All that were ever included, by their path, each read once: places refer to them.
    std::map<std::string, std::unique_ptr<const Source>> sources_;
    std::vector<Frame> stack_;
    std::optional<Token> ahead_;
};

}  // namespace drc::pbrt
