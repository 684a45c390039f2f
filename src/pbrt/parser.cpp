#include "pbrt/parser.h"

#include "pbrt/directives.h"

namespace drc::pbrt {

Parser::Parser(std::unique_ptr<Source> main)
    : tokens_(std::move(main)), files_(tokens_.mainSource().directory()), builder_(files_) {}

void Parser::directive(const Token& word) {
    if (word.kind != TokenKind::Word) fail(word.pos, "expected a directive, found " + word.describe());
    const Directive& entry = findDirective(word);
    if (entry.scope == DirectiveScope::World && !builder_.inWorld())
        fail(word.pos, std::string(entry.name) + " must come after WorldBegin");
    if (entry.scope == DirectiveScope::Options && builder_.inWorld())
        fail(word.pos, std::string(entry.name) + " must come before WorldBegin");
    entry.run({tokens_, builder_, files_, entry.name, word.pos});
    worldEnded_ = entry.name == "WorldEnd";
}

std::unique_ptr<Scene> Parser::parse(const LoadOptions& options) {
    for (;;) {
        const Token token = tokens_.next();
        if (token.kind == TokenKind::End) {
            builder_.checkComplete(token.pos);
            break;
        }
        if (worldEnded_) {
            warn(token.pos, "only the first scene of a file is rendered; what follows WorldEnd is ignored");
            break;
        }
        directive(token);
    }
    return builder_.finish(options);
}

}  // namespace drc::pbrt
