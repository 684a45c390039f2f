// A scene while it is being made. Lengths are metres, z is up and the floor is z = 0; units and the up axis of the file
// are the writer's business.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "math/vec.h"

namespace drc::interior {

// A turn about z and then a shift: where a local frame stands in the room.
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
    // Distance along the ray to the surface, or infinity; 0 from inside.
    float hit(const Vec3& origin, const Vec3& direction) const;
    Vec3 worldLo() const;
    Vec3 worldHi() const;
};

struct Texture {
    std::string name;
    std::string type;        // "spectrum" or "float"
    std::string parameters;  // class and parameters, as pbrt reads them
    std::string file;        // empty: no image
    int width = 0;
    int height = 0;
    std::vector<uint8_t> rgb;
};

struct Material {
    std::string name;
    std::string parameters;
    std::string alpha;  // name of a float texture, or empty
};

// Vertices that share a material. smooth meshes carry normals.
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

// Any of pbrt's shapes, in metres about the frame's origin.
struct Shape {
    Placement frame;
    int material;
    std::string parameters;  // class and parameters, as pbrt reads them
};

enum class EmitterShape { Quad, Sphere, Disk };

// Emits from its geometric normal's side: u x v for quads (corner, corner + u, ...), outward for spheres.
struct Emitter {
    EmitterShape shape = EmitterShape::Quad;
    Vec3 center{0, 0, 0};         // of all shapes
    Vec3 u{0, 0, 0}, v{0, 0, 0};  // half edges of a quad
    Vec3 normal{0, 0, 0};         // not for spheres
    float radius = 0;
    int material = 0;
    int group = 0;  // emitters of a group share their radiance
    Rgb radiance{0, 0, 0};

    float area() const;
};

// Radiance over the directions, latitude by longitude, the zenith's row first; 1 on average above the horizon.
struct SkyImage {
    int width = 0, height = 0;
    std::vector<Rgb> radiance;
};

// A level place on which small things can stand, in its own frame.
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
    std::vector<OrientedBox> solids;       // what is opaque and full, to first order
    std::vector<OrientedBox> footprints;   // floor that is taken
    std::vector<OrientedBox> freeVolumes;  // the room, niches and what lies behind doors
    // Lights without a shape. Black: none.
    Rgb sky{0, 0, 0};
    SkyImage skyImage;  // what varies over the sky; empty: nothing
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
    // Radiant flux of all that shines, summed over RGB / 3; the sky counts as its radiance.
    float flux() const;

  private:
    std::map<std::pair<int, bool>, size_t> meshIndex_;
};

}  // namespace drc::interior
