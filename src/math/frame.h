// A right-handed orthonormal basis (s, t, n), and the change of coordinates to and from it.
#pragma once
#include "math/vec.h"

namespace drc {

struct Frame {
    Vec3 s{1, 0, 0}, t{0, 1, 0}, n{0, 0, 1};

    Frame() = default;
    Frame(const Vec3& s_, const Vec3& t_, const Vec3& n_) : s(s_), t(t_), n(n_) {}
    // An arbitrary basis around the unit vector n. It is continuous in n except at n.z = 0 (Duff et al., "Building an
    // Orthonormal Basis, Revisited", JCGT 2017).
    static Frame fromNormal(const Vec3& n) {
        const float sign = std::copysign(1.f, n.z);
        const float a = -1 / (sign + n.z);
        const float b = n.x * n.y * a;
        return Frame(Vec3(1 + sign * n.x * n.x * a, sign * b, -sign * n.x), Vec3(b, sign + n.y * n.y * a, -n.y), n);
    }
    // The basis around n whose s is as close as possible to the tangent dpdu; an arbitrary one if dpdu is parallel to
    // n.
    static Frame fromNormalAndTangent(const Vec3& n, const Vec3& dpdu) {
        const Vec3 s = dpdu - n * dot(n, dpdu);
        const float l2 = lengthSquared(s);
        if (!(l2 > 1e-12f * lengthSquared(dpdu))) return fromNormal(n);
        const Vec3 su = s * (1 / std::sqrt(l2));
        return Frame(su, cross(n, su), n);
    }
    Vec3 toLocal(const Vec3& v) const { return Vec3(dot(v, s), dot(v, t), dot(v, n)); }
    Vec3 toWorld(const Vec3& v) const { return s * v.x + t * v.y + n * v.z; }
};

}  // namespace drc
