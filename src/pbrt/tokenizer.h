// Splits a pbrt file into tokens.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/source.h"

namespace drc::pbrt {

enum class TokenKind { Word, Number, String, OpenBracket, CloseBracket, End };

struct Token {
    TokenKind kind = TokenKind::End;
    std::string_view text;  // as written; strings without their quotes
    SourcePos pos;          // position of the first character; for End, the end of the file
    bool hasEscapes = false;

    // The value of a string, with escapes replaced. Throws Error for an unknown escape.
    std::string value() const;
    // Throws Error unless the whole token is a finite number that fits a float.
    double number() const;
    // A description of the token for messages: "'Foo'", "string \"x\"", "the end of the file".
    std::string describe() const;
    // Suffix for the message "expected a number", with the likely reason; empty for tokens that cannot be a mistyped
    // number.
    std::string whyNoNumber() const;
};

class Tokenizer {
  public:
    explicit Tokenizer(const Source& source);
    // The next token; after the last one, always End. Throws Error for an unterminated string.
    Token next();
    // Appends the numbers that follow, with the values that next() and Token::number() give. Stops at anything else:
    // another token, a comment, the end, or a number that Token::number() must check. Fast, because meshes are millions
    // of numbers.
    void takeNumbers(std::vector<double>& to);
    const Source& source() const { return *source_; }

  private:
    Token string();

    const Source* source_;
    std::string_view text_;
    size_t at_ = 0;
};

}  // namespace drc::pbrt
