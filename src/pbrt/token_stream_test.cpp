#include "pbrt/token_stream.h"

#include <gmock/gmock.h>

#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;

// The words of a text in which each "@file" is included from the folder.
std::vector<std::string> wordsOf(const std::string& text, const TemporaryFolder& folder,
                                 const IncludeLimit& limit = {}) {
    TokenStream tokens(Source::fromText(text, "main", folder.path()), limit);
    std::vector<std::string> words;
    for (Token token = tokens.next(); token.kind != TokenKind::End; token = tokens.next()) {
        if (token.text.starts_with('@'))
            tokens.include(folder.path() + "/" + std::string(token.text.substr(1)), token.pos);
        else
            words.push_back(std::string(token.text));
    }
    return words;
}

TEST(TokenStream, IncludesStandWhereTheyAreNamed) {
    const TemporaryFolder folder;
    folder.write("a", "x @b y");
    folder.write("b", "inner");
    EXPECT_EQ(wordsOf("1 @a 2 @a @b 3", folder),
              (std::vector<std::string>{"1", "x", "inner", "y", "2", "x", "inner", "y", "inner", "3"}));
}

// Each of forty files includes the next one twice: 2^40 Includes in all.
TEST(TokenStream, FilesThatDoubleEndByTheirNumber) {
    const TemporaryFolder folder;
    for (int i = 0; i < 40; ++i) {
        const std::string next = "@d" + std::to_string(i + 1) + " ";
        folder.write("d" + std::to_string(i), next + next);
    }
    folder.write("d40", "end");
    EXPECT_THAT(errorOf([&] { wordsOf("@d0", folder, {.files = 300}); }), HasSubstr("this is the Include number 301,"));
}

TEST(TokenStream, FilesThatDoubleEndByTheirBytes) {
    const TemporaryFolder folder;
    std::string comment(1000, '#');
    comment.back() = '\n';
    folder.write("a", comment);
    std::string text;
    for (int i = 0; i < 30; ++i) text += "@a ";
    EXPECT_EQ(errorOf([&] { wordsOf(text, folder, {.bytes = 10000, .ratio = 20}); }), "");
    EXPECT_THAT(errorOf([&] { wordsOf(text, folder, {.bytes = 10000, .ratio = 19}); }),
                HasSubstr("main:1:88: this is the Include number 30, of 30000 bytes in all"));
}

}  // namespace
}  // namespace drc::pbrt
