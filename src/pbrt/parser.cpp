#include "pbrt/parser.h"

#include "base/log.h"
#include "pbrt/directives.h"

namespace drc::pbrt {

Parser::Parser(std::shared_ptr<const Source> main, const Vec3& origin)
    : Parser(main, FileSearch(main->directory()), origin) {}

Parser::Parser(std::shared_ptr<const Source> main, const FileSearch& files, const Vec3& origin)
    : main_(main),
      tokens_(main),
      files_(files),
      dialect_(findDialect(main, files)),
      builder_(files_, dialect_.dialect, origin) {
    logDebug("the scene is read as " + dialect_.describe());
}

void Parser::directive(const Token& word) {
    if (word.kind != TokenKind::Word) fail(word.pos, "expected a directive, found " + word.describe());
    const Directive& entry = findDirective(word);
    checkDialect(dialect_, entry.name, "", word.pos);
    if (entry.scope == DirectiveScope::World && !builder_.inWorld())
        fail(word.pos, std::string(entry.name) + " must come after WorldBegin");
    if (entry.scope == DirectiveScope::Options && builder_.inWorld())
        fail(word.pos, std::string(entry.name) + " must come before WorldBegin");
    entry.run({tokens_, builder_, files_, dialect_, entry.name, word.pos});
    if (entry.name == "Import") imports_.push_back({tokens_.depth(), word.pos});
    worldEnded_ = entry.name == "WorldEnd";
}

void Parser::endImports() {
    tokens_.peek();  // closes files whose end has been reached
    while (!imports_.empty() && tokens_.depth() < imports_.back().depth) {
        builder_.endBlock("Import", imports_.back().pos);
        imports_.pop_back();
    }
}

std::unique_ptr<Scene> Parser::parse(const LoadOptions& options) { return parse(options, false); }

std::unique_ptr<Scene> Parser::parseCamera(const LoadOptions& options) { return parse(options, true); }

std::unique_ptr<Scene> Parser::parse(const LoadOptions& options, bool untilWorld) {
    builder_.limitCurves(options.curvePieces);
    builder_.overrideCamera(options.camera);
    if (options.names) builder_.keepNames();
    if (options.kept && !untilWorld) builder_.reuse(*options.kept);
    if (options.listing) {
        builder_.list(*options.listing);
        options.listing->dialect = dialect_;
    }
    try {
        readDirectives(untilWorld);
        std::unique_ptr<Scene> scene = builder_.finish(options);
        scene->files = files_.found();
        scene->files.insert(scene->files.begin(), main_->name());
        return scene;
    } catch (const Error&) {
        // An unreadable image comes earlier in the file, although it may be detected later, so its error takes
        // precedence.
        builder_.finishTextures();
        throw;
    }
}

void Parser::readDirectives(bool untilWorld) {
    for (;;) {
        endImports();
        const Token token = tokens_.next();
        if (token.kind == TokenKind::End) {
            builder_.checkComplete(token.pos);
            return;
        }
        if (untilWorld && token.kind == TokenKind::Word && token.text == "WorldBegin") return;
        if (worldEnded_) {
            warn(token.pos, "only the first scene of a file is rendered; what follows WorldEnd is ignored");
            return;
        }
        directive(token);
    }
}

}  // namespace drc::pbrt
