#include "pbrt/scene_builder.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/limits.h"
#include "base/suggest.h"
#include "pbrt/medium_factory.h"
#include "pbrt/overrides.h"
#include "pbrt/scene_limits.h"

namespace drc::pbrt {
SceneBuilder::SceneBuilder(const FileSearch& files, Dialect dialect, const Vec3& origin)
    : files_(files),
      dialect_(dialect),
      fromFile_(Transform::translate(-origin)),
      make_(factoriesOf(dialect)),
      blocks_(dialect),
      media_(dialect) {
    scene_->origin = origin;
    state_.textures.dialect = dialect;
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

void SceneBuilder::list(SceneListing& listing) {
    recorder_.emplace(listing, files_);
    recorder_->material(make_.defaultMaterial, "", ParamSet(), state_.textures);
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

void SceneBuilder::nameCoordinateSystem(const std::string& name) { coordinateSystems_[named(name)] = state_.ctm; }

void SceneBuilder::useCoordinateSystem(const std::string& name, const SourcePos& pos) {
    const auto found = coordinateSystems_.find(named(name));
    if (found == coordinateSystems_.end()) {
        std::vector<std::string_view> names;
        for (const auto& entry : coordinateSystems_) names.push_back(entry.first);
        warn(pos, "no coordinate system '" + name + "' has been named; the transformation stays as it is" +
                      suggestion(name, names));
        return;
    }
    state_.ctm = found->second;
}

void SceneBuilder::overrideCamera(const CameraOverride& camera) {
    cameraOverride_ = camera;
    worldToCamera_ = camera.placed({});  // for files without a camera
}

void SceneBuilder::camera(const std::string& type, ParamSet params) {
    camera_ = {type, std::move(params)};
    motionOf("camera", camera_.params.pos());
    worldToCamera_ = cameraOverride_.placed(state_.ctm);
    scene_->sensor.medium = state_.media.outside;
    if (recorder_) recorder_->listing().cameraMedium = state_.listed.outside;
    coordinateSystems_["camera"] = worldToCamera_.inverse();
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
    if (!blocks_.empty()) warn(pos, "WorldEnd comes before the " + blocks_.innermost());
    worldEnded_ = true;
}

void SceneBuilder::beginBlock(const std::string& kind, const SourcePos& pos) {
    blocks_.begin(kind, pos, state_);
    if (kind == "Import") savedSystems_.push_back(coordinateSystems_);
}

void SceneBuilder::endBlock(const std::string& kind, const SourcePos& pos) {
    blocks_.end(kind, pos, state_);
    if (kind != "Import") return;
    // Coordinate systems named in an imported file are local to that file.
    coordinateSystems_ = std::move(savedSystems_.back());
    savedSystems_.pop_back();
}

void SceneBuilder::objectBegin(const std::string& name, const SourcePos& pos) {
    if (openObject_ && dialect_ == Dialect::V4) fail(pos, "ObjectBegin inside of another object");
    if (openObject_) warn(pos, "ObjectBegin inside of another object, which ends here");
    beginBlock("Object", pos);
    warnIfRedefined(objects_.contains(named(name)), kObjectName, name, pos);
    if (recorder_) recorder_->objectBegin(name, named(name), pos);
    openObject_ = scene_->objects.size();
    objects_[named(name)] = *openObject_;
    scene_->objects.push_back({name, {}});
    objectToFile_[*openObject_] = state_.ctm.start();
}

void SceneBuilder::objectEnd(const SourcePos& pos) {
    endBlock("Object", pos);
    openObject_.reset();
    if (recorder_) recorder_->objectEnd();
}

void SceneBuilder::addInstance(size_t object, const AnimatedTransform& toWorld, uint32_t number, const SourcePos& pos) {
    checkPlacement(toWorld, pos);
    const Instance instance{int(object), toWorld, number};
    instances_.take(instance, pos);
    scene_->instances.push_back(instance);
}

std::vector<std::string_view> SceneBuilder::namesOfObjects() const {
    std::vector<std::string_view> names;
    for (const auto& entry : objects_) names.push_back(entry.first);
    return names;
}

void SceneBuilder::objectInstance(const std::string& name, const SourcePos& pos) {
    const uint32_t number = numbers_.next();
    if (openObject_) {
        const std::string complaint = "ObjectInstance inside of an object: objects cannot be nested";
        if (dialect_ == Dialect::V4) fail(pos, complaint);
        warn(pos, complaint + "; the instance is left out");
        return;
    }
    const AnimatedTransform toWorld = motionOf("object '" + name + "'", pos);
    if (recorder_) recorder_->instance(named(name), state_.ctm, pos);
    const auto place = [this, key = named(name), toWorld, inFile = state_.ctm.animated(), number, pos] {
        const size_t object = placeInstance(key, toWorld, number, pos);
        scene_->placements.add(number, inFile * AnimatedTransform(objectToFile_.at(object)));
    };
    try {
        place();
    } catch (const UndefinedName&) {
        if (dialect_ == Dialect::V4)
            later_.use(place);
        else
            warn(pos, "no object '" + name + "' has been defined; the instance is left out" +
                          suggestion(name, namesOfObjects()));
    }
}

size_t SceneBuilder::placeInstance(const std::string& name, const AnimatedTransform& toWorld, uint32_t number,
                                   const SourcePos& pos) {
    const auto found = objects_.find(name);
    if (found == objects_.end())
        throw UndefinedName(kObjectName, name, pos,
                            "no object '" + name + "' has been defined" + suggestion(name, namesOfObjects()));
    addInstance(found->second, toWorld, number, pos);
    for (const MovingPart& part : movingParts_[found->second])
        addInstance(part.object, toWorld * part.motion, number, pos);
    return found->second;
}

void SceneBuilder::reverseOrientation() { state_.reverseOrientation = !state_.reverseOrientation; }

void SceneBuilder::attribute(const std::string& target, const ParamSet& params, const SourcePos& pos) {
    const std::vector<std::string_view> targets = {"light", "material", "medium", "shape", "texture"};
    if (std::find(targets.begin(), targets.end(), target) == targets.end())
        fail(pos, "unknown target '" + target + "' of Attribute" + suggestion(target, targets));
    // If a name occurs several times, the last value counts.
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

void SceneBuilder::warnIfRedefined(bool isKnown, const std::string& kind, const std::string& name,
                                   const SourcePos& pos) const {
    if (isKnown && dialect_ == Dialect::V4)
        warn(pos, "a " + kind + " '" + name +
                      "' has been defined before, which pbrt-v4 refuses; this one counts for what comes after it");
}

std::shared_ptr<const MaterialInstance> SceneBuilder::makeMaterial(const std::string& type, ParamSet params,
                                                                   const std::string& name) {
    params = completed("material", std::move(params));
    const size_t listed = recorder_ ? recorder_->material(type, name, params, state_.textures) : 0;
    auto instance = std::make_shared<MaterialInstance>();
    const auto make = [this, instance, type, params, name, listed] {
        *instance = *make_.material(type, params, materialSources());
        instance->name = name;
        instance->listed = listed;
    };
    try {
        make();
    } catch (const UndefinedName&) {
        *instance = {type, {}, nullptr, name, true, listed};
        later_.define(kMaterialName, name, make);
    }
    return instance;
}

void SceneBuilder::material(const std::string& type, ParamSet params) {
    state_.material = makeMaterial(type, std::move(params), "");
}

void SceneBuilder::makeNamedMaterial(const std::string& name, ParamSet params) {
    const Param* type = params.find("type", {ParamType::String});
    if (type == nullptr) fail(params.pos(), "the named material '" + name + "' needs the parameter \"string type\"");
    const std::string typeName = params.getString("type", "");
    const std::string key = named(name);
    warnIfRedefined(state_.namedMaterials.find(key) != nullptr, kMaterialName, name, params.pos());
    state_.namedMaterials.set(key, makeMaterial(typeName, std::move(params), key));
}

void SceneBuilder::namedMaterial(const std::string& name, const SourcePos& pos) {
    const std::string key = named(name);
    if (auto found = state_.namedMaterials.find(key)) {
        state_.material = std::move(found);
    } else if (dialect_ == Dialect::V4) {
        state_.material = laterMaterial(key, pos);
    } else {
        warn(pos, "no material '" + name + "' has been named; the material before it stays" +
                      suggestion(name, state_.namedMaterials.names()));
    }
}

std::shared_ptr<const MaterialInstance> SceneBuilder::laterMaterial(const std::string& name, const SourcePos& pos) {
    std::shared_ptr<const MaterialInstance>& known = laterMaterials_[name];
    if (known) return known;
    const auto instance = std::make_shared<MaterialInstance>();
    instance->awaited = true;
    instance->name = name;
    later_.use([this, instance, name, pos] {
        const auto found = state_.namedMaterials.find(name);
        if (!found || found->awaited)
            throw UndefinedName(
                kMaterialName, name, pos,
                "no material '" + name + "' has been named" + suggestion(name, state_.namedMaterials.names()));
        *instance = *found;
    });
    return known = instance;
}

void SceneBuilder::texture(const std::string& name, const std::string& valueType, const std::string& type,
                           ParamSet params) {
    params = completed("texture", std::move(params));
    const bool isFloat = valueType == "float";
    if (!isFloat && valueType != "spectrum" && valueType != "color")
        fail(params.pos(), "texture '" + name + "' must be of type 'float' or 'spectrum', not '" + valueType + "'");
    const std::string key = named(name), kind = isFloat ? kFloatTextureName : kSpectrumTextureName;
    const bool isKnown =
        isFloat ? state_.textures.scalars.find(key) != nullptr : state_.textures.colors.find(key) != nullptr;
    warnIfRedefined(isKnown, kind, name, params.pos());
    if (recorder_) recorder_->texture({{{type, name, {}, {}}, state_.ctm}, isFloat}, key, params, state_.textures);
    const auto define = [this, key, isFloat, type, params, toWorld = staticTransform("textures", params.pos())] {
        defineTexture(key, isFloat, type, params, toWorld);
    };
    try {
        define();
    } catch (const UndefinedName&) {
        later_.define(kind, key, define);
    }
}

void SceneBuilder::defineTexture(const std::string& name, bool isFloat, const std::string& type, const ParamSet& params,
                                 const Transform& toWorld) {
    const TextureParams textureParams(params, state_.textures);
    const TextureRequest request{textureParams, toWorld, files_, textureFiles_, dialect_, scene_->origin};
    if (isFloat) {
        auto texture = makeFloatTexture(type, request);
        state_.textures.scalarCosts.set(name, costAbove(textureParams.cost(), params));
        state_.textures.scalars.set(name, std::move(texture));
    } else {
        auto texture = makeRgbTexture(type, request);
        state_.textures.colorCosts.set(name, costAbove(textureParams.cost(), params));
        state_.textures.colors.set(name, std::move(texture));
    }
    params.warnUnused();
}

void SceneBuilder::light(const std::string& type, ParamSet params) {
    params = completed("light", std::move(params));
    if (recorder_) recorder_->light(type, params, state_.ctm);
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
    params = completed("light", std::move(params));
    if (recorder_) state_.listed.areaLight = recorder_->areaLight(type, params);
    state_.areaLight = make_.areaLight(type, params, files_);
}

void SceneBuilder::makeNamedMedium(const std::string& name, ParamSet params) {
    params = completed("medium", std::move(params));
    warnIfRedefined(media_.isDefined(named(name)), "medium", name, params.pos());
    if (recorder_) recorder_->medium(name, params);
    media_.define(named(name), makeMedium(params, dialect_));
    params.warnUnused();
}

void SceneBuilder::mediumInterface(const Token& inside, const Token& outside) {
    state_.media = {media_.named(named(inside.value()), inside.pos), media_.named(named(outside.value()), outside.pos)};
    state_.listed.inside = inside.value();
    state_.listed.outside = outside.value();
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
        addInstance(object, motion, 0, pos);
    movingObject_ = {object, openObject_, state_.ctm};
    return object;
}

void SceneBuilder::checkComplete(const SourcePos& end) const {
    if (worldEnded_) return;
    if (!blocks_.empty()) fail(end, "the file ends before the " + blocks_.innermost());
    if (worldBegin_ && !make_.needsWorldEnd) return;
    if (worldBegin_) fail(end, "the file ends before the WorldEnd of WorldBegin in " + worldBegin_->lineOfFile());
    fail(end, "the file ends without a WorldBegin");
}

void SceneBuilder::finishListing() {
    SceneListing& listing = recorder_->listing();
    listing.origin = scene_->origin;
    listing.transformTimes = transformTimes_;
    recorder_->setting(listing.camera, camera_.type, camera_.params);
    listing.camera.toWorld = worldToCamera_.inverse();
    recorder_->film(film_.type, film_.params);
    recorder_->setting(listing.filter, filter_.type, filter_.params);
    recorder_->setting(listing.sampler, sampler_.type, sampler_.params);
    recorder_->setting(listing.integrator, integrator_.type, integrator_.params);
    for (const PendingPrimitive& p : pending_)
        if (p.primitive.mesh) recorder_->mesh(p.listed, p.primitive.mesh);
    recorder_->finish(state_.textures);
}

std::unique_ptr<Scene> SceneBuilder::finish(const LoadOptions& options) {
    RenderSettings& settings = scene_->sensor.settings;
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
    cameraOverride_.applyFov(camera_.type, camera_.params);
    scene_->sensor.camera =
        make_.camera(camera_.type, camera_.params, {inScene.animated(), transformTimes_}, settings.film, files_);

    later_.finish();
    for (PendingPrimitive& p : pending_) {
        media_.forgetUndefined(p.primitive.media.inside);
        media_.forgetUndefined(p.primitive.media.outside);
    }
    media_.forgetUndefined(scene_->sensor.medium);
    scene_->media = media_.finish();
    if (kept_) takeKept();
    loadMeshes(options);
    makeAreaLights();
    finishTextures();
    if (kept_) keepContents();
    if (recorder_) finishListing();
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
