// Embree's geometries and the bounding volume hierarchies over groups of them. Both outlive a scene: the scene of the
// next frame takes over what was made of the same meshes and shapes.
#pragma once
#include <embree3/rtcore.h>

#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "accel/interaction.h"
#include "accel/packed_mesh.h"
#include "base/memory_use.h"
#include "scene/scene.h"

namespace drc {

// One of Embree's geometries, and the data that its callbacks need.
class Geometry {
  public:
    // The primitive must stay where it is until another is assigned to `primitive`.
    Geometry(RTCDevice device, const Primitive& of);
    ~Geometry();
    Geometry(const Geometry&) = delete;
    Geometry& operator=(const Geometry&) = delete;

    // Whether a geometry made of this primitive would be the same: mesh or shape, and the filters that Embree calls.
    bool isOf(const Primitive& other) const;
    // The mesh or shape that it was made of, which lives as long as the geometry, so that the address stays its own.
    const void* source() const;
    RTCGeometry handle() const { return handle_; }

    // Fills in the interaction at a hit on a mesh or curves, at distance t along the ray.
    void fillAt(const Ray& ray, float t, uint32_t primId, float u, float v, SurfaceInteraction& hit) const;

    const Primitive* primitive;
    uint32_t index = 0;              // among all of the scene's geometries
    const Bsdf* lobes = nullptr;     // see SurfaceInteraction::lobes
    std::optional<PackedMesh> mesh;  // set for meshes only
    const Curves* curves = nullptr;  // set for curves only; null and no mesh: another shape

  private:
    TriangleMeshPtr sourceMesh_;
    ShapePtr sourceShape_;
    bool filtersHits_ = false, filtersShadows_ = false;
    NotedMemory memory_;  // of the packed mesh
    RTCGeometry handle_ = nullptr;
};

// Fills in the interaction at a hit on a shape that is neither a mesh nor curves.
void fillFromShape(const ShapeHit& found, SurfaceInteraction& hit);

// Geometries with a bounding volume hierarchy of their own.
class GeometryGroup {
  public:
    GeometryGroup(RTCDevice device, std::vector<std::unique_ptr<Geometry>> geometries);
    ~GeometryGroup();
    GeometryGroup(const GeometryGroup&) = delete;
    GeometryGroup& operator=(const GeometryGroup&) = delete;

    // Builds the hierarchy, on all cores.
    void commit();
    RTCScene scene() const { return scene_; }
    // By Embree's geometry ID.
    const std::vector<std::unique_ptr<Geometry>>& geometries() const { return geometries_; }
    // The geometries, for another group; this one is of no use afterwards.
    std::vector<std::unique_ptr<Geometry>> release() { return std::move(geometries_); }

  private:
    RTCScene scene_;
    std::vector<std::unique_ptr<Geometry>> geometries_;
};

// The primitives of a scene, looked up by the geometries that could have been made of them.
class PrimitivesBySource {
  public:
    explicit PrimitivesBySource(const std::vector<Primitive>& primitives);
    // The first primitive of which the geometry could have been made and that was not taken yet, or null.
    const Primitive* take(const Geometry& geometry);

  private:
    std::unordered_map<const void*, std::vector<const Primitive*>> bySource_;  // each list in reverse order
};

// Geometries of an earlier scene, for a new one.
class GeometryStore {
  public:
    explicit GeometryStore(RTCDevice device) : device_(device) {}
    void add(std::vector<std::unique_ptr<Geometry>> geometries);
    // A geometry of the primitive: one of the store's, or else a new one.
    std::unique_ptr<Geometry> take(const Primitive& primitive);

  private:
    RTCDevice device_;
    std::unordered_multimap<const void*, std::unique_ptr<Geometry>> bySource_;
};

}  // namespace drc
