#include "pbrt/dialect_scan.h"

#include "pbrt/directive_form.h"
#include "pbrt/param_parser.h"
#include "pbrt/token_stream.h"

namespace drc::pbrt {
namespace {

class DialectScan {
  public:
    DialectScan(std::shared_ptr<const Source> main, const FileSearch& files)
        : tokens_(std::move(main)), files_(files) {}

    DialectFinding find() {
        try {
            while (!certain_ && tokens_.peek().kind != TokenKind::End) {
                const Token token = tokens_.next();
                if (token.kind == TokenKind::Word) directive(token);
            }
        } catch (const Error&) {
        }
        return finding_;
    }

  private:
    void note(std::optional<Dialect> dialect, bool weak, const std::string& word, const SourcePos& pos) {
        if (!dialect || certain_ || (weak && !finding_.word.empty())) return;
        finding_ = {*dialect, word, pos.location(), weak};
        certain_ = !weak;
    }

    void directive(const Token& word) {
        note(dialectOfDirective(word.text), false, "'" + std::string(word.text) + "'", word.pos);
        if (word.text == "Include" || word.text == "Import") {
            const Token file = tokens_.expectString("a file");
            tokens_.include(files_.find(file.value(), file.pos, "file to include"), file.pos);
            return;
        }
        const DirectiveForm* form = formOf(word.text);
        if (form == nullptr) return;
        std::string type;
        for (int i = 0; i < form->strings; ++i) {
            const Token text = tokens_.expectString("a string");
            if (i != form->type) continue;
            type = text.value();
            noteType(word.text, type, text.pos);
        }
        while (!certain_ && tokens_.peek().kind == TokenKind::String) parameter(word.text, type);
    }

    void noteType(std::string_view directive, const std::string& type, const SourcePos& pos) {
        note(dialectOfType(directive, type), false, "'" + std::string(directive) + " \"" + type + "\"'", pos);
    }

    void parameter(std::string_view directive, std::string& type) {
        const Token token = tokens_.next();
        const ParamName declared = paramNameOf(token.value());
        ParamMark mark{declared.type, declared.name, 0, {}};
        const Token first = tokens_.next();
        Token value = first;
        const bool bracketed = first.kind == TokenKind::OpenBracket;
        if (bracketed) value = tokens_.next();
        const Token firstValue = value;
        if (value.kind == TokenKind::String) mark.firstText = value.text;
        if (!bracketed) {
            mark.valueCount = 1;
        } else {
            for (; value.kind != TokenKind::CloseBracket && value.kind != TokenKind::End; value = tokens_.next())
                ++mark.valueCount;
        }
        if (directive == "MakeNamedMaterial" && declared.name == "type") {
            type = std::string(mark.firstText);
            noteType(directive, type, firstValue.pos);
        }
        note(dialectOfParam(directive, type, mark), true, "'\"" + std::string(token.text) + "\"'", token.pos);
    }

    TokenStream tokens_;
    const FileSearch& files_;
    DialectFinding finding_;
    bool certain_ = false;
};

}  // namespace

DialectFinding findDialect(std::shared_ptr<const Source> main, const FileSearch& files) {
    return DialectScan(std::move(main), files).find();
}

}  // namespace drc::pbrt
