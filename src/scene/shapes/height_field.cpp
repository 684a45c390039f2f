#include "scene/shapes/height_field.h"

namespace drc {

TriangleMesh makeHeightField(uint32_t nx, uint32_t ny, std::span<const float> heights) {
    TriangleMesh mesh;
    mesh.positions.reserve(heights.size());
    mesh.uvs.reserve(heights.size());
    for (uint32_t y = 0; y < ny; ++y)
        for (uint32_t x = 0; x < nx; ++x) {
            const Vec2 uv(float(x) / float(nx - 1), float(y) / float(ny - 1));
            mesh.positions.push_back(Vec3(uv.x, uv.y, heights[size_t(y) * nx + x]));
            mesh.uvs.push_back(uv);
        }
    mesh.indices.reserve(6 * size_t(nx - 1) * (ny - 1));
    for (uint32_t y = 0; y + 1 < ny; ++y)
        for (uint32_t x = 0; x + 1 < nx; ++x) {
            const uint32_t corner = y * nx + x, above = corner + nx;
            // Split the cell along the same diagonal as pbrt.
            mesh.indices.insert(mesh.indices.end(), {corner, corner + 1, above + 1, corner, above + 1, above});
        }
    return mesh;
}

}  // namespace drc
