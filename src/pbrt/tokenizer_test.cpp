#include "pbrt/tokenizer.h"

#include <gmock/gmock.h>

#include <limits>
#include <random>

#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

TEST(Tokenizer, KindsTextAndPositions) {
    const auto source = Source::fromText("Shape \"sphere\" # a comment ] \"\n\t[ -1.5e2 ]\nWorldEnd", "a.pbrt", ".");
    Tokenizer tokenizer(*source);
    struct Expected {
        TokenKind kind;
        std::string text;
        int line, column;
    };
    const Expected expected[] = {
        {TokenKind::Word, "Shape", 1, 1},
        {TokenKind::String, "sphere", 1, 7},
        {TokenKind::OpenBracket, "[", 2, 2},
        {TokenKind::Number, "-1.5e2", 2, 4},
        {TokenKind::CloseBracket, "]", 2, 11},
        {TokenKind::Word, "WorldEnd", 3, 1},
        {TokenKind::End, "", 3, 9},
        {TokenKind::End, "", 3, 9},
    };
    for (const Expected& e : expected) {
        const Token token = tokenizer.next();
        EXPECT_EQ(token.kind, e.kind) << e.text;
        EXPECT_EQ(token.text, e.text);
        EXPECT_EQ(token.pos.location().file, "a.pbrt");
        EXPECT_EQ(token.pos.location().line, e.line) << e.text;
        EXPECT_EQ(token.pos.location().column, e.column) << e.text;
    }
}

// What takeNumbers() takes, next() and Token::number() would have given, and what follows is the same.
TEST(Tokenizer, NumbersTakenTogetherAreThoseTakenOneByOne) {
    const std::string numbers[] = {"0",     "-1.5e2", ".25", "-.5", "7.",      "1e-50", "0012",   "16777217",
                                   "1e38",  "-0",     "+3",  "3.",  "1e-5000", "1e39",  "1e5000", "-nan",
                                   "1.2.3", "4x",     "+-1", "-",   ".",       "0x10",  "1e",     "-inf"};
    const std::string others[] = {"]", "# 5 6\n", "word", "\"7\"", "", "[", "8#9\n"};
    const std::string blanks[] = {" ", "\n", "\t\r\n  "};
    std::mt19937 rng(5);
    const auto pick = [&](const auto& from) { return from[rng() % std::size(from)]; };
    size_t together = 0;
    for (int round = 0; round < 4000; ++round) {
        std::string text;
        for (int i = 0; i < 12; ++i) text += (rng() % 8 == 0 ? pick(others) : pick(numbers)) + pick(blanks);
        const auto source = Source::fromText(text, "a.pbrt", ".");
        // The numbers up to the first thing that is none, and what comes after them.
        const auto read = [&](bool byTaking, std::vector<double>& values) {
            Tokenizer tokenizer(*source);
            for (;;) {
                if (byTaking) {
                    const size_t before = values.size();
                    tokenizer.takeNumbers(values);
                    together += values.size() - before;
                }
                const Token token = tokenizer.next();
                if (token.kind != TokenKind::Number) return std::to_string(token.pos.offset) + token.describe();
                try {
                    values.push_back(token.number());
                } catch (const Error& error) {
                    return std::string(error.what());
                }
            }
        };
        std::vector<double> one, all;
        EXPECT_EQ(read(true, all), read(false, one)) << text;
        EXPECT_EQ(all, one) << text;
    }
    EXPECT_GT(together, 2000u);
}

// As in pbrt a comment begins only where a token may begin.
TEST(Tokenizer, WordsEndAtBracketsAndQuotes) {
    const auto source = Source::fromText("[1 2]\"a\"#b\n3#c", "a", ".");
    Tokenizer tokenizer(*source);
    std::vector<std::string> texts;
    for (Token t = tokenizer.next(); t.kind != TokenKind::End; t = tokenizer.next()) texts.emplace_back(t.text);
    EXPECT_THAT(texts, testing::ElementsAre("[", "1", "2", "]", "a", "3#c"));
}

std::string valueOf(const std::string& text) {
    const auto source = Source::fromText(text, "a", ".");
    return Tokenizer(*source).next().value();
}

TEST(Tokenizer, Escapes) {
    EXPECT_EQ(valueOf(R"("a\"b\\c\nd\te")"), "a\"b\\c\nd\te");
    EXPECT_EQ(errorOf([] { valueOf(R"("dir\wood.png")"); }),
              "a:1:5: unknown escape '\\w' in a string; write folders with '/', and a backslash as '\\\\'\n"
              "    \"dir\\wood.png\"\n"
              "        ^");
}

TEST(Tokenizer, UnterminatedString) {
    EXPECT_EQ(errorOf([] { valueOf("  \"abc\nnext line\""); }),
              "a:1:3: unterminated string: there is no closing '\"' on this line\n"
              "      \"abc\n"
              "      ^");
    EXPECT_THAT(errorOf([] { valueOf("\"abc\\\""); }), testing::StartsWith("a:1:1: unterminated string"));
}

double numberOf(const std::string& text) {
    const auto source = Source::fromText(text, "a", ".");
    return Tokenizer(*source).next().number();
}

TEST(Tokenizer, Numbers) {
    EXPECT_EQ(numberOf("1"), 1);
    EXPECT_EQ(numberOf("+2.5"), 2.5);
    EXPECT_EQ(numberOf(".5"), 0.5);
    EXPECT_EQ(numberOf("-5."), -5);
    EXPECT_EQ(numberOf("1e-3"), 1e-3);
    EXPECT_EQ(numberOf("1E3"), 1000);
    EXPECT_EQ(numberOf("1e-999"), 0);
    EXPECT_EQ(numberOf("-3.4e38"), -3.4e38);
    for (const char* beyond : {"1e999", "-1e999", "3.5e38"})
        EXPECT_THAT(errorOf([&] { numberOf(beyond); }),
                    testing::StartsWith("a:1:1: expected a number within 3.4e38 of zero, found '"))
            << beyond;
    for (const char* bad : {"1.2.3", "--1", "+-1", "1x", "-", "+", ".", "1e", "0x10", "1,5", "nan", "-nan", "inf",
                            "-inf", "+inf", "1.#IND", "-1.#INF", "1.#QNAN", "1.#J"})
        EXPECT_THAT(
            errorOf([&] { numberOf(bad); }),
            testing::StartsWith("a:1:1: expected a number, found '" + std::string(bad) + "', which is not a number\n"));
    EXPECT_THAT(errorOf([&] { numberOf("2#two"); }),
                testing::HasSubstr("which is not a number; a comment needs a blank before its '#'\n"));
}

TEST(Tokenizer, ZeroBytesEndIt) {
    const auto source = Source::fromText(std::string("Shape\0\0\0", 8), "a", ".");
    Tokenizer tokenizer(*source);
    EXPECT_EQ(tokenizer.next().text, "Shape");
    EXPECT_THAT(errorOf([&] { tokenizer.next(); }),
                testing::StartsWith("a:1:6: found a zero byte where text should be"));
}

TEST(Tokenizer, ByteOrderMarkAndCarriageReturns) {
    const auto source = Source::fromText("\xEF\xBB\xBFWorldBegin\r\nWorldEnd\r\n", "a", ".");
    Tokenizer tokenizer(*source);
    const Token begin = tokenizer.next();
    EXPECT_EQ(begin.text, "WorldBegin");
    EXPECT_EQ(begin.pos.location().column, 1);
    EXPECT_EQ(begin.pos.excerpt(), "    WorldBegin\n    ^");
    const Token end = tokenizer.next();
    EXPECT_EQ(end.text, "WorldEnd");
    EXPECT_EQ(end.pos.location().line, 2);
}

TEST(Source, LongLinesAreCutAroundTheCaret) {
    std::string text(5000, '1');
    for (size_t i = 3; i < text.size(); i += 4) text[i] = ' ';
    const auto source = Source::fromText(text, "a", ".");
    const std::string excerpt = SourcePos{source.get(), 2500}.excerpt();
    EXPECT_LT(excerpt.size(), 300u);
    const size_t lineBreak = excerpt.find('\n');
    EXPECT_EQ(excerpt.substr(0, 7), "    ...");
    EXPECT_EQ(excerpt.substr(lineBreak - 3, 3), "...");
    EXPECT_EQ(excerpt.size() - lineBreak - 1, 4u + 3u + 50u + 1u);
}

}  // namespace
}  // namespace drc::pbrt
