#include "pbrt/scene_builder.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>

#include "base/limits.h"
#include "base/parallel.h"
#include "base/suggest.h"
#include "pbrt/medium_factory.h"
#include "pbrt/overrides.h"
#include "pbrt/scene_limits.h"
#include "scene/texture_scale.h"

namespace drc::pbrt {
namespace {

std::string placeOf(const SourcePos& pos) {
    const SourceLocation at = pos.location();
    return "line " + std::to_string(at.line) + " of " + at.file;
}

}  // namespace

SceneBuilder::SceneBuilder(const FileSearch& files, Dialect dialect, const Vec3& origin)
    : files_(files), dialect_(dialect), fromFile_(Transform::translate(-origin)), make_(factoriesOf(dialect)) {
    scene_->origin = origin;
    const auto setting = [](const std::string& kind, const char* type) {
        return Setting{type, ParamSet(kind + " '" + type + "'", {})};
    };
    camera_ = setting("camera", "perspective");
    film_ = setting("film", make_.defaultFilm);
    filter_ = setting("pixel filter", make_.defaultFilter);
    sampler_ = setting("sampler", make_.defaultSampler);
    integrator_ = setting("integrator", make_.defaultIntegrator);
    state_.material = make_.material(make_.defaultMaterial, ParamSet("the default material", {}), materialSources());
}

void SceneBuilder::apply(const Transform& t, const SourcePos& pos) {
    if (!isUsable(t)) fail(pos, "this transformation cannot be inverted");
    for (size_t i = 0; i < 2; ++i) {
        if (!state_.active[i]) continue;
        const Transform product = state_.ctm.at[i] * t;
        if (!isUsable(product)) fail(pos, "with the transformations before it, this one cannot be inverted");
        state_.ctm.at[i] = product;
    }
}

void SceneBuilder::setTransform(const Transform& t, const SourcePos& pos) {
    if (!isUsable(t)) fail(pos, "this transformation cannot be inverted");
    for (size_t i = 0; i < 2; ++i)
        if (state_.active[i]) state_.ctm.at[i] = t;
}

void SceneBuilder::setActiveTransforms(bool start, bool end) { state_.active = {start, end}; }

void SceneBuilder::transformTimes(float start, float end, const SourcePos& pos) {
    if (end < start) warn(pos, "the second of the TransformTimes comes before the first; what moves will jump");
    transformTimes_ = {start, end};
}

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
    motionOf("camera", camera_.params.pos());
    worldToCamera_ = state_.ctm;
    scene_->cameraMedium = state_.media.outside;
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

void SceneBuilder::beginBlock(const std::string& kind, const SourcePos& pos) {
    if (blocks_.size() >= limits::kBlockDepth)
        fail(pos, kind + "Begin within more than " + std::to_string(limits::kBlockDepth) + " other blocks");
    blocks_.push_back({kind, pos, state_, {}});
    if (kind == "Import") blocks_.back().coordinateSystems = coordinateSystems_;
}

void SceneBuilder::pop(const std::string& kind, const SourcePos& pos) {
    if (blocks_.empty()) fail(pos, kind + "End without " + kind + "Begin");
    if (kind == "Import" && blocks_.back().kind != kind)
        fail(blocks_.back().pos, "the " + blocks_.back().kind + "Begin is not ended in the imported file");
    if (blocks_.back().kind == "Import" && kind != "Import")
        fail(pos, kind + "End without " + kind + "Begin in the imported file");
    if (blocks_.back().kind != kind)
        fail(pos, kind + "End where the " + blocks_.back().kind + "Begin in " + placeOf(blocks_.back().pos) +
                      " must be ended first");
}

void SceneBuilder::endBlock(const std::string& kind, const SourcePos& pos) {
    pop(kind, pos);
    GraphicsState& saved = blocks_.back().saved;
    if (dialect_ == Dialect::V4) {
        // Names belong to the file. A coordinate system that an imported file names is its own.
        saved.textures = std::move(state_.textures);
        saved.namedMaterials = std::move(state_.namedMaterials);
        if (kind == "Import") coordinateSystems_ = std::move(blocks_.back().coordinateSystems);
        state_ = std::move(saved);
    } else if (kind == "Transform") {
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

void SceneBuilder::addInstance(size_t object, const AnimatedTransform& toWorld, const SourcePos& pos) {
    checkPlacement(toWorld, pos);
    const Instance instance{int(object), toWorld};
    instances_.take(instance, pos);
    scene_->instances.push_back(instance);
}

void SceneBuilder::objectInstance(const std::string& name, const SourcePos& pos) {
    if (openObject_) fail(pos, "ObjectInstance inside of an object: objects cannot be nested");
    const auto found = objects_.find(name);
    if (found == objects_.end()) {
        std::vector<std::string_view> names;
        for (const auto& entry : objects_) names.push_back(entry.first);
        fail(pos, "no object '" + name + "' has been defined" + suggestion(name, names));
    }
    const AnimatedTransform toWorld = motionOf("object '" + name + "'", pos);
    addInstance(found->second, toWorld, pos);
    for (const MovingPart& part : movingParts_[found->second]) addInstance(part.object, toWorld * part.motion, pos);
}

void SceneBuilder::reverseOrientation() { state_.reverseOrientation = !state_.reverseOrientation; }

void SceneBuilder::attribute(const std::string& target, const ParamSet& params, const SourcePos& pos) {
    const std::vector<std::string_view> targets = {"light", "material", "medium", "shape", "texture"};
    if (std::find(targets.begin(), targets.end(), target) == targets.end())
        fail(pos, "unknown target '" + target + "' of Attribute" + suggestion(target, targets));
    // If a name occurs several times, the last one counts.
    ParamSet all = params;
    std::shared_ptr<const ParamSet>& shared = state_.attributes[target];
    if (shared) all.inherit(*shared);
    checkShared(all, target, pos);
    shared = std::make_shared<const ParamSet>(std::move(all));
}

void SceneBuilder::colorSpace(const std::string& name, const SourcePos& pos) {
    state_.colorSpace = ColorSpace::named(name);
    if (state_.colorSpace == nullptr)
        fail(pos, "unknown colour space '" + name + "'" + suggestion(name, ColorSpace::names()));
}

ColorRules SceneBuilder::colorRules(bool isLight) const { return {dialect_, state_.colorSpace, isLight}; }

ParamSet SceneBuilder::completed(const std::string& target, ParamSet params) const {
    const auto found = state_.attributes.find(target);
    if (found != state_.attributes.end()) params.inherit(*found->second);
    return params;
}

void SceneBuilder::material(const std::string& type, ParamSet params) {
    state_.material = make_.material(type, completed("material", std::move(params)), materialSources());
}

void SceneBuilder::makeNamedMaterial(const std::string& name, ParamSet params) {
    const Param* type = params.find("type", {ParamType::String});
    if (type == nullptr) fail(params.pos(), "the named material '" + name + "' needs the parameter \"string type\"");
    const std::string typeName = params.getString("type", "");
    auto instance = std::make_shared<MaterialInstance>(
        *make_.material(typeName, completed("material", std::move(params)), materialSources()));
    instance->name = name;
    state_.namedMaterials.set(name, std::move(instance));
}

void SceneBuilder::namedMaterial(const std::string& name, const SourcePos& pos) {
    auto found = state_.namedMaterials.find(name);
    if (!found)
        fail(pos, "no material '" + name + "' has been named" + suggestion(name, state_.namedMaterials.names()));
    state_.material = std::move(found);
}

void SceneBuilder::texture(const std::string& name, const std::string& valueType, const std::string& type,
                           ParamSet params) {
    params = completed("texture", std::move(params));
    const TextureParams textureParams(params, state_.textures);
    const TextureRequest request{
        textureParams, staticTransform("textures", params.pos()), files_, textureFiles_, dialect_, scene_->origin};
    if (valueType == "float") {
        auto texture = makeFloatTexture(type, request);
        state_.textures.scalarCosts.set(name, costAbove(textureParams.cost(), params));
        state_.textures.scalars.set(name, std::move(texture));
    } else if (valueType == "spectrum" || valueType == "color") {
        auto texture = makeRgbTexture(type, request);
        state_.textures.colorCosts.set(name, costAbove(textureParams.cost(), params));
        state_.textures.colors.set(name, std::move(texture));
    } else {
        fail(params.pos(), "texture '" + name + "' must be of type 'float' or 'spectrum', not '" + valueType + "'");
    }
    params.warnUnused();
}

void SceneBuilder::light(const std::string& type, ParamSet params) {
    params = completed("light", std::move(params));
    const Transform toWorld = fromFile_ * staticTransform("lights", params.pos());
    SourceLight made = make_.light(type, params, toWorld, fromFile_, files_);
    if (!made.light) return;
    if (made.bulb) {
        if (!isWithinReach(made.bulb->bounds()))
            fail(params.pos(), "the " + params.owner() + " reaches farther from the origin than 1e18");
        Primitive& bulb = scene_->primitives.emplace_back();
        bulb.shape = made.bulb;
        bulb.areaLight = made.area;
        bulb.visibleToCamera = false;
    }
    scene_->lights.push_back(std::move(made.light));
}

void SceneBuilder::areaLight(const std::string& type, ParamSet params) {
    state_.areaLight = make_.areaLight(type, completed("light", std::move(params)), files_);
}

void SceneBuilder::makeNamedMedium(const std::string& name, ParamSet params) {
    params = completed("medium", std::move(params));
    media_.define(name, makeMedium(params, dialect_));
    params.warnUnused();
}

void SceneBuilder::mediumInterface(const Token& inside, const Token& outside) {
    state_.media = {media_.named(inside.value(), inside.pos), media_.named(outside.value(), outside.pos)};
}

void SceneBuilder::shape(const std::string& type, ParamSet params) {
    params = completed("shape", std::move(params));
    const bool moves = state_.ctm.isAnimated();  // if so, the transformation is applied by an instance
    const ShapeContext context{
        params,   state_.textures, files_, moves ? Transform() : placement().start(), state_.reverseOrientation,
        dialect_, curvePiecesLeft_};
    auto geometry = make_.shape(type, context);
    if (!geometry) return;
    if (geometry->curves) curvePiecesLeft_ -= geometry->curves->pieceCount();
    if (geometry->shape && !isWithinReach(geometry->shape->bounds()))
        fail(params.pos(), "the " + params.owner() + " reaches farther from the origin than 1e18");
    PendingPrimitive pending;
    pending.pos = params.pos();
    pending.object = moves ? movingObject(params.owner(), params.pos()) : openObject_;
    pending.geometry = std::move(*geometry);
    pending.primitive.shape = pending.geometry.shape;
    pending.primitive.alpha = pending.geometry.alpha;
    pending.primitive.shadowAlpha = pending.geometry.shadowAlpha;
    pending.primitive.alphaIsShare = pending.geometry.alphaIsShare;
    pending.primitive.visibleToCamera = params.getBool("visibletocamera", true);
    pending.primitive.visibleToDiffuse = params.getBool("visibletodiffuse", true);
    const bool blocks = params.getBool("blockslight", true);
    pending.primitive.media = state_.media;
    pending.primitive.material = make_.materialOfShape(*state_.material, params, materialSources());
    params.warnUnused();
    takeFromMaterial(pending.primitive);
    const AreaLightBuilder areaLight = areaLightOf(pending.primitive);
    const bool isInterface = !pending.primitive.material;
    if (!blocks) pending.primitive.material = nullptr;
    if (!areaLight && placedAt(params.pos(), [&] { return joinCurves(pending); })) return;
    if (areaLight && openObject_) {
        warn(params.pos(), "shapes of an instanced object cannot be area lights; it does not emit");
    } else if (areaLight && moves) {
        warn(params.pos(), "shapes that move cannot be area lights; it does not emit");
    } else if (areaLight && dialect_ == Dialect::V4 && isInterface) {
        warn(params.pos(),
             "as in pbrt-v4, a shape with the material 'interface' cannot be an area light; it does not emit");
    } else if (areaLight) {
        pending.areaLight = areaLight;
        pending.lightSlot = scene_->lights.size();
        scene_->lights.push_back(nullptr);
    }
    if (keepsNames_) pending.primitive.name = nameOf(type, pending.geometry, pending.pos);
    pending_.push_back(std::move(pending));
}

uint32_t SceneBuilder::nameOf(const std::string& shape, const Geometry& geometry, const SourcePos& pos) {
    const MaterialInstance& material = *state_.material;
    const SourceLocation at = pos.location();
    return scene_->names.add({.material = material.name,
                              .materialKind = material.type.empty() ? "none" : std::string_view(material.type),
                              .shapeKind = shape,
                              .meshFile = geometry.meshFile,
                              .file = at.file,
                              .line = at.line});
}

void SceneBuilder::takeFromMaterial(Primitive& primitive) const {
    if (!primitive.material || !primitive.material->opacity()) return;
    const FloatTexturePtr& opacity = primitive.material->opacity();
    primitive.alpha = primitive.alpha ? makeScaleTexture<float>(primitive.alpha, opacity) : opacity;
    primitive.alphaIsShare = true;
}

AreaLightBuilder SceneBuilder::areaLightOf(const Primitive& primitive) {
    if (state_.areaLight || !primitive.material || !primitive.material->emission()) return state_.areaLight;
    const RgbTexturePtr& texture = primitive.material->emission();
    auto [entry, isNew] = emissions_.try_emplace(texture, Rgb(0.f));
    if (isNew) entry->second = emissionOf(*texture);
    return [emission = entry->second](const Primitive& of) { return makeDiffuseAreaLight(of, emission, true); };
}

bool SceneBuilder::joinCurves(const PendingPrimitive& next) {
    if (!next.geometry.curves || pending_.empty()) return false;
    PendingPrimitive& last = pending_.back();
    const bool alike =
        last.geometry.curves && last.geometry.curves->looksLike(*next.geometry.curves) && last.object == next.object &&
        last.primitive.material == next.primitive.material && last.primitive.alpha == next.primitive.alpha &&
        last.primitive.shadowAlpha == next.primitive.shadowAlpha && last.primitive.media == next.primitive.media &&
        last.primitive.visibleToCamera == next.primitive.visibleToCamera &&
        last.primitive.visibleToDiffuse == next.primitive.visibleToDiffuse;
    if (last.areaLight || !alike) return false;
    last.geometry.curves->append(*next.geometry.curves);
    return true;
}

TransformSet SceneBuilder::placement() const {
    if (openObject_ || scene_->origin == Vec3(0.f)) return state_.ctm;
    return {{fromFile_ * state_.ctm.at[0], fromFile_ * state_.ctm.at[1]}};
}

const Transform& SceneBuilder::staticTransform(const std::string& what, const SourcePos& pos) const {
    if (state_.ctm.isAnimated()) warn(pos, what + " cannot move; the transformation of the start time is used");
    return state_.ctm.start();
}

AnimatedTransform SceneBuilder::motionOf(const std::string& what, const SourcePos& pos) const {
    const TransformSet ctm = placement();
    if (ctm.at[0].swapsHandedness() != ctm.at[1].swapsHandedness())
        fail(pos, "the " + what +
                      " cannot move from a place to one where it is mirrored: it would be flat on the way. Its "
                      "transformation must mirror at both of the two times, or at neither");
    return ctm.animated();
}

size_t SceneBuilder::movingObject(const std::string& shape, const SourcePos& pos) {
    if (movingObject_ && movingObject_->within == openObject_ && movingObject_->ctm == state_.ctm)
        return movingObject_->object;
    const AnimatedTransform motion = motionOf(shape, pos);
    const size_t object = scene_->objects.size();
    scene_->objects.push_back({openObject_ ? scene_->objects[*openObject_].name : "", {}});
    if (openObject_)
        movingParts_[*openObject_].push_back({object, motion});
    else
        addInstance(object, motion, pos);
    movingObject_ = {object, openObject_, state_.ctm};
    return object;
}

void SceneBuilder::checkComplete(const SourcePos& end) const {
    if (worldEnded_) return;
    if (!blocks_.empty())
        fail(end, "the file ends before the " + blocks_.back().kind + "End of " + blocks_.back().kind + "Begin in " +
                      placeOf(blocks_.back().pos));
    if (worldBegin_ && !make_.needsWorldEnd) return;
    if (worldBegin_) fail(end, "the file ends before the WorldEnd of WorldBegin in " + placeOf(*worldBegin_));
    fail(end, "the file ends without a WorldBegin");
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
        p.geometry.loadMesh = nullptr;  // frees the data that it owns
    });
}

void SceneBuilder::makeAreaLights() {
    forEachPending([](PendingPrimitive& p) {
        if (p.areaLight) p.primitive.areaLight = placedAt(p.pos, [&] { return p.areaLight(p.primitive); });
    });
    for (const PendingPrimitive& p : pending_)
        if (p.lightSlot) scene_->lights[*p.lightSlot] = p.primitive.areaLight;
}

void SceneBuilder::forEachPending(const std::function<void(PendingPrimitive&)>& work) {
    // Errors are stored by position, so that the first one in the file is reported, whichever thread found one first.
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

std::unique_ptr<Scene> SceneBuilder::finish(const LoadOptions& options) {
    RenderSettings& settings = scene_->settings;
    settings.filter = make_.filter(filter_.type, filter_.params);
    const Overrides overrides(options.overrides,
                              {{"film", film_.type, film_.params, make_.film},
                               {"sampler", sampler_.type, sampler_.params, make_.sampler},
                               {"integrator", integrator_.type, integrator_.params, make_.integrator}});
    make_.film(film_.type, film_.params, settings);
    make_.sampler(sampler_.type, sampler_.params, settings);
    make_.integrator(integrator_.type, integrator_.params, settings);
    if (dialect_ == Dialect::V4) {
        settings.filmScale *= exposureTimeV4(camera_.params);
        settings.maxSampleLuminance /= settings.filmScale;  // the limit applies to the exposed picture
    }
    if (options.resolution) {
        settings.film.width = options.resolution->width;
        settings.film.height = options.resolution->height;
        settings.filmAt = {};
    }
    const Transform toFile = fromFile_.inverse();
    const TransformSet inScene = {{worldToCamera_.at[0] * toFile, worldToCamera_.at[1] * toFile}};
    scene_->camera =
        make_.camera(camera_.type, camera_.params, {inScene.animated(), transformTimes_}, settings.film, files_);

    scene_->media = media_.finish();
    loadMeshes(options);
    makeAreaLights();
    finishTextures();
    for (PendingPrimitive& p : pending_) {
        auto& primitives = p.object ? scene_->objects[*p.object].primitives : scene_->primitives;
        primitives.push_back(std::move(p.primitive));
    }
    pending_.clear();
    std::erase_if(scene_->instances,
                  [&](const Instance& i) { return scene_->objects[size_t(i.object)].primitives.empty(); });
    return std::move(scene_);
}

}  // namespace drc::pbrt
