#include "pbrt/scene_copy.h"

#include <fmt/core.h>

#include <utility>

#include "pbrt/dialect_scan.h"
#include "pbrt/directive_form.h"
#include "pbrt/directives.h"
#include "pbrt/file_params.h"
#include "pbrt/token_stream.h"

namespace drc::pbrt {
namespace {

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + '"';
}

std::string asWritten(const Token& token) {
    return token.kind == TokenKind::String ? '"' + std::string(token.text) + '"' : std::string(token.text);
}

class SceneCopy {
  public:
    SceneCopy(const std::shared_ptr<const Source>& main, const CopySettings& settings,
              const std::function<void(std::string_view)>& write)
        : tokens_(main),
          files_(main->directory()),
          dialect_(findDialect(main, files_).dialect),
          settings_(settings),
          write_(write) {}

    // Returns the files that the scene names.
    std::vector<std::string> copy() {
        add(fmt::format("# {}", nameOf(dialect_)));
        for (Token word = next(); word.kind != TokenKind::End; word = next()) {
            if (word.kind != TokenKind::Word) fail(word.pos, "expected a directive, found " + word.describe());
            findDirective(word);
            directive(word);
            if (word.text == "WorldEnd") break;
        }
        if (!inWorld_) fail(tokens_.peek().pos, "the file ends without a WorldBegin");
        add("\n");
        write_(text_);
        return files_.found();
    }

  private:
    static constexpr size_t kPiece = size_t(1) << 16;

    void add(std::string_view text) {
        text_ += text;
        if (text_.size() < kPiece) return;
        write_(text_);
        text_.clear();
    }

    // The token after the files whose end has been reached. A block takes the place of an imported file.
    Token next() {
        tokens_.peek();
        while (!imports_.empty() && tokens_.depth() < imports_.back()) {
            add("\nAttributeEnd");
            imports_.pop_back();
        }
        return tokens_.next();
    }

    void directive(const Token& word) {
        if (word.text == "Include" || word.text == "Import") return include(word);
        if (word.text == "WorldBegin" && !inWorld_) addSettings();
        const bool isReplaced =
            (word.text == "Sampler" && settings_.spp) || (word.text == "Integrator" && !settings_.integrator.empty());
        if (!isReplaced) add(fmt::format("\n{}", word.text));
        copies_ = !isReplaced;
        if (const DirectiveForm* form = formOf(word.text))
            withParameters(word, *form);
        else
            arguments(word);
        copies_ = true;
    }

    void include(const Token& word) {
        const Token name = tokens_.expectString("the file of " + std::string(word.text));
        tokens_.include(files_.find(name.value(), name.pos, "file to include"), name.pos);
        if (word.text == "Include") return;
        add("\nAttributeBegin");
        imports_.push_back(tokens_.depth());
    }

    void addSettings() {
        inWorld_ = true;
        if (settings_.resolution && !hasFilm_) {
            add(dialect_ == Dialect::V4 ? "\nFilm \"rgb\"" : "\nFilm \"image\"");
            addResolution();
        }
        if (settings_.spp) add(fmt::format("\nSampler \"halton\" \"integer pixelsamples\" [ {} ]", *settings_.spp));
        if (!settings_.integrator.empty())
            add(fmt::format("\nIntegrator {} \"integer maxdepth\" [ {} ]", quoted(settings_.integrator),
                            settings_.maxDepth));
    }
    void addResolution() {
        add(fmt::format(" \"integer xresolution\" [ {} ] \"integer yresolution\" [ {} ]", settings_.resolution->width,
                        settings_.resolution->height));
    }

    // Copies everything up to the next directive.
    void arguments(const Token& word) {
        // The argument of ActiveTransform looks like a directive.
        if (word.text == "ActiveTransform") addToken(tokens_.next());
        while (tokens_.peek().kind != TokenKind::Word && tokens_.peek().kind != TokenKind::End)
            addToken(tokens_.next());
    }

    void addToken(const Token& token) {
        if (copies_) add(" " + asWritten(token));
    }

    void withParameters(const Token& word, const DirectiveForm& form) {
        for (int i = 0; i < form.strings; ++i)
            addToken(tokens_.expectString(fmt::format("string {} of {}", i + 1, word.text)));
        const bool isFilm = word.text == "Film";
        while (tokens_.peek().kind == TokenKind::String) parameter(isFilm);
        if (!isFilm) return;
        hasFilm_ = true;
        if (settings_.resolution) addResolution();
    }

    void parameter(bool isOfFilm) {
        const Token declaration = tokens_.next();
        const ParamName declared = paramNameOf(declaration.value());
        if (declared.name.empty() || declared.hasMore)
            fail(declaration.pos, "expected a parameter as \"type name\", found " + declaration.describe());
        const bool isSize = isOfFilm && (declared.name == "xresolution" || declared.name == "yresolution");
        const bool copied = std::exchange(copies_, copies_ && !(isSize && settings_.resolution));
        addToken(declaration);
        const bool isFile = !isOfFilm && namesFile(declared.type, declared.name);
        Token value = tokens_.next();
        const Token first = value;
        if (first.kind != TokenKind::OpenBracket) {
            addValue(value, isFile);
        } else {
            addToken(first);
            for (value = tokens_.next(); value.kind != TokenKind::CloseBracket; value = tokens_.next()) {
                if (value.kind == TokenKind::End || value.pos.source != first.pos.source)
                    fail(first.pos,
                         "unterminated '[': the file ends before the ']' of parameter '" + declared.name + "'");
                addValue(value, isFile);
            }
            addToken(value);
        }
        copies_ = copied;
    }

    void addValue(const Token& value, bool isFile) {
        if (value.kind == TokenKind::End || value.kind == TokenKind::OpenBracket ||
            value.kind == TokenKind::CloseBracket)
            fail(value.pos, "expected a value, found " + value.describe());
        if (isFile && value.kind == TokenKind::String && copies_)
            add(" " + quoted(absolutePath(value.value(), value.pos, files_)));
        else
            addToken(value);
    }

    TokenStream tokens_;
    FileSearch files_;
    Dialect dialect_;
    const CopySettings& settings_;
    const std::function<void(std::string_view)>& write_;
    std::string text_;
    std::vector<size_t> imports_;  // include depths of the imported files that are open
    bool inWorld_ = false, hasFilm_ = false;
    bool copies_ = true;  // whether tokens that are read are copied
};

}  // namespace

std::vector<std::string> copyScene(const std::string& path, const CopySettings& settings,
                                   const std::function<void(std::string_view)>& write) {
    return SceneCopy(Source::open(path), settings, write).copy();
}

}  // namespace drc::pbrt
