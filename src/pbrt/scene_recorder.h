// Fills a SceneListing while SceneBuilder reads a scene. SceneBuilder calls one function for each directive, with the
// directive's parameters, completed by those of pbrt-v4's Attribute.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "pbrt/file_search.h"
#include "pbrt/material_factory.h"
#include "pbrt/scene_listing.h"

namespace drc::pbrt {

class SceneRecorder {
  public:
    // Empties the listing. Both arguments must outlive this object.
    SceneRecorder(SceneListing& listing, const FileSearch& files);

    void medium(const std::string& name, const ParamSet& params);
    // Adds the texture to the listing, and its index to `textures` under `key`.
    void texture(ListedTexture texture, const std::string& key, const ParamSet& params, NamedTextures& textures);
    // Both return the index of what they add.
    size_t material(const std::string& type, const std::string& name, const ParamSet& params,
                    const NamedTextures& textures);
    size_t areaLight(const std::string& type, const ParamSet& params);
    void light(const std::string& type, const ParamSet& params, const TransformSet& toWorld);
    // Returns the index of the shape, for mesh().
    size_t shape(const std::string& type, const ParamSet& params, const GraphicsState& state);
    // Keys are names as the dialect compares them.
    void objectBegin(const std::string& name, const std::string& key, const SourcePos& pos);
    void objectEnd() { openObject_.reset(); }
    void instance(const std::string& key, const TransformSet& toWorld, const SourcePos& pos);

    // The following are for the end of the file, when everything has been defined and loaded.
    void film(const std::string& type, const ParamSet& params);
    // For the other settings; `setting` is part of the listing.
    void setting(ListedDirective& setting, const std::string& type, const ParamSet& params);
    void mesh(size_t shape, const TriangleMeshPtr& mesh) { listing_.shapes[shape].mesh = mesh; }
    void finish(const NamedTextures& textures);
    SceneListing& listing() { return listing_; }

  private:
    // textures: null if parameters cannot name textures.
    ListedDirective directive(const std::string& type, const std::string& name, const ParamSet& params,
                              const NamedTextures* textures = nullptr) const;
    ListedParam listed(const Param& param) const;
    std::vector<std::string> withPaths(const Param& param) const;

    SceneListing& listing_;
    const FileSearch& files_;
    std::optional<size_t> openObject_;
    std::map<std::string, size_t> objects_;
    std::vector<std::pair<size_t, std::string>> laterInstances_;              // with the key of the object
    std::vector<std::shared_ptr<const MaterialInstance>> materialsOfShapes_;  // some are defined later
};

}  // namespace drc::pbrt
