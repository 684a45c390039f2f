#include "pbrt/blocks.h"

#include <algorithm>

#include "base/limits.h"

namespace drc::pbrt {
void Blocks::begin(const std::string& kind, const SourcePos& pos, const GraphicsState& state) {
    if (open_.size() >= limits::kBlockDepth)
        fail(pos, kind + "Begin within more than " + std::to_string(limits::kBlockDepth) + " other blocks");
    open_.push_back({kind, pos, state});
    if (dialect_ == Dialect::V3 && kind == "Transform") open_.back().hasState = false;
}

std::string Blocks::innermost() const {
    const Block& block = open_.back();
    return block.kind + "End of " + block.kind + "Begin in " + block.pos.lineOfFile();
}

void Blocks::checkNesting(const std::string& kind, const SourcePos& pos) const {
    if (open_.empty()) fail(pos, kind + "End without " + kind + "Begin");
    const Block& innermost = open_.back();
    if (kind == "Import" && innermost.kind != kind)
        fail(innermost.pos, "the " + innermost.kind + "Begin is not ended in the imported file");
    if (innermost.kind == "Import" && kind != "Import")
        fail(pos, kind + "End without " + kind + "Begin in the imported file");
    if (innermost.kind != kind)
        fail(pos, kind + "End where the " + innermost.kind + "Begin in " + innermost.pos.lineOfFile() +
                      " must be ended first");
}

void Blocks::end(const std::string& kind, const SourcePos& pos, GraphicsState& state) {
    if (dialect_ == Dialect::V3) return endInV3(kind, pos, state);
    checkNesting(kind, pos);
    GraphicsState& saved = open_.back().saved;
    // Names of textures and materials belong to the whole file, so they outlive the block.
    saved.textures = std::move(state.textures);
    saved.namedMaterials = std::move(state.namedMaterials);
    state = std::move(saved);
    open_.pop_back();
}

void Blocks::endInV3(const std::string& kind, const SourcePos& pos, GraphicsState& state) {
    const auto lastWith = [&](bool Block::*half) {
        return std::find_if(open_.rbegin(), open_.rend(), [&](const Block& block) { return block.*half; });
    };
    const bool restoresState = kind != "Transform";
    const auto ofState = lastWith(&Block::hasState), ofTransform = lastWith(&Block::hasTransform);
    if (open_.empty() || (restoresState ? ofState : ofTransform) == open_.rend()) {
        warn(pos, kind + "End without " + kind + "Begin; ignored");
        return;
    }
    if (open_.back().kind != kind)
        warn(pos, kind + "End where the " + open_.back().kind + "Begin in " + open_.back().pos.lineOfFile() +
                      " should be ended first; as in pbrt-v3, it restores the latest " +
                      (restoresState ? "state and transformation" : "transformation") + " that were saved");
    TransformSet ctm = state.ctm;
    std::array<bool, 2> active = state.active;
    if (ofTransform != open_.rend()) {
        ctm = ofTransform->saved.ctm;
        active = ofTransform->saved.active;
        ofTransform->hasTransform = false;
    }
    if (restoresState) {
        state = ofState->saved;
        ofState->hasState = false;
    }
    state.ctm = ctm;
    state.active = active;
    std::erase_if(open_, [](const Block& block) { return !block.hasState && !block.hasTransform; });
}

}  // namespace drc::pbrt
