#include "accel/accel.h"

#include <embree3/rtcore.h>
#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>
#include <bit>
#include <unordered_map>

#include "accel/curve_geometry.h"
#include "accel/instance_geometry.h"
#include "accel/intersect_context.h"
#include "accel/packed_mesh.h"
#include "base/error.h"
#include "base/limits.h"
#include "base/log.h"
#include "base/memory.h"
#include "base/memory_use.h"
#include "base/parallel.h"
#include "base/parallel_time.h"
#include "math/sampler.h"
#include "scene/tracing_memory.h"

namespace drc {
namespace {

// The data that Embree's callbacks need for one geometry. Lives as long as the Accel.
struct GeometryData {
    const Primitive* primitive;
    uint32_t index;                  // among all of the scene's geometries
    NotedMemory memory;              // of the mesh
    std::optional<PackedMesh> mesh;  // set for meshes only
    const Curves* curves = nullptr;  // set for curves only; null and no mesh: another shape
    const Bsdf* lobes = nullptr;     // see SurfaceInteraction::lobes
};

struct Group {
    RTCScene scene = nullptr;
    std::vector<std::unique_ptr<GeometryData>> geometries;  // indexed by Embree's geometry ID
};

void fill(const ShapeHit& found, SurfaceInteraction& hit) {
    hit.p = found.p;
    hit.ng = found.ng;
    hit.ns = found.ns == Vec3(0.f) ? found.ng : found.ns;
    hit.uv = found.uv;
    hit.dpdu = found.dpdu;
    hit.dpdv = found.dpdv;
    hit.tangent = found.dpdu;
    hit.bumpTangents = BumpTangents::Derivatives;
    hit.triangle = found.part;
    hit.error = 0;  // shapes are intersected in double precision
}

// Embree intersects a piecewise linear approximation of curves. The error also covers its distance from the curve, so
// that spawned rays leave it.
void fillCurve(const ShapeHit& found, SurfaceInteraction& hit) {
    constexpr float kShareOfCoordinates = 0x1p-15f, kShareOfWidth = 0x1p-10f;
    fill(found, hit);
    hit.error = kShareOfCoordinates * std::max({std::abs(hit.p.x), std::abs(hit.p.y), std::abs(hit.p.z)}) +
                kShareOfWidth * length(hit.dpdv);
}

// Fills in the interaction at a hit on a mesh or curves, at distance t along the ray.
void fillAt(const GeometryData& data, const Ray& ray, float t, uint32_t primId, float u, float v,
            SurfaceInteraction& hit) {
    if (data.mesh)
        data.mesh->fill(primId, u, v, hit);
    else
        fillCurve(data.curves->hitAt(primId, u, ray, t), hit);
}

// A hash of the ray, the geometry and its part: uniform in [0, 1) and independent for the different surfaces that a ray
// hits.
float uniformOf(const Ray& ray, const GeometryData& data, uint32_t part) {
    const auto bits = [](const Vec3& v) {
        const uint64_t low = std::bit_cast<uint32_t>(v.x), middle = std::bit_cast<uint32_t>(v.y);
        return hashCombine(low << 32 | middle, std::bit_cast<uint32_t>(v.z));
    };
    const uint64_t hash = hashCombine(hashCombine(bits(ray.o), bits(ray.d)), uint64_t(data.index) << 32 | part);
    return float(hash >> 40) * 0x1p-24f;
}

// Whether the alpha mask lets the ray pass through the surface. part: distinguishes several hits of the ray on one
// geometry.
bool isHole(const GeometryData& data, const FloatTexture& alpha, const SurfaceInteraction& hit, const Ray& ray,
            uint32_t part) {
    const float value = alpha.eval(hit.textureContext());
    if (!data.primitive->alphaIsShare) return value == 0;
    return value < 1 && uniformOf(ray, data, part) >= value;
}
bool isHole(const GeometryData& data, const FloatTexture* alpha, uint32_t primId, float u, float v, const Ray& ray,
            float t) {
    if (alpha == nullptr) return false;
    SurfaceInteraction hit;
    fillAt(data, ray, t, primId, u, v, hit);
    return isHole(data, *alpha, hit, ray, primId);
}

// Values of RTCRay::id, which encodes Ray::fromCamera and Ray::mirrored.
constexpr unsigned kDiffuse = 0, kFromCamera = 1, kMirrored = 2;

bool isOpenToLight(const Primitive& primitive) { return !primitive.material || !primitive.visibleToDiffuse; }

bool isHidden(const Primitive& primitive, RTCRayN* ray, unsigned n, unsigned i) {
    const unsigned kind = RTCRayN_id(ray, n, i);
    return (!primitive.visibleToCamera && kind == kFromCamera) || (!primitive.visibleToDiffuse && kind == kDiffuse);
}

Ray rayOf(RTCRayN* ray, unsigned n, unsigned i) {
    Ray r;
    r.o = Vec3(RTCRayN_org_x(ray, n, i), RTCRayN_org_y(ray, n, i), RTCRayN_org_z(ray, n, i));
    r.d = Vec3(RTCRayN_dir_x(ray, n, i), RTCRayN_dir_y(ray, n, i), RTCRayN_dir_z(ray, n, i));
    r.tMax = RTCRayN_tfar(ray, n, i);
    return r;
}

void filterIntersect(const RTCFilterFunctionNArguments* a) {
    const auto& data = *static_cast<const GeometryData*>(a->geometryUserPtr);
    const Primitive& primitive = *data.primitive;
    for (unsigned i = 0; i < a->N; ++i) {
        if (a->valid[i] != -1) continue;
        if (isHidden(primitive, a->ray, a->N, i) ||
            isHole(data, primitive.alpha.get(), RTCHitN_primID(a->hit, a->N, i), RTCHitN_u(a->hit, a->N, i),
                   RTCHitN_v(a->hit, a->N, i), rayOf(a->ray, a->N, i), RTCRayN_tfar(a->ray, a->N, i)))
            a->valid[i] = 0;
    }
}

void filterOccluded(const RTCFilterFunctionNArguments* a) {
    const auto& data = *static_cast<const GeometryData*>(a->geometryUserPtr);
    const Primitive& primitive = *data.primitive;
    for (unsigned i = 0; i < a->N; ++i) {
        if (a->valid[i] != -1) continue;
        const auto hole = [&](const FloatTexture* alpha) {
            return isHole(data, alpha, RTCHitN_primID(a->hit, a->N, i), RTCHitN_u(a->hit, a->N, i),
                          RTCHitN_v(a->hit, a->N, i), rayOf(a->ray, a->N, i), RTCRayN_tfar(a->ray, a->N, i));
        };
        if (isOpenToLight(primitive) || hole(primitive.alpha.get()) || hole(primitive.shadowAlpha.get()))
            a->valid[i] = 0;
    }
}

void shapeBounds(const RTCBoundsFunctionArguments* a) {
    const Bounds b = static_cast<const GeometryData*>(a->geometryUserPtr)->primitive->shape->bounds();
    a->bounds_o->lower_x = b.min.x;
    a->bounds_o->lower_y = b.min.y;
    a->bounds_o->lower_z = b.min.z;
    a->bounds_o->upper_x = b.max.x;
    a->bounds_o->upper_y = b.max.y;
    a->bounds_o->upper_z = b.max.z;
}

// The nearest hit on a shape at which none of the alpha masks is transparent.
std::optional<ShapeHit> intersectSolid(const GeometryData& data, std::initializer_list<const FloatTexture*> masks,
                                       const Ray& ray, float tMin) {
    constexpr int kMaxHits = 8;  // no shape has more intersections with a ray
    for (int i = 0; i < kMaxHits; ++i) {
        auto found = data.primitive->shape->intersect(ray, tMin);
        if (!found) return {};
        const auto isOpen = [&](const FloatTexture* mask) {
            if (mask == nullptr) return false;
            SurfaceInteraction hit;
            fill(*found, hit);
            // The index i gives each hit of the ray on the shape its own random number.
            return isHole(data, *mask, hit, ray, uint32_t(i));
        };
        if (std::none_of(masks.begin(), masks.end(), isOpen)) return found;
        tMin = found->t * (1 + 1e-6f);
    }
    return {};
}

void shapeIntersect(const RTCIntersectFunctionNArguments* a) {
    const GeometryData& data = *static_cast<const GeometryData*>(a->geometryUserPtr);
    RTCRayHitN* rayhit = a->rayhit;
    RTCRayN* rays = RTCRayHitN_RayN(rayhit, a->N);
    RTCHitN* hits = RTCRayHitN_HitN(rayhit, a->N);
    for (unsigned i = 0; i < a->N; ++i) {
        if (a->valid[i] != -1 || isHidden(*data.primitive, rays, a->N, i)) continue;
        const auto found =
            intersectSolid(data, {data.primitive->alpha.get()}, rayOf(rays, a->N, i), RTCRayN_tnear(rays, a->N, i));
        if (!found) continue;
        RTCRayN_tfar(rays, a->N, i) = found->t;
        RTCHitN_geomID(hits, a->N, i) = a->geomID;
        RTCHitN_primID(hits, a->N, i) = a->primID;
        RTCHitN_instID(hits, a->N, i, 0) = a->context->instID[0];
        RTCHitN_u(hits, a->N, i) = found->uv.x;
        RTCHitN_v(hits, a->N, i) = found->uv.y;
        static_cast<IntersectContext*>(a->context)->latest = *found;
    }
}

void shapeOccluded(const RTCOccludedFunctionNArguments* a) {
    const GeometryData& data = *static_cast<const GeometryData*>(a->geometryUserPtr);
    const Primitive& primitive = *data.primitive;
    if (isOpenToLight(primitive)) return;
    for (unsigned i = 0; i < a->N; ++i) {
        if (a->valid[i] != -1) continue;
        if (intersectSolid(data, {primitive.alpha.get(), primitive.shadowAlpha.get()}, rayOf(a->ray, a->N, i),
                           RTCRayN_tnear(a->ray, a->N, i)))
            RTCRayN_tfar(a->ray, a->N, i) = -kInfinity;
    }
}

// Embree calls this before it allocates memory (bytes > 0) and after it has freed memory (bytes < 0).
bool noteMemoryOfEmbree(void*, ssize_t bytes, bool) {
    addMemoryUse(MemoryUse::Accelerator, bytes);
    return true;
}

size_t bytesOf(const PackedMesh& mesh) {
    return mesh.vertices().size() * sizeof(PackedMesh::Vertex) + mesh.faces().size() * sizeof(PackedMesh::Face);
}

}  // namespace

struct Accel::Impl {
    RTCDevice device = nullptr;
    Group world;
    std::vector<Group> objects;
    std::vector<const Instance*> instances;  // indexed by geometry ID in the world scene; null if not an instance
    const Instance* firstInstance = nullptr;
    bool anythingMoves = false;
    bool hasShadowMasks = false;
    bool hidesFromCamera = false, hidesFromDiffuse = false;
    bool hasOpenMedia = false;
    float reachOfMedia = 0;
    uint32_t geometries = 0;  // number of geometries so far

    ~Impl() {
        for (Group& g : objects)
            if (g.scene) rtcReleaseScene(g.scene);
        if (world.scene) rtcReleaseScene(world.scene);
        if (device) rtcReleaseDevice(device);
    }
    std::unordered_map<const Material*, std::unique_ptr<const Bsdf>> lobes;  // one per material without textures

    // Embree aborts the program when it is given rays with coordinates that are not finite or beyond 1.8e18, in world
    // space or, after transformation, in an instance's space. A valid scene file can lead to such rays: its camera may
    // be too far away, or its normals may be NaN.
    bool isWithinReach(const Vec3& o, const Vec3& d) const {
        return std::abs(o.x) + std::abs(o.y) + std::abs(o.z) + std::abs(d.x) + std::abs(d.y) + std::abs(d.z) < reach;
    }
    void limitReachBy(const Transform& objectToWorld);
    float reach = limits::kCoordinate;

    const Bsdf* lobesOf(const Material* material);
    void fill(Group& group, const std::vector<Primitive>& primitives);
    // Object-to-world transform of a moving instance at a ray's time.
    Transform toWorld(const Instance& instance, float time) const {
        const auto id = world.geometries.size() + size_t(&instance - firstInstance);
        return instanceToWorld(rtcGetGeometry(world.scene, unsigned(id)), time);
    }
};

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

void Accel::Impl::fill(Group& group, const std::vector<Primitive>& primitives) {
    group.scene = rtcNewScene(device);
    // With this flag, no ray passes between triangles that share an edge.
    rtcSetSceneFlags(group.scene, RTC_SCENE_FLAG_ROBUST);
    for (const Primitive& primitive : primitives) {
        auto data = std::make_unique<GeometryData>();
        data->primitive = &primitive;
        data->index = geometries++;
        hasShadowMasks |= primitive.shadowAlpha != nullptr;
        hidesFromCamera |= !primitive.visibleToCamera;
        hidesFromDiffuse |= !primitive.visibleToDiffuse;
        hasOpenMedia |= primitive.media.changes() && !primitive.material;
        data->lobes = lobesOf(primitive.material.get());
        RTCGeometry geometry = nullptr;
        if (primitive.mesh) {
            const PackedMesh& mesh = data->mesh.emplace(*primitive.mesh);
            data->memory = NotedMemory(MemoryUse::Accelerator, bytesOf(mesh));
            geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
            rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.vertices().data(),
                                       offsetof(PackedMesh::Vertex, p), sizeof(PackedMesh::Vertex),
                                       mesh.vertices().size());
            rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.faces().data(),
                                       offsetof(PackedMesh::Face, v), sizeof(PackedMesh::Face), mesh.faces().size());
        } else if (primitive.shape->asCurves()) {
            data->curves = primitive.shape->asCurves();
            geometry = makeCurveGeometry(device, *data->curves);
        } else {
            geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
            rtcSetGeometryUserPrimitiveCount(geometry, 1);
            rtcSetGeometryBoundsFunction(geometry, shapeBounds, nullptr);
            rtcSetGeometryIntersectFunction(geometry, shapeIntersect);
            rtcSetGeometryOccludedFunction(geometry, shapeOccluded);
        }
        // The intersection functions of shapes make these tests themselves.
        if (data->mesh || data->curves) {
            if (primitive.alpha || !primitive.visibleToCamera || !primitive.visibleToDiffuse)
                rtcSetGeometryIntersectFilterFunction(geometry, filterIntersect);
            if (primitive.alpha || primitive.shadowAlpha || isOpenToLight(primitive))
                rtcSetGeometryOccludedFilterFunction(geometry, filterOccluded);
        }
        rtcSetGeometryUserData(geometry, data.get());
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(group.scene, geometry, unsigned(group.geometries.size()));
        rtcReleaseGeometry(geometry);
        group.geometries.push_back(std::move(data));
    }
}

Accel::Accel(const Scene& scene) : impl_(std::make_unique<Impl>()) {
    const MemoryClaim memory = claimForTracing(scene);
    impl_->device = rtcNewDevice(nullptr);
    if (impl_->device == nullptr) throw Error("Embree could not be started");
    rtcSetDeviceMemoryMonitorFunction(impl_->device, noteMemoryOfEmbree, nullptr);
    impl_->objects.resize(scene.objects.size());
    for (size_t i = 0; i < scene.objects.size(); ++i) impl_->fill(impl_->objects[i], scene.objects[i].primitives);
    parallelFor(0, int(scene.objects.size()), 1, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) rtcCommitScene(impl_->objects[size_t(i)].scene);
    });
    impl_->fill(impl_->world, scene.primitives);
    impl_->instances.resize(scene.primitives.size(), nullptr);
    impl_->firstInstance = scene.instances.data();
    double bytes = 0;
    for (const Instance& instance : scene.instances) bytes += instance.memory();
    const MemoryClaim placing(bytes, fmt::format("placing {} instances", scene.instances.size()));
    for (const Instance& instance : scene.instances) {
        impl_->limitReachBy(instance.objectToWorld.start());
        impl_->limitReachBy(instance.objectToWorld.end());
        RTCGeometry geometry =
            makeInstanceGeometry(impl_->device, impl_->objects[size_t(instance.object)].scene, instance.objectToWorld);
        impl_->anythingMoves |= instance.objectToWorld.isAnimated();
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(impl_->world.scene, geometry, unsigned(impl_->instances.size()));
        rtcReleaseGeometry(geometry);
        impl_->instances.push_back(&instance);
    }
    {
        const ParallelSection section;
        rtcCommitScene(impl_->world.scene);
    }
    if (!scene.media.empty()) {
        const Bounds bounds = scene.bounds();
        if (!bounds.empty()) impl_->reachOfMedia = length(bounds.max - bounds.min);
    }
    if (const RTCError e = rtcGetDeviceError(impl_->device); e != RTC_ERROR_NONE)
        throw Error(fmt::format("Embree could not build the scene (error {})", int(e)));
}

Accel::~Accel() = default;

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
    rtcIntersect1(impl_->world.scene, &context, &q);
    if (q.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;

    found.instance = q.hit.instID[0] == RTC_INVALID_GEOMETRY_ID ? nullptr : impl_->instances[q.hit.instID[0]];
    const Group& group = found.instance ? impl_->objects[size_t(found.instance->object)] : impl_->world;
    const GeometryData& data = *group.geometries[q.hit.geomID];
    found.geometry = &data;
    found.triangle = q.hit.primID;
    found.b1 = q.hit.u;
    found.b2 = q.hit.v;
    found.t = q.ray.tfar;
    if (data.mesh) data.mesh->prefetch(found.triangle);
    return true;
}

void Accel::describe(const Ray& ray, const Found& found, SurfaceInteraction& hit) const {
    const GeometryData& data = *static_cast<const GeometryData*>(found.geometry);
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
        fillAt(data, local, found.t, found.triangle, found.b1, found.b2, hit);
    } else {
        fill(found.shape, hit);
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
    rtcOccluded1(impl_->world.scene, &context, &r);
    return r.tfar < 0;
}

}  // namespace drc
