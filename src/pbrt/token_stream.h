// The tokens of a scene: the tokens of its main file, where those of the included file replace each Include.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/limits.h"
#include "pbrt/tokenizer.h"

namespace drc::pbrt {

// Limits for all Includes of a scene together (limits.h).
struct IncludeLimit {
    size_t files = limits::kIncludes;
    uint64_t bytes = limits::kIncludedBytes;
    uint64_t ratio = limits::kIncludedRatio;  // relative to the total size of the distinct files
};

class TokenStream {
  public:
    explicit TokenStream(std::shared_ptr<const Source> main, const IncludeLimit& limit = {});

    const Token& peek();
    Token next();
    // Appends the numbers that follow in the file, up to the first other token (Tokenizer::takeNumbers). Appends
    // nothing while a token is peeked at.
    void takeNumbers(std::vector<double>& to) {
        if (!ahead_) stack_.back().tokenizer.takeNumbers(to);
    }
    // Continues with the tokens of this file, and afterwards with those that follow the Include. Throws Error at pos if
    // the file cannot be read, includes itself, is nested too deep, or exceeds the limits. Must not be called while a
    // token is peeked at.
    void include(const std::string& path, const SourcePos& pos);

    // Both throw Error, with `purpose`, if the next token is of another kind.
    Token expectString(const std::string& purpose);
    double expectNumber(const std::string& purpose);

    // Number of open files; 1 in the main file. A file is closed when the token after its last one is peeked at.
    size_t depth() const { return stack_.size(); }
    const Source& mainSource() const { return *main_; }

  private:
    struct Frame {
        Tokenizer tokenizer;
        std::string canonicalPath;
    };

    IncludeLimit limit_;
    size_t includes_ = 0;
    uint64_t bytes_ = 0, differentBytes_ = 0;  // bytes of all Includes, and of the distinct files among them
    std::shared_ptr<const Source> main_;
    // All included files by path; each is read once. They are kept because positions refer to them.
    std::map<std::string, std::unique_ptr<const Source>> sources_;
    std::vector<Frame> stack_;
    std::optional<Token> ahead_;
};

}  // namespace drc::pbrt
