#include "pbrt/scene_builder.h"

#include <cmath>
#include <exception>

#include "base/parallel.h"
#include "pbrt/camera_factory.h"
#include "pbrt/filter_factory.h"
#include "pbrt/render_settings.h"
#include "pbrt/suggest.h"

namespace drc::pbrt {
namespace {

bool isUsable(const Transform& t) {
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            if (!std::isfinite(t.at(row, column))) return false;
    return t.isInvertible();
}

std::string placeOf(const SourcePos& pos) {
    const SourceLocation at = pos.location();
    return "line " + std::to_string(at.line) + " of " + at.file;
}

}  // namespace

SceneBuilder::SceneBuilder(const FileSearch& files)
    : files_(files),
      camera_{"perspective", ParamSet("camera 'perspective'", {})},
      film_{"image", ParamSet("film 'image'", {})},
      filter_{"box", ParamSet("pixel filter 'box'", {})},
      sampler_{"halton", ParamSet("sampler 'halton'", {})},
      integrator_{"path", ParamSet("integrator 'path'", {})} {
    state_.material = makeMaterial("matte", ParamSet("material 'matte'", {}), state_.textures, state_.namedMaterials);
}

void SceneBuilder::apply(const Transform& t, const SourcePos& pos) {
    if (!isUsable(t)) fail(pos, "this transformation cannot be inverted");
    for (size_t i = 0; i < 2; ++i)
        if (state_.active[i]) state_.ctm.at[i] = state_.ctm.at[i] * t;
}

void SceneBuilder::setTransform(const Transform& t, const SourcePos& pos) {
    if (!isUsable(t)) fail(pos, "this transformation cannot be inverted");
    for (size_t i = 0; i < 2; ++i)
        if (state_.active[i]) state_.ctm.at[i] = t;
}

void SceneBuilder::setActiveTransforms(bool start, bool end) { state_.active = {start, end}; }

void SceneBuilder::nameCoordinateSystem(const std::string& name) { coordinateSystems_[name] = state_.ctm; }

void SceneBuilder::useCoordinateSystem(const std::string& name, const SourcePos& pos) {
    const auto found = coordinateSystems_.find(name);
    if (found == coordinateSystems_.end()) {
        std::vector<std::string_view> names;
        for (const auto& entry : coordinateSystems_) names.push_back(entry.first);
        fail(pos, "no coordinate system '" + name + "' has been named" + suggestion(name, names));
    }
    state_.ctm = found->second;
}

void SceneBuilder::camera(const std::string& type, ParamSet params) {
    camera_ = {type, std::move(params)};
    worldToCamera_ = state_.ctm;
    coordinateSystems_["camera"] = state_.ctm.inverse();
}
void SceneBuilder::film(const std::string& type, ParamSet params) { film_ = {type, std::move(params)}; }
void SceneBuilder::filter(const std::string& type, ParamSet params) { filter_ = {type, std::move(params)}; }
void SceneBuilder::sampler(const std::string& type, ParamSet params) { sampler_ = {type, std::move(params)}; }
void SceneBuilder::integrator(const std::string& type, ParamSet params) { integrator_ = {type, std::move(params)}; }

void SceneBuilder::worldBegin(const SourcePos& pos) {
    worldBegin_ = pos;
    state_.ctm = {};
    state_.active = {true, true};
    coordinateSystems_["world"] = state_.ctm;
}

void SceneBuilder::worldEnd(const SourcePos& pos) {
    if (!blocks_.empty())
        fail(pos, "WorldEnd comes before the " + blocks_.back().kind + "End of " + blocks_.back().kind + "Begin in " +
                      placeOf(blocks_.back().pos));
    worldEnded_ = true;
}

void SceneBuilder::beginBlock(const std::string& kind, const SourcePos& pos) { blocks_.push_back({kind, pos, state_}); }

void SceneBuilder::pop(const std::string& kind, const SourcePos& pos) {
    if (blocks_.empty()) fail(pos, kind + "End without " + kind + "Begin");
    if (blocks_.back().kind != kind)
        fail(pos, kind + "End where the " + blocks_.back().kind + "Begin in " + placeOf(blocks_.back().pos) +
                      " must be ended first");
}

void SceneBuilder::endBlock(const std::string& kind, const SourcePos& pos) {
    pop(kind, pos);
    GraphicsState& saved = blocks_.back().saved;
    if (kind == "Transform") {
        state_.ctm = saved.ctm;
        state_.active = saved.active;
    } else {
        state_ = std::move(saved);
    }
    blocks_.pop_back();
}

void SceneBuilder::objectBegin(const std::string& name, const SourcePos& pos) {
    if (openObject_) fail(pos, "ObjectBegin inside of another object");
    beginBlock("Object", pos);
    openObject_ = scene_->objects.size();
    objects_[name] = *openObject_;
    scene_->objects.push_back({name, {}});
}

void SceneBuilder::objectEnd(const SourcePos& pos) {
    endBlock("Object", pos);
    openObject_.reset();
}

void SceneBuilder::objectInstance(const std::string& name, const SourcePos& pos) {
    if (openObject_) fail(pos, "ObjectInstance inside of an object: objects cannot be nested");
    const auto found = objects_.find(name);
    if (found == objects_.end()) {
        std::vector<std::string_view> names;
        for (const auto& entry : objects_) names.push_back(entry.first);
        fail(pos, "no object '" + name + "' has been defined" + suggestion(name, names));
    }
    scene_->instances.push_back({int(found->second), staticTransform(pos)});
}

void SceneBuilder::reverseOrientation() { state_.reverseOrientation = !state_.reverseOrientation; }

void SceneBuilder::material(const std::string& type, ParamSet params) {
    state_.material = makeMaterial(type, std::move(params), state_.textures, state_.namedMaterials);
}

void SceneBuilder::makeNamedMaterial(const std::string& name, ParamSet params) {
    const Param* type = params.find("type", {ParamType::String});
    if (type == nullptr) fail(params.pos(), "the named material '" + name + "' needs the parameter \"string type\"");
    const std::string typeName = params.getString("type", "");
    state_.namedMaterials.set(name, makeMaterial(typeName, std::move(params), state_.textures, state_.namedMaterials));
}

void SceneBuilder::namedMaterial(const std::string& name, const SourcePos& pos) {
    auto found = state_.namedMaterials.find(name);
    if (!found)
        fail(pos, "no material '" + name + "' has been named" + suggestion(name, state_.namedMaterials.names()));
    state_.material = std::move(found);
}

void SceneBuilder::texture(const std::string& name, const std::string& valueType, const std::string& type,
                           ParamSet params) {
    const TextureParams textureParams(params, state_.textures);
    const TextureRequest request{textureParams, staticTransform(params.pos()), files_, textureFiles_};
    if (valueType == "float")
        state_.textures.scalars.set(name, makeFloatTexture(type, request));
    else if (valueType == "spectrum" || valueType == "color")
        state_.textures.colors.set(name, makeRgbTexture(type, request));
    else
        fail(params.pos(), "texture '" + name + "' must be of type 'float' or 'spectrum', not '" + valueType + "'");
    params.warnUnused();
}

void SceneBuilder::light(const std::string& type, const ParamSet& params) {
    if (LightPtr light = makeLight(type, params, staticTransform(params.pos()), files_))
        scene_->lights.push_back(std::move(light));
}

void SceneBuilder::areaLight(const std::string& type, const ParamSet& params) {
    state_.areaLight = makeAreaLight(type, params);
}

void SceneBuilder::shape(const std::string& type, const ParamSet& params) {
    const ShapeContext context{params, state_.textures, files_, staticTransform(params.pos()),
                               state_.reverseOrientation};
    auto geometry = makeShape(type, context);
    if (!geometry) return;
    PendingPrimitive pending;
    pending.pos = params.pos();
    pending.object = openObject_;
    pending.geometry = std::move(*geometry);
    pending.primitive.shape = pending.geometry.shape;
    pending.primitive.alpha = pending.geometry.alpha;
    pending.primitive.shadowAlpha = pending.geometry.shadowAlpha;
    pending.primitive.material = materialForShape(*state_.material, params, state_.textures, state_.namedMaterials);
    params.warnUnused();
    if (joinCurves(pending)) return;
    if (state_.areaLight && openObject_) {
        warn(params.pos(), "shapes of an instanced object cannot be area lights; it does not emit");
    } else if (state_.areaLight) {
        pending.areaLight = state_.areaLight;
        pending.lightSlot = scene_->lights.size();
        scene_->lights.push_back(nullptr);
    }
    pending_.push_back(std::move(pending));
}

bool SceneBuilder::joinCurves(const PendingPrimitive& next) {
    if (!next.geometry.curves || pending_.empty()) return false;
    PendingPrimitive& last = pending_.back();
    const bool emit = state_.areaLight || last.areaLight;
    const bool alike = last.geometry.curves && last.geometry.curves->looksLike(*next.geometry.curves) &&
                       last.object == next.object && last.primitive.material == next.primitive.material &&
                       last.primitive.alpha == next.primitive.alpha &&
                       last.primitive.shadowAlpha == next.primitive.shadowAlpha;
    if (emit || !alike) return false;
    last.geometry.curves->append(*next.geometry.curves);
    return true;
}

const Transform& SceneBuilder::staticTransform(const SourcePos& pos) const {
    if (state_.ctm.isAnimated())
        warn(pos, "moving transformations are not supported yet; that of the start time is used");
    return state_.ctm.start();
}

void SceneBuilder::checkComplete(const SourcePos& end) const {
    if (worldEnded_) return;
    if (!blocks_.empty())
        fail(end, "the file ends before the " + blocks_.back().kind + "End of " + blocks_.back().kind + "Begin in " +
                      placeOf(blocks_.back().pos));
    if (worldBegin_) fail(end, "the file ends before the WorldEnd of WorldBegin in " + placeOf(*worldBegin_));
    fail(end, "the file ends without a WorldBegin");
}

void SceneBuilder::loadMeshes() {
    // Kept by place, so that of several errors the first in the file is reported whatever thread was first.
    std::vector<std::exception_ptr> errors(pending_.size());
    parallelFor(0, int(pending_.size()), 1, [&](int begin, int end) {
        for (int k = begin; k < end; ++k) {
            PendingPrimitive& p = pending_[size_t(k)];
            if (!p.geometry.loadMesh) continue;
            try {
                p.primitive.mesh = p.geometry.loadMesh();
            } catch (...) {
                errors[size_t(k)] = std::current_exception();
            }
            p.geometry.loadMesh = nullptr;  // frees what it owns
        }
    });
    for (size_t i = 0; i < errors.size(); ++i) {
        if (!errors[i]) continue;
        try {
            std::rethrow_exception(errors[i]);
        } catch (const Error& error) {
            fail(pending_[i].pos, std::string("cannot load the mesh: ") + error.what());
        }
    }
}

std::unique_ptr<Scene> SceneBuilder::finish(const LoadOptions& options) {
    RenderSettings& settings = scene_->settings;
    settings.filter = makeFilter(filter_.type, filter_.params);
    applyFilm(film_.type, film_.params, settings);
    applySampler(sampler_.type, sampler_.params, settings);
    applyIntegrator(integrator_.type, integrator_.params, settings);
    if (options.resolution) {
        settings.film.width = options.resolution->width;
        settings.film.height = options.resolution->height;
    }
    if (worldToCamera_.isAnimated())
        warn(camera_.params.pos(), "moving cameras are not supported yet; that of the start time is used");
    scene_->camera = makeCamera(camera_.type, camera_.params, worldToCamera_.start(), settings.film, files_);

    loadMeshes();
    for (PendingPrimitive& p : pending_) {
        if (p.areaLight) {
            p.primitive.areaLight = p.areaLight(p.primitive);
            scene_->lights[*p.lightSlot] = p.primitive.areaLight;
        }
        auto& primitives = p.object ? scene_->objects[*p.object].primitives : scene_->primitives;
        primitives.push_back(std::move(p.primitive));
    }
    pending_.clear();
    return std::move(scene_);
}

}  // namespace drc::pbrt
