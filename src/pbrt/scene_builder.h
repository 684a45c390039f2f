// What the directives do: each changes the graphics state or adds to the scene. Knows nothing of tokens.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pbrt/dialect_factories.h"
#include "pbrt/file_search.h"
#include "pbrt/graphics_state.h"
#include "pbrt/instance_budget.h"
#include "pbrt/param_parser.h"
#include "pbrt/scene_file.h"
#include "pbrt/texture_factory.h"
#include "scene/scene.h"

namespace drc::pbrt {

// Every pos is the directive's, for messages. All throw Error for what is wrong and cannot be mended with a warning.
class SceneBuilder {
  public:
    SceneBuilder(const FileSearch& files, Dialect dialect);

    // Pieces that the curves to come may be cut into.
    void limitCurves(size_t pieces) { curvePiecesLeft_ = pieces; }

    // Transformations. apply multiplies the current one from the right.
    void apply(const Transform& t, const SourcePos& pos);
    void setTransform(const Transform& t, const SourcePos& pos);
    void setActiveTransforms(bool start, bool end);
    // When the two current transformations hold.
    void transformTimes(float start, float end, const SourcePos& pos);
    void nameCoordinateSystem(const std::string& name);
    void useCoordinateSystem(const std::string& name, const SourcePos& pos);

    // Before WorldBegin. The last of each counts.
    void camera(const std::string& type, ParamSet params);
    void film(const std::string& type, ParamSet params);
    void filter(const std::string& type, ParamSet params);
    void sampler(const std::string& type, ParamSet params);
    void integrator(const std::string& type, ParamSet params);

    bool inWorld() const { return worldBegin_.has_value(); }
    void worldBegin(const SourcePos& pos);
    // Throws Error for blocks that are still open.
    void worldEnd(const SourcePos& pos);

    // kind: "Attribute", "Transform", "Import".
    void beginBlock(const std::string& kind, const SourcePos& pos);
    void endBlock(const std::string& kind, const SourcePos& pos);
    void objectBegin(const std::string& name, const SourcePos& pos);
    void objectEnd(const SourcePos& pos);
    void objectInstance(const std::string& name, const SourcePos& pos);

    // pbrt-v4's. Throws Error for a target that does not exist.
    void attribute(const std::string& target, const ParamSet& params, const SourcePos& pos);
    void colorSpace(const std::string& name, const SourcePos& pos);
    // By which colours are to be read now.
    ColorRules colorRules(bool isLight) const;

    void reverseOrientation();
    void material(const std::string& type, ParamSet params);
    void makeNamedMaterial(const std::string& name, ParamSet params);
    void namedMaterial(const std::string& name, const SourcePos& pos);
    void texture(const std::string& name, const std::string& valueType, const std::string& type, ParamSet params);
    void light(const std::string& type, ParamSet params);
    void areaLight(const std::string& type, ParamSet params);
    void shape(const std::string& type, ParamSet params);

    // Throws Error, at the end of the file, if the scene is cut short.
    void checkComplete(const SourcePos& end) const;
    // Loads the meshes and gives the scene away.
    std::unique_ptr<Scene> finish(const LoadOptions& options);

  private:
    struct Block {
        std::string kind;
        SourcePos pos;
        GraphicsState saved;
    };
    struct Setting {
        std::string type;
        ParamSet params;
    };
    // A primitive whose mesh is still to be loaded.
    struct PendingPrimitive {
        Primitive primitive;
        Geometry geometry;
        AreaLightBuilder areaLight;
        std::optional<size_t> lightSlot;  // index into Scene::lights that is kept for areaLight
        std::optional<size_t> object;     // index into Scene::objects; none: the scene itself
        SourcePos pos;
    };

    // What moves within an object, in the object's space.
    struct MovingPart {
        size_t object;
        AnimatedTransform motion;
    };

    // The transformation for what cannot move: `what` and pos are those of what is being placed.
    const Transform& staticTransform(const std::string& what, const SourcePos& pos) const;
    // What the current transformation does to `what`, which may move. Throws Error if that cannot be rendered.
    AnimatedTransform motionOf(const std::string& what, const SourcePos& pos) const;
    // The object for shapes that move with the current transformation, of which there is one instance: shapes that come
    // after each other and move alike share it.
    size_t movingObject(const std::string& shape, const SourcePos& pos);
    void addInstance(size_t object, const AnimatedTransform& toWorld, const SourcePos& pos);
    // Adds curves to the ones just before them if they look alike: hair comes as a shape for each.
    bool joinCurves(const PendingPrimitive& next);
    void pop(const std::string& kind, const SourcePos& pos);
    void loadMeshes(const LoadOptions& options);

    // With what Attribute gives to things of that kind.
    ParamSet completed(const std::string& target, ParamSet params) const;

    const FileSearch& files_;
    Dialect dialect_;
    const DialectFactories& make_;
    GraphicsState state_;
    std::vector<Block> blocks_;
    std::map<std::string, TransformSet> coordinateSystems_;
    TextureFiles textureFiles_;

    Setting camera_, film_, filter_, sampler_, integrator_;
    TransformSet worldToCamera_;
    std::array<float, 2> transformTimes_{0, 1};

    std::optional<SourcePos> worldBegin_;
    bool worldEnded_ = false;
    std::optional<size_t> openObject_;
    std::map<std::string, size_t> objects_;
    std::map<size_t, std::vector<MovingPart>> movingParts_;  // by index into Scene::objects
    // The latest movingObject, the object that was open then, and the transformation.
    struct MovingObject {
        size_t object;
        std::optional<size_t> within;
        TransformSet ctm;
    };
    std::optional<MovingObject> movingObject_;
    InstanceBudget instances_;
    size_t curvePiecesLeft_ = limits::kCurvePieces;
    std::vector<PendingPrimitive> pending_;
    std::unique_ptr<Scene> scene_ = std::make_unique<Scene>();
};

}  // namespace drc::pbrt
