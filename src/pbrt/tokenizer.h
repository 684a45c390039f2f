// Splits one pbrt file into tokens.
#pragma once
#include <string>
#include <string_view>

#include "pbrt/source.h"

namespace drc::pbrt {

enum class TokenKind { Word, Number, String, OpenBracket, CloseBracket, End };

struct Token {
    TokenKind kind = TokenKind::End;
    std::string_view text;  // as written; a string without its quotes
    SourcePos pos;          // first character; for End, the end of the last file read
    bool hasEscapes = false;

    // A string's value, with escapes replaced. Throws Error for an escape that does not exist.
    std::string value() const;
    // Throws Error unless the whole token is a number. Beyond a double's range: 0 or infinity.
    double number() const;
    // For messages: "'Foo'", "string \"x\"", "the end of the file".
    std::string describe() const;
};

class Tokenizer {
  public:
    explicit Tokenizer(const Source& source);
    // Throws Error for an unterminated string. After the end, End for ever.
    Token next();
    const Source& source() const { return *source_; }

  private:
    Token string();

    const Source* source_;
    std::string_view text_;
    size_t at_ = 0;
};

}  // namespace drc::pbrt
