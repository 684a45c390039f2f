// The blocks of a scene file that are open, and what the end of each restores: docs/pbrt-dialects.md, "Scopes".
#pragma once
#include <string>
#include <vector>

#include "pbrt/dialect.h"
#include "pbrt/graphics_state.h"
#include "pbrt/source.h"

namespace drc::pbrt {

class Blocks {
  public:
    explicit Blocks(Dialect dialect) : dialect_(dialect) {}

    // kind: "Attribute", "Transform", "Object", "Import". Throws Error at pos if too many are open.
    void begin(const std::string& kind, const SourcePos& pos, const GraphicsState& state);
    // Restores in `state` what the end of the block restores. Where blocks do not nest: throws Error in pbrt-v4, and
    // goes on in pbrt-v3, with a warning.
    void end(const std::string& kind, const SourcePos& pos, GraphicsState& state);

    bool empty() const { return open_.empty(); }
    // "AttributeEnd of AttributeBegin in line 2 of a.pbrt", of the innermost block, for messages.
    std::string innermost() const;

  private:
    struct Block {
        std::string kind;
        SourcePos pos;
        GraphicsState saved;
        // pbrt-v3 keeps states and transformations on two stacks. Where blocks do not nest, one half of a block may end
        // before the other.
        bool hasState = true, hasTransform = true;
    };
    void checkNesting(const std::string& kind, const SourcePos& pos) const;
    void endInV3(const std::string& kind, const SourcePos& pos, GraphicsState& state);

    Dialect dialect_;
    std::vector<Block> open_;
};

}  // namespace drc::pbrt
