// The open blocks of a scene file, and the state that the end of each block restores: docs/pbrt-dialects.md, "Scopes".
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
    // Restores in `state` what the end of the block restores. If blocks are not properly nested, throws Error in
    // pbrt-v4, and warns and continues in pbrt-v3.
    void end(const std::string& kind, const SourcePos& pos, GraphicsState& state);

    bool empty() const { return open_.empty(); }
    // The innermost block, for messages: "AttributeEnd of AttributeBegin in line 2 of a.pbrt".
    std::string innermost() const;

  private:
    struct Block {
        std::string kind;
        SourcePos pos;
        GraphicsState saved;
        // pbrt-v3 keeps states and transformations on two stacks. If blocks are not properly nested, one of the two may
        // be restored before the other.
        bool hasState = true, hasTransform = true;
    };
    void checkNesting(const std::string& kind, const SourcePos& pos) const;
    void endInV3(const std::string& kind, const SourcePos& pos, GraphicsState& state);

    Dialect dialect_;
    std::vector<Block> open_;
};

}  // namespace drc::pbrt
