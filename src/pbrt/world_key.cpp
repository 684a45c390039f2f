#include "pbrt/world_key.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/checksum.h"
#include "math/sampler.h"
#include "pbrt/file_search.h"
#include "pbrt/token_stream.h"

namespace drc::pbrt {
namespace {

constexpr std::string_view kOfTheCamera[] = {
    "ActiveTransform", "Camera", "ConcatTransform", "CoordinateSystem", "Film",     "Identity",
    "LookAt",          "Rotate", "Scale",           "Transform",        "Translate"};

bool isOfTheCamera(std::string_view directive) {
    return std::ranges::find(kOfTheCamera, directive) != std::end(kOfTheCamera);
}

}  // namespace

std::optional<uint64_t> worldKey(const std::string& path) {
    const std::shared_ptr<const Source> main = Source::fromFile(path);
    const FileSearch files(main->directory());
    TokenStream tokens(main);
    uint64_t key = 0;
    bool inWorld = false, counts = true, isArgument = false;
    for (Token token = tokens.next(); token.kind != TokenKind::End; token = tokens.next()) {
        // The argument of ActiveTransform looks like a directive.
        if (token.kind == TokenKind::Word && !std::exchange(isArgument, false)) {
            if (token.text == "CoordSysTransform") return {};
            if (token.text == "Include" || token.text == "Import") {
                const Token file = tokens.expectString("the name of a file");
                tokens.include(files.find(file.value(), file.pos, "included file"), file.pos);
                continue;
            }
            isArgument = token.text == "ActiveTransform";
            inWorld = inWorld || token.text == "WorldBegin";
            counts = inWorld || !isOfTheCamera(token.text);
        }
        if (counts) key = hashCombine(key, hashCombine(uint64_t(token.kind), checksum(token.text)));
    }
    return key;
}

}  // namespace drc::pbrt
