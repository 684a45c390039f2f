// The tokens of a scene: those of its file with every Include replaced by the tokens of the file it names.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pbrt/tokenizer.h"

namespace drc::pbrt {

class TokenStream {
  public:
    static constexpr size_t kMaxIncludeDepth = 64;

    explicit TokenStream(std::shared_ptr<const Source> main);

    const Token& peek();
    Token next();
    // Goes on with the tokens of this file, then with those after the Include. Throws Error, at pos, for a file that
    // cannot be read, includes itself, or lies too deep. To be called with nothing peeked.
    void include(const std::string& path, const SourcePos& pos);

    // Each throws Error, with what the token is for, if the next token is something else.
    Token expectString(const std::string& purpose);
    double expectNumber(const std::string& purpose);

    // How many files are open: 1 in the main one. A file is left when the token after its last is peeked at.
    size_t depth() const { return stack_.size(); }
    const Source& mainSource() const { return *sources_.front(); }

  private:
    struct Frame {
        Tokenizer tokenizer;
        std::string canonicalPath;
    };

    std::vector<std::shared_ptr<const Source>> sources_;  // all that were ever opened: places refer to them
    std::vector<Frame> stack_;
    std::optional<Token> ahead_;
};

}  // namespace drc::pbrt
