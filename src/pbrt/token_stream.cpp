#include "pbrt/token_stream.h"

#include <algorithm>
#include <filesystem>

namespace drc::pbrt {
namespace {

std::string canonical(const std::string& path) {
    std::error_code ignored;
    const auto result = std::filesystem::weakly_canonical(path, ignored);
    return ignored ? path : result.string();
}

}  // namespace

TokenStream::TokenStream(std::shared_ptr<const Source> main) {
    stack_.push_back({Tokenizer(*main), canonical(main->name())});
    sources_.push_back(std::move(main));
}

const Token& TokenStream::peek() {
    if (!ahead_) {
        Token token = stack_.back().tokenizer.next();
        while (token.kind == TokenKind::End && stack_.size() > 1) {
            stack_.pop_back();
            token = stack_.back().tokenizer.next();
        }
        ahead_ = token;
    }
    return *ahead_;
}

Token TokenStream::next() {
    const Token token = peek();
    ahead_.reset();
    return token;
}

void TokenStream::include(const std::string& path, const SourcePos& pos) {
    std::string id = canonical(path);
    for (const Frame& frame : stack_)
        if (frame.canonicalPath == id) fail(pos, "'" + path + "' includes itself");
    if (stack_.size() >= kMaxIncludeDepth)
        fail(pos, "Include is nested more than " + std::to_string(kMaxIncludeDepth) + " files deep");
    std::unique_ptr<Source> source;
    try {
        source = Source::fromFile(path);
    } catch (const Error& error) {
        fail(pos, error.what());
    }
    stack_.push_back({Tokenizer(*source), std::move(id)});
    sources_.push_back(std::move(source));
}

Token TokenStream::expectString(const std::string& purpose) {
    const Token token = next();
    if (token.kind != TokenKind::String)
        fail(token.pos, "expected " + purpose + " as a quoted string, found " + token.describe());
    return token;
}

double TokenStream::expectNumber(const std::string& purpose) {
    const Token token = next();
    if (token.kind != TokenKind::Number) fail(token.pos, "expected " + purpose + ", found " + token.describe());
    return token.number();
}

}  // namespace drc::pbrt
