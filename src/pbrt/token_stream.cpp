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

TokenStream::TokenStream(std::shared_ptr<const Source> main, const IncludeLimit& limit)
    : limit_(limit), main_(std::move(main)) {
    stack_.push_back({Tokenizer(*main_), canonical(main_->name())});
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
    if (stack_.size() >= limits::kIncludeDepth)
        fail(pos, "Include is nested more than " + std::to_string(limits::kIncludeDepth) + " files deep");
    std::unique_ptr<const Source>& source = sources_[path];
    if (!source) {
        source = placedAt(pos, [&] { return Source::fromFile(path); });
        differentBytes_ += source->text().size();
    }
    bytes_ += source->text().size();
    if (++includes_ > limit_.files || bytes_ > limit_.bytes + limit_.ratio * differentBytes_)
        fail(pos, "this is the Include number " + std::to_string(includes_) + ", of " + std::to_string(bytes_) +
                      " bytes in all; so many are read only if files include others again and again");
    stack_.push_back({Tokenizer(*source), std::move(id)});
}

Token TokenStream::expectString(const std::string& purpose) {
    const Token token = next();
    if (token.kind != TokenKind::String)
        fail(token.pos, "expected " + purpose + " as a quoted string, found " + token.describe());
    return token;
}

double TokenStream::expectNumber(const std::string& purpose) {
    const Token token = next();
    if (token.kind != TokenKind::Number)
        fail(token.pos, "expected " + purpose + ", found " + token.describe() + token.whyNoNumber());
    return token.number();
}

}  // namespace drc::pbrt
