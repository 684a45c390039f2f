// The shapes of a scene: SceneBuilder::shape(), and the functions that finish() calls for them at the end.
#include <fmt/core.h>

#include <exception>
#include <new>

#include "base/parallel.h"
#include "pbrt/scene_builder.h"
#include "pbrt/scene_limits.h"
#include "scene/textures/texture_scale.h"

namespace drc::pbrt {

void SceneBuilder::shape(const std::string& type, ParamSet params) {
    params = completed("shape", std::move(params));
    const size_t listed = recorder_ ? recorder_->shape(type, params, state_) : 0;
    const uint32_t number = openObject_ ? 0 : numbers_.next(), material = numbers_.ofMaterial(state_.material);
    const bool moves = state_.ctm.isAnimated();  // if so, the transformation is applied by an instance
    const ShapeContext context{
        params,   files_,          moves ? Transform() : placement().start(), state_.reverseOrientation,
        dialect_, curvePiecesLeft_};
    auto geometry = make_.shape(type, context);
    if (!geometry) return;
    if (geometry->curves) curvePiecesLeft_ -= geometry->curves->pieceCount();
    if (geometry->shape && !isWithinReach(geometry->shape->bounds()))
        fail(params.pos(), "the " + params.owner() + " reaches farther from the origin than 1e18");
    PendingPrimitive pending;
    pending.pos = params.pos();
    pending.shape = type;
    pending.listed = listed;
    pending.material = state_.material;
    pending.areaLight = state_.areaLight;
    pending.inObject = openObject_.has_value();
    pending.moves = moves;
    pending.object = moves ? movingObject(params.owner(), params.pos()) : openObject_;
    pending.geometry = std::move(*geometry);
    if (kept_) {
        std::optional<FileStamp> file;
        if (!pending.geometry.meshFile.empty())
            file.emplace(files_.find(pending.geometry.meshFile, params.pos(), "PLY file"));
        pending.key = contentKeyOf(type, context, file);
    }
    pending.primitive.shape = pending.geometry.shape;
    pending.primitive.visibleToCamera = params.getBool("visibletocamera", true);
    pending.primitive.visibleToDiffuse = params.getBool("visibletodiffuse", true);
    pending.blocksLight = params.getBool("blockslight", true);
    pending.primitive.media = state_.media;
    pending.primitive.objectNumber = number;
    pending.primitive.materialNumber = material;
    try {
        dress(pending, params);
    } catch (const UndefinedName&) {
        pending.awaitsNames = true;
        params.ignore({"alpha", "shadowalpha"});
    }
    params.warnUnused();
    const ParamSet masks = params.only({"alpha", "shadowalpha"});
    pending.awaitsMasks = pending.awaitsNames && !masks.all().empty();
    if (!pending.areaLight && placedAt(params.pos(), [&] { return joinCurves(pending); })) return;
    scene_->placements.add(number, state_.ctm.animated());
    // A shape whose names are still undefined may turn out to emit, so it reserves a light slot. Unused slots are
    // removed later.
    if (pending.awaitsNames || pending.areaLight) {
        pending.lightSlot = scene_->lights.size();
        scene_->lights.push_back(nullptr);
    }
    if (pending.awaitsNames)
        later_.use([this, index = pending_.size(), masks] {
            PendingPrimitive& later = pending_[index];
            dress(later, masks);
            if (keepsNames_) later.primitive.name = nameOf(later);
        });
    else if (keepsNames_)
        pending.primitive.name = nameOf(pending);
    pending_.push_back(std::move(pending));
}

void SceneBuilder::dress(PendingPrimitive& p, const ParamSet& params) {
    const std::string& name = p.material->name;
    if (p.material->awaited)
        throw UndefinedName(kMaterialName, name, p.pos, "the material '" + name + "' has not been defined");
    Primitive& primitive = p.primitive;
    primitive.alpha = maskOf(params, "alpha", state_.textures);
    primitive.shadowAlpha = maskOf(params, "shadowalpha", state_.textures);
    primitive.alphaIsShare = dialect_ == Dialect::V4;
    primitive.material = make_.materialOfShape(*p.material, params, materialSources());
    takeFromMaterial(primitive);
    p.areaLight = areaLightOf(p);
    const bool isInterface = !primitive.material;
    if (!p.blocksLight) primitive.material = nullptr;
    const auto cannotEmit = [&](const std::string& why) {
        warn(p.pos, why + "; it does not emit");
        p.areaLight = nullptr;
    };
    if (p.areaLight && p.inObject)
        cannotEmit("shapes of an instanced object cannot be area lights");
    else if (p.areaLight && p.moves)
        cannotEmit("shapes that move cannot be area lights");
    else if (p.areaLight && dialect_ == Dialect::V4 && isInterface)
        cannotEmit("as in pbrt-v4, a shape with the material 'interface' cannot be an area light");
}

uint32_t SceneBuilder::nameOf(const PendingPrimitive& p) {
    const MaterialInstance& material = *p.material;
    const SourceLocation at = p.pos.location();
    return scene_->names.add({.material = material.name,
                              .materialKind = material.type.empty() ? "none" : std::string_view(material.type),
                              .shapeKind = p.shape,
                              .meshFile = p.geometry.meshFile,
                              .file = at.file,
                              .line = at.line});
}

void SceneBuilder::takeFromMaterial(Primitive& primitive) const {
    if (!primitive.material || !primitive.material->opacity()) return;
    const FloatTexturePtr& opacity = primitive.material->opacity();
    primitive.alpha = primitive.alpha ? makeScaleTexture<float>(primitive.alpha, opacity) : opacity;
    primitive.alphaIsShare = true;
}

AreaLightBuilder SceneBuilder::areaLightOf(const PendingPrimitive& p) {
    if (p.areaLight || !p.primitive.material || !p.primitive.material->emission()) return p.areaLight;
    const RgbTexturePtr& texture = p.primitive.material->emission();
    auto [entry, isNew] = emissions_.try_emplace(texture, Rgb(0.f));
    if (isNew) entry->second = emissionOf(*texture);
    return [emission = entry->second](const Primitive& of) { return makeDiffuseAreaLight(of, emission, true); };
}

bool SceneBuilder::joinCurves(const PendingPrimitive& next) {
    if (!next.geometry.curves || pending_.empty()) return false;
    PendingPrimitive& last = pending_.back();
    const bool alike =
        last.geometry.curves && last.geometry.curves->looksLike(*next.geometry.curves) && last.object == next.object &&
        last.awaitsNames == next.awaitsNames && (!next.awaitsNames || last.material == next.material) &&
        !last.awaitsMasks && !next.awaitsMasks && last.blocksLight == next.blocksLight &&
        last.primitive.material == next.primitive.material && last.primitive.alpha == next.primitive.alpha &&
        last.primitive.shadowAlpha == next.primitive.shadowAlpha && last.primitive.media == next.primitive.media &&
        last.primitive.visibleToCamera == next.primitive.visibleToCamera &&
        last.primitive.visibleToDiffuse == next.primitive.visibleToDiffuse;
    if (last.areaLight || !alike) return false;
    last.geometry.curves->append(*next.geometry.curves);
    last.key = last.key.with(next.key);
    return true;
}

void SceneBuilder::takeKept() {
    for (PendingPrimitive& p : pending_) {
        if (p.geometry.loadMesh) {
            p.primitive.mesh = kept_->mesh(p.key);
            if (p.primitive.mesh) p.geometry.loadMesh = nullptr;
        } else if (ShapePtr shape = kept_->shape(p.key)) {
            p.primitive.shape = std::move(shape);
        }
    }
}

void SceneBuilder::keepContents() {
    KeptContents::Contents contents;
    for (const PendingPrimitive& p : pending_) {
        if (p.primitive.mesh) contents.meshes.emplace(p.key, p.primitive.mesh);
        if (p.primitive.shape) contents.shapes.emplace(p.key, p.primitive.shape);
    }
    kept_->replace(std::move(contents), scene_->origin);
    textureFiles_.keepIn(*kept_);
}

void SceneBuilder::loadMeshes(const LoadOptions& options) {
    double subdivided = 0;
    for (const PendingPrimitive& p : pending_) {
        subdivided += p.geometry.subdivided;
        if (subdivided > options.subdividedTriangles)
            fail(p.pos, fmt::format("with this one, subdivision surfaces come to {:.3g} triangles, and at most {:.3g} "
                                    "are made; use fewer levels",
                                    subdivided, options.subdividedTriangles));
    }
    forEachPending([](PendingPrimitive& p) {
        if (!p.geometry.loadMesh) return;
        try {
            p.primitive.mesh = p.geometry.loadMesh();
        } catch (const Error& error) {
            fail(p.pos, std::string("cannot load the mesh: ") + error.what());
        } catch (const std::bad_alloc&) {
            fail(p.pos, "cannot load the mesh: there is not enough memory");
        }
        p.geometry.loadMesh = nullptr;  // frees the data that it captured
    });
}

void SceneBuilder::makeAreaLights() {
    forEachPending([](PendingPrimitive& p) {
        if (p.areaLight) p.primitive.areaLight = placedAt(p.pos, [&] { return p.areaLight(p.primitive); });
    });
    for (const PendingPrimitive& p : pending_)
        if (p.lightSlot) scene_->lights[*p.lightSlot] = p.primitive.areaLight;
    std::erase(scene_->lights, nullptr);
}

void SceneBuilder::forEachPending(const std::function<void(PendingPrimitive&)>& work) {
    // Errors are stored by position, so that the first one in the file is reported, whichever thread was faster.
    std::vector<std::exception_ptr> errors(pending_.size());
    parallelFor(0, int(pending_.size()), 1, [&](int begin, int end) {
        for (int k = begin; k < end; ++k) {
            try {
                work(pending_[size_t(k)]);
            } catch (...) {
                errors[size_t(k)] = std::current_exception();
            }
        }
    });
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
}

}  // namespace drc::pbrt
