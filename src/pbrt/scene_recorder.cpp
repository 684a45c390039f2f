#include "pbrt/scene_recorder.h"

#include "pbrt/file_params.h"

namespace drc::pbrt {
namespace {

// Sets the textures that the parameter names, as far as they are defined.
void resolveTexture(ListedParam& param, const NamedTextures& textures) {
    if (param.typeName != "texture" || param.strings.size() != 1) return;
    const auto indexIn = [&](const NamedMap<size_t>& names, std::optional<size_t>& index) {
        if (const auto found = names.find(param.strings[0]); found && !index) index = *found;
    };
    indexIn(textures.colorsListed, param.spectrumTexture);
    indexIn(textures.scalarsListed, param.floatTexture);
}

void resolveTextures(ListedDirective& directive, const NamedTextures& textures) {
    for (ListedParam& param : directive.params) resolveTexture(param, textures);
}

}  // namespace

SceneRecorder::SceneRecorder(SceneListing& listing, const FileSearch& files) : listing_(listing), files_(files) {
    listing_ = {};
}

std::vector<std::string> SceneRecorder::withPaths(const Param& param) const {
    std::vector<std::string> result = param.strings;
    if (namesFile(param.typeName, param.name))
        for (std::string& name : result) name = absolutePath(name, param.valuePos, files_);
    return result;
}

ListedParam SceneRecorder::listed(const Param& param) const {
    return {.typeName = param.typeName,
            .name = param.name,
            .at = param.pos.location(),
            .numbers = param.numbers,
            .strings = withPaths(param),
            .bools = param.bools,
            .colors = param.colors,
            .spectrumTexture = {},
            .floatTexture = {}};
}

ListedDirective SceneRecorder::directive(const std::string& type, const std::string& name, const ParamSet& params,
                                         const NamedTextures* textures) const {
    ListedDirective result{type, name, params.pos().location(), {}};
    for (const Param& param : params.all()) result.params.push_back(listed(param));
    if (textures) resolveTextures(result, *textures);
    return result;
}

void SceneRecorder::setting(ListedDirective& setting, const std::string& type, const ParamSet& params) {
    setting = directive(type, "", params);
}

void SceneRecorder::film(const std::string& type, const ParamSet& params) {
    listing_.film = directive(type, "", params);
    // A film's file is written, and keeps the name that the scene gives it.
    for (size_t i = 0; i < params.all().size(); ++i) listing_.film.params[i].strings = params.all()[i].strings;
}

void SceneRecorder::medium(const std::string& name, const ParamSet& params) {
    listing_.media.push_back(directive(params.getString("type", "homogeneous"), name, params));
}

void SceneRecorder::texture(ListedTexture texture, const std::string& key, const ParamSet& params,
                            NamedTextures& textures) {
    // A texture may replace one of its own name, and be made of it.
    static_cast<ListedDirective&>(texture) = directive(texture.type, texture.name, params, &textures);
    NamedMap<size_t>& names = texture.isFloat ? textures.scalarsListed : textures.colorsListed;
    names.set(key, std::make_shared<const size_t>(listing_.textures.size()));
    listing_.textures.push_back(std::move(texture));
}

size_t SceneRecorder::material(const std::string& type, const std::string& name, const ParamSet& params,
                               const NamedTextures& textures) {
    listing_.materials.push_back(directive(type, name, params, &textures));
    return listing_.materials.size() - 1;
}

size_t SceneRecorder::areaLight(const std::string& type, const ParamSet& params) {
    listing_.areaLights.push_back(directive(type, "", params));
    return listing_.areaLights.size() - 1;
}

void SceneRecorder::light(const std::string& type, const ParamSet& params, const TransformSet& toWorld) {
    listing_.lights.push_back({directive(type, "", params), toWorld});
}

size_t SceneRecorder::shape(const std::string& type, const ParamSet& params, const GraphicsState& state) {
    listing_.shapes.push_back({{directive(type, "", params, &state.textures), state.ctm},
                               state.reverseOrientation,
                               0,
                               state.listed.areaLight,
                               openObject_,
                               state.listed.inside,
                               state.listed.outside,
                               nullptr});
    materialsOfShapes_.push_back(state.material);
    return listing_.shapes.size() - 1;
}

void SceneRecorder::objectBegin(const std::string& name, const std::string& key, const SourcePos& pos) {
    openObject_ = objects_[key] = listing_.objects.size();
    listing_.objects.push_back({name, pos.location()});
}

void SceneRecorder::instance(const std::string& key, const TransformSet& toWorld, const SourcePos& pos) {
    ListedInstance instance{pos.location(), {}, toWorld};
    if (const auto found = objects_.find(key); found != objects_.end())
        instance.object = found->second;
    else
        laterInstances_.emplace_back(listing_.instances.size(), key);
    listing_.instances.push_back(std::move(instance));
}

void SceneRecorder::finish(const NamedTextures& textures) {
    for (size_t i = 0; i < listing_.shapes.size(); ++i) listing_.shapes[i].material = materialsOfShapes_[i]->listed;
    // In pbrt-v3, a name means nothing before its definition.
    if (textures.dialect == Dialect::V3) return;
    for (ListedTexture& texture : listing_.textures) resolveTextures(texture, textures);
    for (ListedDirective& material : listing_.materials) resolveTextures(material, textures);
    for (ListedShape& shape : listing_.shapes) resolveTextures(shape, textures);
    for (const auto& [instance, key] : laterInstances_)
        if (const auto found = objects_.find(key); found != objects_.end())
            listing_.instances[instance].object = found->second;
}

}  // namespace drc::pbrt
