// A generated scene before it is written. Lengths are in metres, z is up and the floor is at z = 0; the writer chooses
// the units and the up axis of the file.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "math/vec.h"

namespace drc::interior {

// A local frame in the room: a rotation about z followed by a translation.
struct Placement {
    Vec3 origin{0, 0, 0};
    float cosYaw = 1;
    float sinYaw = 0;

    static Placement at(const Vec3& origin, float yaw) { return {origin, std::cos(yaw), std::sin(yaw)}; }
    Vec3 vector(const Vec3& v) const { return {cosYaw * v.x - sinYaw * v.y, sinYaw * v.x + cosYaw * v.y, v.z}; }
    Vec3 point(const Vec3& p) const { return origin + vector(p); }
    Vec3 toLocal(const Vec3& p) const {
        const Vec3 d = p - origin;
        return {cosYaw * d.x + sinYaw * d.y, -sinYaw * d.x + cosYaw * d.y, d.z};
    }
    Placement inner(const Placement& b) const {
        return {point(b.origin), cosYaw * b.cosYaw - sinYaw * b.sinYaw, sinYaw * b.cosYaw + cosYaw * b.sinYaw};
    }
};

struct OrientedBox {
    Placement frame;
    Vec3 lo, hi;

    bool contains(const Vec3& p, float margin = 0) const;
    // Distance along the ray to the surface; infinity if it misses, 0 if it starts inside.
    float hit(const Vec3& origin, const Vec3& direction) const;
    Vec3 worldLo() const;
    Vec3 worldHi() const;
};

struct Texture {
    std::string name;
    std::string type;        // "spectrum" or "float"
    std::string parameters;  // class and parameters in pbrt's syntax
    std::string file;        // image file; empty if there is none
    int width = 0;
    int height = 0;
    std::vector<uint8_t> rgb;
};

struct Material {
    std::string name;
    std::string parameters;
    std::string alpha;  // name of a float texture; empty if there is none
};

// A triangle mesh with one material. Smooth meshes have normals.
struct Mesh {
    int material = 0;
    bool smooth = false;
    std::vector<Vec3> p, n;
    std::vector<Vec2> uv;
    std::vector<int> indices;
};

struct Sphere {
    Vec3 center;
    float radius;
    int material;
};

// Any of pbrt's shapes, in metres, relative to the frame's origin.
struct Shape {
    Placement frame;
    int material;
    std::string parameters;  // class and parameters in pbrt's syntax
};

enum class EmitterShape { Quad, Sphere, Disk };

// Emits on the side of its geometric normal: u x v for quads, outward for spheres.
struct Emitter {
    EmitterShape shape = EmitterShape::Quad;
    Vec3 center{0, 0, 0};         // for all shapes
    Vec3 u{0, 0, 0}, v{0, 0, 0};  // half edges of a quad
    Vec3 normal{0, 0, 0};         // not used for spheres
    float radius = 0;
    int material = 0;
    int group = 0;  // emitters of a group have the same radiance
    Rgb radiance{0, 0, 0};

    float area() const;
};

// A sky image in lat-long layout, with the row of the zenith first; its mean above the horizon is 1.
struct SkyImage {
    int width = 0, height = 0;
    std::vector<Rgb> radiance;
};

// A horizontal area on which small objects can stand, in its own frame.
struct Surface {
    Placement frame;
    Vec2 lo, hi;
    float clearance;
};

struct Draft {
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Sphere> spheres;
    std::vector<Shape> shapes;
    std::vector<Emitter> emitters;
    std::vector<Surface> surfaces;
    std::vector<OrientedBox> solids;       // approximate volumes of opaque objects
    std::vector<OrientedBox> footprints;   // occupied areas of the floor
    std::vector<OrientedBox> freeVolumes;  // interior of the room and its niches, and the space behind doors
    // Radiance of the sky. Black if there is none.
    Rgb sky{0, 0, 0};
    SkyImage skyImage;  // variation of the sky; empty if it is uniform
    Rgb sun{0, 0, 0};
    Vec3 sunFrom{0, 0, 1};
    struct Point {
        Vec3 at;
        Rgb intensity;
    };
    std::vector<Point> points;
    Vec3 eye{0, 0, 0}, look{0, 1, 0};
    float fov = 60;
    std::string summary;

    Mesh& meshFor(int material, bool smooth);
    size_t triangleCount() const;
    bool inFreeSpace(const Vec3& p) const;
    // Total radiant flux of all emitters, averaged over RGB. The sky is counted by its radiance.
    float flux() const;

  private:
    std::map<std::pair<int, bool>, size_t> meshIndex_;
};

}  // namespace drc::interior
