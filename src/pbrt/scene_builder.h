// Executes directives: each changes the graphics state or adds to the scene. Independent of tokens and files.
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pbrt/blocks.h"
#include "pbrt/dialect_factories.h"
#include "pbrt/file_search.h"
#include "pbrt/graphics_state.h"
#include "pbrt/instance_budget.h"
#include "pbrt/kept_contents.h"
#include "pbrt/later_names.h"
#include "pbrt/normalized_name.h"
#include "pbrt/object_numbers.h"
#include "pbrt/param_parser.h"
#include "pbrt/scene_file.h"
#include "pbrt/scene_media.h"
#include "pbrt/scene_recorder.h"
#include "pbrt/texture_factory.h"
#include "pbrt/tokenizer.h"
#include "scene/scene.h"

namespace drc::pbrt {

// Every pos is the directive's, for messages. All functions throw Error for faults that a warning is not enough for.
class SceneBuilder {
  public:
    // origin: Scene::origin. The graphics state stays in the file's coordinates.
    SceneBuilder(const FileSearch& files, Dialect dialect, const Vec3& origin = Vec3(0.f));

    // Sets the maximum number of pieces into which all later curves together may be split.
    void limitCurves(size_t pieces) { curvePiecesLeft_ = pieces; }

    // Overrides the placement and the field of view of the cameras that the file defines from now on.
    void overrideCamera(const CameraOverride& camera);

    // Fills Scene::names with the file's names for each surface. Call before the first shape.
    void keepNames() { keepsNames_ = true; }

    // Takes contents over from the frame before, and gives it those of this scene at the end (LoadOptions::kept). Call
    // before the first texture and shape.
    void reuse(KeptContents& kept) {
        kept_ = &kept;
        textureFiles_.reuse(kept);
    }

    // Fills the listing, which must outlive this object. Call before the first directive.
    void list(SceneListing& listing);

    // Transformations. apply() multiplies the current transformation from the right.
    void apply(const Transform& t, const SourcePos& pos);
    void setTransform(const Transform& t, const SourcePos& pos);
    void setActiveTransforms(bool start, bool end);
    // Sets the times of the two current transformations.
    void transformTimes(float start, float end, const SourcePos& pos);
    void nameCoordinateSystem(const std::string& name);
    void useCoordinateSystem(const std::string& name, const SourcePos& pos);

    // These must come before WorldBegin. If one is given several times, the last one counts.
    void camera(const std::string& type, ParamSet params);
    void film(const std::string& type, ParamSet params);
    void filter(const std::string& type, ParamSet params);
    void sampler(const std::string& type, ParamSet params);
    void integrator(const std::string& type, ParamSet params);

    bool inWorld() const { return worldBegin_.has_value(); }
    void worldBegin(const SourcePos& pos);
    void worldEnd(const SourcePos& pos);

    // kind: "Attribute", "Transform", "Import".
    void beginBlock(const std::string& kind, const SourcePos& pos);
    void endBlock(const std::string& kind, const SourcePos& pos);
    void objectBegin(const std::string& name, const SourcePos& pos);
    void objectEnd(const SourcePos& pos);
    void objectInstance(const std::string& name, const SourcePos& pos);

    // For pbrt-v4. Both throw Error for unknown targets and colour spaces.
    void attribute(const std::string& target, const ParamSet& params, const SourcePos& pos);
    void colorSpace(const std::string& name, const SourcePos& pos);
    // The rules for reading colours in the current graphics state.
    ColorRules colorRules(bool isLight) const;

    void reverseOrientation();
    void material(const std::string& type, ParamSet params);
    void makeNamedMaterial(const std::string& name, ParamSet params);
    void namedMaterial(const std::string& name, const SourcePos& pos);
    void texture(const std::string& name, const std::string& valueType, const std::string& type, ParamSet params);
    void light(const std::string& type, ParamSet params);
    void areaLight(const std::string& type, ParamSet params);
    void shape(const std::string& type, ParamSet params);
    void makeNamedMedium(const std::string& name, ParamSet params);
    // Media by name; in both dialects, they may be defined later. The empty name is empty space.
    void mediumInterface(const Token& inside, const Token& outside);

    // Throws Error, located at the end of the file, if the scene is incomplete.
    void checkComplete(const SourcePos& end) const;
    // Waits for the images of textures. Throws Error at the first one that cannot be read.
    void finishTextures() { textureFiles_.finish(); }
    // Resolves names that were defined after their use, loads meshes, waits for the images of textures, and returns the
    // finished scene.
    std::unique_ptr<Scene> finish(const LoadOptions& options);

  private:
    struct Setting {
        std::string type;
        ParamSet params;
    };
    // A primitive whose mesh has not been loaded yet.
    struct PendingPrimitive {
        Primitive primitive;
        Geometry geometry;
        std::string shape;  // type of the shape
        std::shared_ptr<const MaterialInstance> material;
        AreaLightBuilder areaLight;
        ContentKey key;                   // of the geometry; set if contents are kept
        std::optional<size_t> lightSlot;  // index into Scene::lights, reserved for areaLight
        std::optional<size_t> object;     // index into Scene::objects; none: the scene itself
        size_t listed = 0;                // index into SceneListing::shapes, if there is a listing
        bool inObject = false, moves = false, blocksLight = true;
        SourcePos pos;
        // awaitsNames: the material or a mask is defined later. awaitsMasks: in this case, the shape also has masks.
        bool awaitsNames = false, awaitsMasks = false;
    };

    // An instance that moves within an object, in the object's space.
    struct MovingPart {
        size_t object;
        AnimatedTransform motion;
    };

    // The current transformation, to the space of the open object, or to the scene's world space if none is open.
    TransformSet placement() const;
    // The current transformation, in the file's coordinates, for things that cannot move. Warns if it is animated, and
    // uses the start time. `what` and pos: for messages.
    const Transform& staticTransform(const std::string& what, const SourcePos& pos) const;
    // placement() for something that may move; `what` names it in messages. Throws Error if the motion cannot be
    // rendered.
    AnimatedTransform motionOf(const std::string& what, const SourcePos& pos) const;
    // The object for shapes that move with the current transformation; it has a single instance. Consecutive shapes
    // with the same motion share the object.
    size_t movingObject(const std::string& shape, const SourcePos& pos);
    // number: Instance::objectNumber.
    void addInstance(size_t object, const AnimatedTransform& toWorld, uint32_t number, const SourcePos& pos);
    // Sets what other directives define for a shape: its masks, its material, and whether it is an area light. Throws
    // UndefinedName if one of these is defined later. params: the shape's parameters; pbrt-v4 uses only the masks.
    void dress(PendingPrimitive& p, const ParamSet& params);
    // Multiplies the material's opacity into the primitive's alpha.
    void takeFromMaterial(Primitive& primitive) const;
    // The builder of a shape's area light: from the graphics state, otherwise from the material's emission; empty if
    // the shape does not emit.
    AreaLightBuilder areaLightOf(const PendingPrimitive& p);
    // Adds the entry for a shape to Scene::names and returns its index.
    uint32_t nameOf(const PendingPrimitive& p);
    // Appends curves to the previous shape if both are curves of the same kind, because hair has one shape per curve.
    // Returns false if they differ.
    bool joinCurves(const PendingPrimitive& next);
    MaterialSources materialSources() {
        return {state_.textures, state_.namedMaterials, files_, textureFiles_, bsdfFiles_};
    }
    // Makes a material. If it uses names that are defined later, it is marked as awaited and made by finish().
    std::shared_ptr<const MaterialInstance> makeMaterial(const std::string& type, ParamSet params,
                                                         const std::string& name);
    // A placeholder for the material of a name that is defined later.
    std::shared_ptr<const MaterialInstance> laterMaterial(const std::string& name, const SourcePos& pos);
    // Throws UndefinedName if the texture uses others that are defined later.
    void defineTexture(const std::string& name, bool isFloat, const std::string& type, const ParamSet& params,
                       const Transform& toWorld);
    // Returns the object, an index into Scene::objects. number: Instance::objectNumber. Throws UndefinedName if the
    // object has not been defined.
    size_t placeInstance(const std::string& name, const AnimatedTransform& toWorld, uint32_t number,
                         const SourcePos& pos);
    std::vector<std::string_view> namesOfObjects() const;
    std::string named(const std::string& name) const { return normalizedName(name, dialect_); }
    // In pbrt-v4, warns about a name that is defined twice, which pbrt-v4 itself refuses.
    void warnIfRedefined(bool isKnown, const std::string& kind, const std::string& name, const SourcePos& pos) const;
    void loadMeshes(const LoadOptions& options);
    // Takes over meshes and shapes of the frame before that are the same.
    void takeKept();
    void keepContents();
    // Adds to the listing what is known only at the end of the file.
    void finishListing();
    void makeAreaLights();
    // Calls work for all pending primitives, on all cores, and then rethrows the exception of the first primitive in
    // the file for which work threw.
    void forEachPending(const std::function<void(PendingPrimitive&)>& work);

    // The parameters, together with those that Attribute has set for this target.
    ParamSet completed(const std::string& target, ParamSet params) const;

    const FileSearch& files_;
    Dialect dialect_;
    Transform fromFile_;  // from the file's world space to the scene's: moves Scene::origin to zero
    KeptContents* kept_ = nullptr;
    const DialectFactories& make_;
    GraphicsState state_;
    Blocks blocks_;
    std::map<std::string, TransformSet> coordinateSystems_;
    std::vector<std::map<std::string, TransformSet>> savedSystems_;  // one per open import
    LaterNames later_;
    std::map<std::string, std::shared_ptr<const MaterialInstance>> laterMaterials_;
    TextureFiles textureFiles_;
    BsdfFiles bsdfFiles_;

    Setting camera_, film_, filter_, sampler_, integrator_;
    TransformSet worldToCamera_;
    CameraOverride cameraOverride_;
    SceneMedia media_;
    std::optional<SceneRecorder> recorder_;  // set if there is a listing
    std::array<float, 2> transformTimes_{0, 1};

    std::optional<SourcePos> worldBegin_;
    bool worldEnded_ = false;
    std::optional<size_t> openObject_;
    std::map<std::string, size_t> objects_;
    std::map<size_t, std::vector<MovingPart>> movingParts_;  // by index into Scene::objects
    // By index into Scene::objects: the transformation where the object begins, which all of its shapes have in common.
    std::map<size_t, Transform> objectToFile_;
    // The last result of movingObject(), the object that was open at the time, and the transformation.
    struct MovingObject {
        size_t object;
        std::optional<size_t> within;
        TransformSet ctm;
    };
    std::optional<MovingObject> movingObject_;
    InstanceBudget instances_;
    ObjectNumbers numbers_;
    size_t curvePiecesLeft_ = limits::kCurvePieces;
    bool keepsNames_ = false;
    std::vector<PendingPrimitive> pending_;
    std::map<RgbTexturePtr, Emission> emissions_;  // by the material's emission texture
    std::unique_ptr<Scene> scene_ = std::make_unique<Scene>();
};

}  // namespace drc::pbrt
