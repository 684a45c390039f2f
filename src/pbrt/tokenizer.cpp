#include "pbrt/tokenizer.h"

#include <charconv>
#include <cmath>
#include <cstdlib>

namespace drc::pbrt {
namespace {

constexpr bool isSpace(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }
// As in pbrt, '#' begins a comment only where a token may begin. "1.#IND", which some compilers print for NaN, is thus
// one token, not the number 1 and a comment.
constexpr bool endsWord(char c) { return isSpace(c) || c == '"' || c == '[' || c == ']' || c == '\0'; }
constexpr bool startsNumber(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.'; }

}  // namespace

std::string Token::value() const {
    if (!hasEscapes) return std::string(text);
    std::string result;
    result.reserve(text.size());
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\\') {
            result += text[i];
            continue;
        }
        switch (text[++i]) {
            case 'n':
                result += '\n';
                break;
            case 't':
                result += '\t';
                break;
            case 'r':
                result += '\r';
                break;
            case 'b':
                result += '\b';
                break;
            case 'f':
                result += '\f';
                break;
            case '\\':
                result += '\\';
                break;
            case '"':
                result += '"';
                break;
            case '\'':
                result += '\'';
                break;
            case '\n':
                break;  // the line continues
            default:
                fail({pos.source, pos.offset + i},
                     std::string("unknown escape '\\") + text[i] +
                         "' in a string; write folders with '/', and a backslash as '\\\\'");
        }
    }
    return result;
}

double Token::number() const {
    const char* first = text.data();
    const char* const last = first + text.size();
    // from_chars does not accept a leading plus; "+-1" must remain an error.
    if (text.size() > 1 && *first == '+' && first[1] != '-') ++first;
    double result = 0;
    const auto [end, error] = std::from_chars(first, last, result);
    // from_chars accepts "nan" and "inf", which are not numbers of a scene.
    const bool isWord = text.find_first_of("nN") != std::string_view::npos;
    if (kind != TokenKind::Number || end != last || error == std::errc::invalid_argument || isWord)
        fail(pos, "expected a number, found " + describe() + whyNoNumber());
    if (error == std::errc::result_out_of_range) result = std::strtod(std::string(first, last).c_str(), nullptr);
    // Scenes consist of floats. Numbers that overflow a float would spread infinities over the picture.
    if (!std::isfinite(static_cast<float>(result)))
        fail(pos, "expected a number within 3.4e38 of zero, found " + describe());
    return result;
}

std::string Token::whyNoNumber() const {
    if (kind != TokenKind::Word && kind != TokenKind::Number) return "";
    const size_t comment = text.find('#');
    const bool isComment = comment != std::string_view::npos && comment > 0 && text[comment - 1] != '.';
    return std::string(", which is not a number") + (isComment ? "; a comment needs a blank before its '#'" : "");
}

std::string Token::describe() const {
    switch (kind) {
        case TokenKind::End:
            return "the end of the file";
        case TokenKind::String:
            return "the string \"" + std::string(text.substr(0, 60)) + "\"";
        default:
            return "'" + std::string(text.substr(0, 60)) + "'";
    }
}

Tokenizer::Tokenizer(const Source& source) : source_(&source), text_(source.text()) {
    if (text_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
}

Token Tokenizer::next() {
    for (;;) {
        while (at_ < text_.size() && isSpace(text_[at_])) ++at_;
        if (at_ == text_.size() || text_[at_] != '#') break;
        at_ = std::min(text_.find('\n', at_), text_.size());
    }
    Token token;
    token.pos = {source_, at_};
    if (at_ == text_.size()) return token;

    const size_t start = at_;
    const char c = text_[at_++];
    // Binary and sparse files may look like a single endless word.
    if (c == '\0') fail(token.pos, "found a zero byte where text should be");
    if (c == '"') return string();
    if (c == '[') {
        token.kind = TokenKind::OpenBracket;
    } else if (c == ']') {
        token.kind = TokenKind::CloseBracket;
    } else {
        while (at_ < text_.size() && !endsWord(text_[at_])) ++at_;
        token.kind = startsNumber(c) ? TokenKind::Number : TokenKind::Word;
    }
    token.text = text_.substr(start, at_ - start);
    return token;
}

void Tokenizer::takeNumbers(std::vector<double>& to) {
    const char* const text = text_.data();
    const char* const last = text + text_.size();
    for (;;) {
        const char* first = text + at_;
        while (first < last && isSpace(*first)) ++first;
        at_ = size_t(first - text);
        // Numbers with a plus sign, and numbers that overflow, are left to Token::number().
        if (first == last || !startsNumber(*first) || *first == '+') return;
        double number = 0;
        const auto [end, error] = std::from_chars(first, last, number);
        if (error != std::errc() || !(end == last || endsWord(*end)) || !std::isfinite(static_cast<float>(number)))
            return;
        to.push_back(number);
        at_ = size_t(end - text);
    }
}

Token Tokenizer::string() {
    const size_t start = at_;
    Token token;
    token.kind = TokenKind::String;
    token.pos = {source_, start - 1};
    for (; at_ < text_.size() && text_[at_] != '\n'; ++at_) {
        if (text_[at_] == '"') {
            token.text = text_.substr(start, at_++ - start);
            return token;
        }
        if (text_[at_] == '\\' && at_ + 1 < text_.size()) {
            token.hasEscapes = true;
            ++at_;
        }
    }
    fail(token.pos, "unterminated string: there is no closing '\"' on this line");
}

}  // namespace drc::pbrt
