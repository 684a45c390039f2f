#include "accel/accel.h"

#include <embree3/rtcore.h>
#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>
#include <unordered_set>

#include "accel/geometry_group.h"
#include "accel/instance_geometry.h"
#include "accel/intersect_context.h"
#include "base/error.h"
#include "base/limits.h"
#include "base/log.h"
#include "base/memory.h"
#include "base/memory_use.h"
#include "base/parallel.h"
#include "base/parallel_time.h"
#include "scene/shapes/curves.h"
#include "scene/tracing_memory.h"

namespace drc {
namespace {

// Embree calls this before it allocates memory (bytes > 0) and after it has freed memory (bytes < 0).
bool noteMemoryOfEmbree(void*, ssize_t bytes, bool) {
    addMemoryUse(MemoryUse::Accelerator, bytes);
    return true;
}

RTCDevice newDevice() {
    RTCDevice device = rtcNewDevice(nullptr);
    if (device == nullptr) throw Error("Embree could not be started");
    rtcSetDeviceMemoryMonitorFunction(device, noteMemoryOfEmbree, nullptr);
    return device;
}

double weightOf(const Primitive& primitive) {
    if (primitive.mesh) return primitive.mesh->triangleCount();
    const Curves* curves = primitive.shape->asCurves();
    return curves ? double(curves->pieceCount()) : 1;
}

// Whether the same instances are placed in the same way.
bool samePlacing(const Instance& a, const Instance& b) {
    return a.object == b.object && !a.objectToWorld.isAnimated() && !b.objectToWorld.isAnimated() &&
           a.objectToWorld.start() == b.objectToWorld.start();
}

}  // namespace

// Embree's scene of the world holds the loose geometries and the instances. In an animation in which objects move, the
// geometries that stand still are in a group of their own, which is an instance in the world, too: in the next frame
// only the hierarchy over what is loose has to be built.
struct Accel::Impl {
    RTCDevice device = nullptr;
    std::unique_ptr<GeometryGroup> loose;
    std::unique_ptr<GeometryGroup> still;  // null: all geometries are loose
    std::vector<std::unique_ptr<GeometryGroup>> objects;
    std::vector<Instance> placed;            // copies of the scene's instances, to be compared with those of the next
    std::vector<const Instance*> instances;  // by geometry ID in the world's scene; null if not an instance
    const Instance* firstInstance = nullptr;
    bool anythingMoves = false;
    bool hasShadowMasks = false;
    bool hidesFromCamera = false, hidesFromDiffuse = false;
    bool hasOpenMedia = false;
    float reachOfMedia = 0;
    std::unordered_map<const Material*, std::unique_ptr<const Bsdf>> lobes;  // one per material without textures

    ~Impl() {
        objects.clear();
        still.reset();
        loose.reset();
        if (device) rtcReleaseDevice(device);
    }

    // Embree aborts the program when it is given rays with coordinates that are not finite or beyond 1.8e18, in world
    // space or, after transformation, in an instance's space. A valid scene file can lead to such rays: its camera may
    // be too far away, or its normals may be NaN.
    bool isWithinReach(const Vec3& o, const Vec3& d) const {
        return std::abs(o.x) + std::abs(o.y) + std::abs(o.z) + std::abs(d.x) + std::abs(d.y) + std::abs(d.z) < reach;
    }
    void limitReachBy(const Transform& objectToWorld);
    float reach = limits::kCoordinate;

    // The meshes and shapes that geometries were made of.
    std::unordered_set<const void*> sources() const;
    const Bsdf* lobesOf(const Material* material);
    // Takes over or builds the scene's objects. Returns whether all are those of the earlier scene.
    bool takeObjects(const Scene& scene, Impl* before, GeometryStore& store);
    // Takes over the earlier scene's world if all of its geometries are the same; else returns false.
    bool takeWholeWorld(const Scene& scene, Impl& before);
    // Takes over or builds the geometries of the world, without committing the loose ones.
    void takeWorld(const Scene& scene, Impl* before, GeometryStore& store);
    void listInstances(const Scene& scene);
    void placeInstances(const Scene& scene);
    // Sets what depends on more of the primitives than their geometry.
    void describe(const Scene& scene);
    void describe(GeometryGroup& group, const std::vector<Primitive>& primitives, uint32_t firstIndex);
    // Object-to-world transform of a moving instance at a ray's time.
    Transform toWorld(const Instance& instance, float time) const {
        const auto id = loose->geometries().size() + size_t(&instance - firstInstance);
        return instanceToWorld(rtcGetGeometry(loose->scene(), unsigned(id)), time);
    }
};

std::unordered_set<const void*> Accel::Impl::sources() const {
    std::unordered_set<const void*> all;
    const auto add = [&](const GeometryGroup* group) {
        if (group == nullptr) return;
        for (const auto& geometry : group->geometries()) all.insert(geometry->source());
    };
    add(loose.get());
    add(still.get());
    for (const auto& object : objects) add(object.get());
    return all;
}

const Bsdf* Accel::Impl::lobesOf(const Material* material) {
    if (material == nullptr || !material->isConstant()) return nullptr;
    std::unique_ptr<const Bsdf>& known = lobes[material];
    if (known == nullptr) {
        auto bsdf = std::make_unique<Bsdf>(Frame(), Vec3(0, 0, 1));
        material->addLobes(TextureContext(), Rgb(1.f), *bsdf);
        known = std::move(bsdf);
    }
    return known.get();
}

void Accel::Impl::limitReachBy(const Transform& objectToWorld) {
    // Embree inverts instance transforms in single precision, so its ray coordinates may be twice as large as ours: see
    // pbrt::checkPlacement.
    constexpr float kInside = limits::kCoordinate / 4;
    const Transform inverse = objectToWorld.inverse();
    for (int row = 0; row < 3; ++row) {
        float most = 1;
        for (int column = 0; column < 3; ++column) most = std::max(most, std::abs(inverse.at(row, column)));
        reach = std::min(reach, (kInside - std::abs(inverse.at(row, 3))) / most);
    }
}

namespace {

// Assigns the scene's primitives to a group that was made of the same ones, in any order. False: it was not, and
// nothing has changed.
bool takeOver(GeometryGroup& group, PrimitivesBySource& primitives) {
    std::vector<const Primitive*> its;
    for (const auto& geometry : group.geometries()) {
        const Primitive* primitive = primitives.take(*geometry);
        if (primitive == nullptr) return false;
        its.push_back(primitive);
    }
    for (size_t id = 0; id < its.size(); ++id) group.geometries()[id]->primitive = its[id];
    return true;
}

std::unique_ptr<GeometryGroup> makeGroup(RTCDevice device, const std::vector<const Primitive*>& primitives,
                                         GeometryStore& store) {
    std::vector<std::unique_ptr<Geometry>> geometries;
    geometries.reserve(primitives.size());
    for (const Primitive* primitive : primitives) geometries.push_back(store.take(*primitive));
    return std::make_unique<GeometryGroup>(device, std::move(geometries));
}

std::vector<const Primitive*> pointersTo(const std::vector<Primitive>& primitives) {
    std::vector<const Primitive*> pointers;
    for (const Primitive& primitive : primitives) pointers.push_back(&primitive);
    return pointers;
}

}  // namespace

bool Accel::Impl::takeObjects(const Scene& scene, Impl* before, GeometryStore& store) {
    objects.resize(scene.objects.size());
    // An object is usually at the place that it had in the earlier scene.
    if (before)
        for (size_t i = 0; i < std::min(objects.size(), before->objects.size()); ++i) {
            PrimitivesBySource primitives(scene.objects[i].primitives);
            if (before->objects[i]->geometries().size() == scene.objects[i].primitives.size() &&
                takeOver(*before->objects[i], primitives))
                objects[i] = std::move(before->objects[i]);
        }
    if (before)
        for (auto& object : before->objects)
            if (object) store.add(object->release());
    std::vector<GeometryGroup*> built;
    for (size_t i = 0; i < objects.size(); ++i) {
        if (objects[i]) continue;
        objects[i] = makeGroup(device, pointersTo(scene.objects[i].primitives), store);
        built.push_back(objects[i].get());
    }
    parallelFor(0, int(built.size()), 1, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) rtcCommitScene(built[size_t(i)]->scene());
    });
    return before && built.empty() && before->objects.size() == objects.size();
}

bool Accel::Impl::takeWholeWorld(const Scene& scene, Impl& before) {
    const size_t geometries =
        before.loose->geometries().size() + (before.still ? before.still->geometries().size() : 0);
    PrimitivesBySource primitives(scene.primitives);
    if (geometries != scene.primitives.size() || !std::ranges::equal(before.placed, scene.instances, samePlacing) ||
        !takeOver(*before.loose, primitives) || (before.still && !takeOver(*before.still, primitives)))
        return false;
    loose = std::move(before.loose);
    still = std::move(before.still);
    listInstances(scene);
    return true;
}

void Accel::Impl::takeWorld(const Scene& scene, Impl* before, GeometryStore& store) {
    std::vector<const Primitive*> primitives = pointersTo(scene.primitives);
    if (before) {
        // Which primitives the earlier scene had, too.
        PrimitivesBySource known(scene.primitives);
        std::vector<const Primitive*> common;
        double commonWeight = 0, allWeight = 0;
        const auto find = [&](const GeometryGroup& group) {
            for (const auto& geometry : group.geometries())
                if (const Primitive* primitive = known.take(*geometry)) {
                    common.push_back(primitive);
                    commonWeight += weightOf(*primitive);
                }
        };
        if (before->still) {
            PrimitivesBySource left(scene.primitives);
            if (takeOver(*before->still, left)) still = std::move(before->still);
        }
        if (still) {
            for (const auto& geometry : still->geometries()) common.push_back(geometry->primitive);
        } else {
            if (before->still) find(*before->still);
            find(*before->loose);
            for (const Primitive* primitive : primitives) allWeight += weightOf(*primitive);
            // Two hierarchies cost more to trace than one.
            constexpr double kWorthIt = 0.5;
            if (commonWeight < kWorthIt * allWeight) common.clear();
        }
        if (before->still) store.add(before->still->release());
        store.add(before->loose->release());
        before->still.reset();  // before another takes its memory
        before->loose.reset();
        if (!common.empty()) {
            std::ranges::sort(common);  // as in the scene's file
            if (!still) {
                still = makeGroup(device, common, store);
                still->commit();
            }
            std::erase_if(primitives, [&](const Primitive* p) { return std::ranges::binary_search(common, p); });
        }
    }
    loose = makeGroup(device, primitives, store);
}

void Accel::Impl::listInstances(const Scene& scene) {
    instances.assign(loose->geometries().size(), nullptr);
    for (const Instance& instance : scene.instances) instances.push_back(&instance);
    if (still) instances.push_back(nullptr);
}

void Accel::Impl::placeInstances(const Scene& scene) {
    listInstances(scene);
    double bytes = 0;
    for (const Instance& instance : scene.instances) bytes += instance.memory();
    const MemoryClaim placing(bytes, fmt::format("placing {} instances", scene.instances.size()));
    for (size_t id = loose->geometries().size(); id < instances.size(); ++id) {
        const Instance* instance = instances[id];
        RTCGeometry geometry =
            instance ? makeInstanceGeometry(device, objects[size_t(instance->object)]->scene(), instance->objectToWorld)
                     : makeInstanceGeometry(device, still->scene(), Transform());
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(loose->scene(), geometry, unsigned(id));
        rtcReleaseGeometry(geometry);
    }
}

void Accel::Impl::describe(GeometryGroup& group, const std::vector<Primitive>& primitives, uint32_t firstIndex) {
    for (const auto& geometry : group.geometries()) {
        const Primitive& primitive = *geometry->primitive;
        geometry->index = firstIndex + uint32_t(&primitive - primitives.data());
        geometry->lobes = lobesOf(primitive.material.get());
        hasShadowMasks |= primitive.shadowAlpha != nullptr;
        hidesFromCamera |= !primitive.visibleToCamera;
        hidesFromDiffuse |= !primitive.visibleToDiffuse;
        hasOpenMedia |= primitive.media.changes() && !primitive.material;
    }
}

void Accel::Impl::describe(const Scene& scene) {
    uint32_t index = 0;
    for (size_t i = 0; i < objects.size(); ++i) {
        describe(*objects[i], scene.objects[i].primitives, index);
        index += uint32_t(scene.objects[i].primitives.size());
    }
    describe(*loose, scene.primitives, index);
    if (still) describe(*still, scene.primitives, index);
    firstInstance = scene.instances.data();
    for (const Instance& instance : scene.instances) {
        limitReachBy(instance.objectToWorld.start());
        limitReachBy(instance.objectToWorld.end());
        anythingMoves |= instance.objectToWorld.isAnimated();
    }
    placed = scene.instances;
    if (scene.media.empty()) return;
    const Bounds bounds = scene.bounds();
    if (!bounds.empty()) reachOfMedia = length(bounds.max - bounds.min);
}

Accel::Accel(const Scene& scene, std::unique_ptr<Accel> earlier) : impl_(std::make_unique<Impl>()) {
    Impl* before = earlier ? earlier->impl_.get() : nullptr;
    const MemoryClaim memory = claimForTracing(scene, before ? before->sources() : std::unordered_set<const void*>());
    impl_->device = before ? before->device : newDevice();
    if (before) rtcRetainDevice(impl_->device);
    GeometryStore store(impl_->device);
    const bool sameObjects = impl_->takeObjects(scene, before, store);
    if (!sameObjects || !impl_->takeWholeWorld(scene, *before)) {
        impl_->takeWorld(scene, before, store);
        impl_->placeInstances(scene);
        impl_->loose->commit();
    }
    impl_->describe(scene);
    if (const RTCError e = rtcGetDeviceError(impl_->device); e != RTC_ERROR_NONE)
        throw Error(fmt::format("Embree could not build the scene (error {})", int(e)));
}

Accel::~Accel() = default;
Accel::Accel(Accel&&) noexcept = default;

bool Accel::intersect(const Ray& ray, SurfaceInteraction& hit) const {
    Found found;
    if (!find(ray, found)) return false;
    describe(ray, found, hit);
    return true;
}

bool Accel::find(const Ray& ray, Found& found) const {
    if (!impl_->isWithinReach(ray.o, ray.d)) return false;
    IntersectContext context(found.shape);
    RTCRayHit q;
    q.ray.org_x = ray.o.x;
    q.ray.org_y = ray.o.y;
    q.ray.org_z = ray.o.z;
    q.ray.tnear = 0;
    q.ray.dir_x = ray.d.x;
    q.ray.dir_y = ray.d.y;
    q.ray.dir_z = ray.d.z;
    q.ray.time = ray.time;
    q.ray.tfar = ray.tMax;
    q.ray.mask = ~0u;
    q.ray.id = ray.fromCamera ? kFromCamera : ray.mirrored ? kMirrored : kDiffuse;
    q.ray.flags = 0;
    q.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    q.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(impl_->loose->scene(), &context, &q);
    if (q.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;

    const bool inGroup = q.hit.instID[0] != RTC_INVALID_GEOMETRY_ID;
    found.instance = inGroup ? impl_->instances[q.hit.instID[0]] : nullptr;
    const GeometryGroup& group = !inGroup         ? *impl_->loose
                                 : found.instance ? *impl_->objects[size_t(found.instance->object)]
                                                  : *impl_->still;
    const Geometry& data = *group.geometries()[q.hit.geomID];
    found.geometry = &data;
    found.triangle = q.hit.primID;
    found.b1 = q.hit.u;
    found.b2 = q.hit.v;
    found.t = q.ray.tfar;
    if (data.mesh) data.mesh->prefetch(found.triangle);
    return true;
}

void Accel::describe(const Ray& ray, const Found& found, SurfaceInteraction& hit) const {
    const Geometry& data = *static_cast<const Geometry*>(found.geometry);
    hit.primitive = data.primitive;
    hit.lobes = data.lobes;
    hit.moves = found.instance && found.instance->objectToWorld.isAnimated();
    const Transform* toWorld = found.instance ? &found.instance->objectToWorld.start() : nullptr;
    std::optional<Transform> then;
    if (hit.moves) toWorld = &then.emplace(impl_->toWorld(*found.instance, ray.time));
    if (data.mesh) {
        data.mesh->fill(found.triangle, found.b1, found.b2, hit);
    } else if (data.curves) {
        Ray local = ray;
        if (toWorld) {
            const Transform inverse = toWorld->inverse();
            local.o = inverse.point(ray.o);
            local.d = inverse.vector(ray.d);  // not normalised, so that t is the same in both spaces
        }
        data.fillAt(local, found.t, found.triangle, found.b1, found.b2, hit);
    } else {
        fillFromShape(found.shape, hit);
    }
    if (toWorld) {
        // A plane with the unit normal ng at distance h from a point has the distance h / |normal| after the
        // transformation.
        const Vec3 normal = toWorld->normal(hit.ng);
        const float scale = 1 / length(normal);
        const float rounding = roundingError(toWorld->largestOfSums(hit.p)) + roundingError(toWorld->point(hit.p));
        if (data.mesh) data.mesh->keepOffEdges(found.triangle, found.b1, found.b2, rounding / scale, hit);
        hit.p = toWorld->point(hit.p);
        hit.error = hit.error * scale + rounding;
        hit.ng = normalize(normal);
        hit.ns = normalize(toWorld->normal(hit.ns));
        hit.dpdu = toWorld->vector(hit.dpdu);
        hit.dpdv = toWorld->vector(hit.dpdv);
        hit.tangent = toWorld->vector(hit.tangent);
    } else {
        const float rounding = roundingError(hit.p);
        if (data.mesh) data.mesh->keepOffEdges(found.triangle, found.b1, found.b2, rounding, hit);
        hit.error += rounding;
    }
    hit.medium = ray.medium;
    hit.wo = -ray.d;
    hit.t = found.t;
    hit.time = ray.time;
    hit.coneSpread = ray.coneSpread;
    hit.footprint = ray.coneWidth + ray.coneSpread * hit.t;
}

bool Accel::anythingMoves() const { return impl_->anythingMoves; }
bool Accel::hasShadowMasks() const { return impl_->hasShadowMasks; }
bool Accel::hidesFromCamera() const { return impl_->hidesFromCamera; }
bool Accel::hidesFromDiffuse() const { return impl_->hidesFromDiffuse; }
bool Accel::hasOpenMedia() const { return impl_->hasOpenMedia; }
float Accel::lengthInMedium(float length) const { return std::isinf(length) ? impl_->reachOfMedia : length; }

bool Accel::occluded(const Vec3& o, const Vec3& d, float tMax, float time) const {
    if (!impl_->isWithinReach(o, d)) return false;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay r;
    r.org_x = o.x;
    r.org_y = o.y;
    r.org_z = o.z;
    r.tnear = 0;
    r.dir_x = d.x;
    r.dir_y = d.y;
    r.dir_z = d.z;
    r.time = time;
    r.tfar = tMax;
    r.mask = ~0u;
    r.id = kDiffuse;
    r.flags = 0;
    rtcOccluded1(impl_->loose->scene(), &context, &r);
    return r.tfar < 0;
}

}  // namespace drc
