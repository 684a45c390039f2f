#include "accel/geometry_group.h"

#include <algorithm>
#include <bit>

#include "accel/curve_geometry.h"
#include "accel/intersect_context.h"
#include "base/parallel_time.h"
#include "math/sampler.h"

namespace drc {
namespace {

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
void fillAt(const Geometry& data, const Ray& ray, float t, uint32_t primId, float u, float v, SurfaceInteraction& hit) {
    if (data.mesh)
        data.mesh->fill(primId, u, v, hit);
    else
        fillCurve(data.curves->hitAt(primId, u, ray, t), hit);
}

// A hash of the ray, the geometry and its part: uniform in [0, 1) and independent for the different surfaces that a ray
// hits.
float uniformOf(const Ray& ray, const Geometry& data, uint32_t part) {
    const auto bits = [](const Vec3& v) {
        const uint64_t low = std::bit_cast<uint32_t>(v.x), middle = std::bit_cast<uint32_t>(v.y);
        return hashCombine(low << 32 | middle, std::bit_cast<uint32_t>(v.z));
    };
    const uint64_t hash = hashCombine(hashCombine(bits(ray.o), bits(ray.d)), uint64_t(data.index) << 32 | part);
    return float(hash >> 40) * 0x1p-24f;
}

// Whether the alpha mask lets the ray pass through the surface. part: distinguishes several hits of the ray on one
// geometry.
bool isHole(const Geometry& data, const FloatTexture& alpha, const SurfaceInteraction& hit, const Ray& ray,
            uint32_t part) {
    const float value = alpha.eval(hit.textureContext());
    if (!data.primitive->alphaIsShare) return value == 0;
    return value < 1 && uniformOf(ray, data, part) >= value;
}
bool isHole(const Geometry& data, const FloatTexture* alpha, uint32_t primId, float u, float v, const Ray& ray,
            float t) {
    if (alpha == nullptr) return false;
    SurfaceInteraction hit;
    fillAt(data, ray, t, primId, u, v, hit);
    return isHole(data, *alpha, hit, ray, primId);
}

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
    const auto& data = *static_cast<const Geometry*>(a->geometryUserPtr);
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
    const auto& data = *static_cast<const Geometry*>(a->geometryUserPtr);
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
    const Bounds b = static_cast<const Geometry*>(a->geometryUserPtr)->primitive->shape->bounds();
    a->bounds_o->lower_x = b.min.x;
    a->bounds_o->lower_y = b.min.y;
    a->bounds_o->lower_z = b.min.z;
    a->bounds_o->upper_x = b.max.x;
    a->bounds_o->upper_y = b.max.y;
    a->bounds_o->upper_z = b.max.z;
}

// The nearest hit on a shape at which none of the alpha masks is transparent.
std::optional<ShapeHit> intersectSolid(const Geometry& data, std::initializer_list<const FloatTexture*> masks,
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
    const Geometry& data = *static_cast<const Geometry*>(a->geometryUserPtr);
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
    const Geometry& data = *static_cast<const Geometry*>(a->geometryUserPtr);
    const Primitive& primitive = *data.primitive;
    if (isOpenToLight(primitive)) return;
    for (unsigned i = 0; i < a->N; ++i) {
        if (a->valid[i] != -1) continue;
        if (intersectSolid(data, {primitive.alpha.get(), primitive.shadowAlpha.get()}, rayOf(a->ray, a->N, i),
                           RTCRayN_tnear(a->ray, a->N, i)))
            RTCRayN_tfar(a->ray, a->N, i) = -kInfinity;
    }
}

size_t bytesOf(const PackedMesh& mesh) {
    return mesh.vertices().size() * sizeof(PackedMesh::Vertex) + mesh.faces().size() * sizeof(PackedMesh::Face);
}

const void* sourceOf(const Primitive& primitive) {
    return primitive.mesh ? static_cast<const void*>(primitive.mesh.get()) : primitive.shape.get();
}
bool filtersHits(const Primitive& primitive) {
    return primitive.alpha || !primitive.visibleToCamera || !primitive.visibleToDiffuse;
}
bool filtersShadows(const Primitive& primitive) {
    return primitive.alpha || primitive.shadowAlpha || isOpenToLight(primitive);
}

}  // namespace

Geometry::Geometry(RTCDevice device, const Primitive& of)
    : primitive(&of), sourceMesh_(of.mesh), sourceShape_(of.shape) {
    if (of.mesh) {
        const PackedMesh& packed = mesh.emplace(*of.mesh);
        memory_ = NotedMemory(MemoryUse::Accelerator, bytesOf(packed));
        handle_ = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(handle_, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, packed.vertices().data(),
                                   offsetof(PackedMesh::Vertex, p), sizeof(PackedMesh::Vertex),
                                   packed.vertices().size());
        rtcSetSharedGeometryBuffer(handle_, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, packed.faces().data(),
                                   offsetof(PackedMesh::Face, v), sizeof(PackedMesh::Face), packed.faces().size());
    } else if (of.shape->asCurves()) {
        curves = of.shape->asCurves();
        handle_ = makeCurveGeometry(device, *curves);
    } else {
        handle_ = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(handle_, 1);
        rtcSetGeometryBoundsFunction(handle_, shapeBounds, nullptr);
        rtcSetGeometryIntersectFunction(handle_, shapeIntersect);
        rtcSetGeometryOccludedFunction(handle_, shapeOccluded);
    }
    filtersHits_ = filtersHits(of);
    filtersShadows_ = filtersShadows(of);
    // The intersection functions of shapes make these tests themselves.
    if (mesh || curves) {
        if (filtersHits_) rtcSetGeometryIntersectFilterFunction(handle_, filterIntersect);
        if (filtersShadows_) rtcSetGeometryOccludedFilterFunction(handle_, filterOccluded);
    }
    rtcSetGeometryUserData(handle_, this);
    rtcCommitGeometry(handle_);
}

Geometry::~Geometry() { rtcReleaseGeometry(handle_); }

bool Geometry::isOf(const Primitive& other) const {
    return source() == sourceOf(other) && filtersHits_ == filtersHits(other) &&
           filtersShadows_ == filtersShadows(other);
}

const void* Geometry::source() const {
    return sourceMesh_ ? static_cast<const void*>(sourceMesh_.get()) : sourceShape_.get();
}

void Geometry::fillAt(const Ray& ray, float t, uint32_t primId, float u, float v, SurfaceInteraction& hit) const {
    drc::fillAt(*this, ray, t, primId, u, v, hit);
}

void fillFromShape(const ShapeHit& found, SurfaceInteraction& hit) { fill(found, hit); }

GeometryGroup::GeometryGroup(RTCDevice device, std::vector<std::unique_ptr<Geometry>> geometries)
    : scene_(rtcNewScene(device)), geometries_(std::move(geometries)) {
    // With this flag, no ray passes between triangles that share an edge.
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    for (size_t id = 0; id < geometries_.size(); ++id)
        rtcAttachGeometryByID(scene_, geometries_[id]->handle(), unsigned(id));
}

GeometryGroup::~GeometryGroup() { rtcReleaseScene(scene_); }

void GeometryGroup::commit() {
    const ParallelSection section;
    rtcCommitScene(scene_);
}

PrimitivesBySource::PrimitivesBySource(const std::vector<Primitive>& primitives) {
    for (auto primitive = primitives.rbegin(); primitive != primitives.rend(); ++primitive)
        bySource_[sourceOf(*primitive)].push_back(&*primitive);
}

const Primitive* PrimitivesBySource::take(const Geometry& geometry) {
    const auto found = bySource_.find(geometry.source());
    if (found == bySource_.end()) return nullptr;
    std::vector<const Primitive*>& left = found->second;
    const auto match = std::find_if(left.rbegin(), left.rend(), [&](const Primitive* p) { return geometry.isOf(*p); });
    if (match == left.rend()) return nullptr;
    const Primitive* primitive = *match;
    left.erase(std::next(match).base());
    return primitive;
}

void GeometryStore::add(std::vector<std::unique_ptr<Geometry>> geometries) {
    for (std::unique_ptr<Geometry>& geometry : geometries) {
        const void* source = geometry->source();
        bySource_.emplace(source, std::move(geometry));
    }
}

std::unique_ptr<Geometry> GeometryStore::take(const Primitive& primitive) {
    const auto [begin, end] = bySource_.equal_range(sourceOf(primitive));
    for (auto entry = begin; entry != end; ++entry) {
        if (!entry->second->isOf(primitive)) continue;
        std::unique_ptr<Geometry> geometry = std::move(entry->second);
        bySource_.erase(entry);
        geometry->primitive = &primitive;
        return geometry;
    }
    return std::make_unique<Geometry>(device_, primitive);
}

}  // namespace drc
