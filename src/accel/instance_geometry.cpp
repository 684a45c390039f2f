#include "accel/instance_geometry.h"

#include <Imath/ImathMatrixAlgo.h>
#include <Imath/ImathQuat.h>

namespace drc {
namespace {

void setMatrix(RTCGeometry instance, unsigned step, const Transform& t) {
    float m[12];
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) m[3 * column + row] = t.at(row, column);
    rtcSetGeometryTransform(instance, step, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, m);
}

// Decomposes the transform into translation, rotation and an upper triangular matrix, which Embree interpolates
// separately.
void setFactors(RTCGeometry instance, unsigned step, const Transform& t) {
    Imath::V3d c[3], q[3];
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) c[column][row] = t.at(row, column);
    // Gram-Schmidt orthonormalisation. q is made a rotation: if the transform mirrors, the last scale below is
    // negative.
    q[0] = c[0].normalized();
    q[1] = (c[1] - q[0] * q[0].dot(c[1])).normalized();
    q[2] = q[0].cross(q[1]);
    Imath::M44d rowVectors;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) rowVectors[i][j] = q[i][j];
    const Imath::Quatd rotation = Imath::extractQuat(rowVectors);

    RTCQuaternionDecomposition d;
    rtcInitQuaternionDecomposition(&d);
    rtcQuaternionDecompositionSetScale(&d, float(q[0].dot(c[0])), float(q[1].dot(c[1])), float(q[2].dot(c[2])));
    rtcQuaternionDecompositionSetSkew(&d, float(q[0].dot(c[1])), float(q[0].dot(c[2])), float(q[1].dot(c[2])));
    rtcQuaternionDecompositionSetQuaternion(&d, float(rotation.r), float(rotation.v.x), float(rotation.v.y),
                                            float(rotation.v.z));
    rtcQuaternionDecompositionSetTranslation(&d, t.at(0, 3), t.at(1, 3), t.at(2, 3));
    rtcSetGeometryTransformQuaternion(instance, step, &d);
}

}  // namespace

RTCGeometry makeInstanceGeometry(RTCDevice device, RTCScene object, const AnimatedTransform& objectToWorld) {
    RTCGeometry instance = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, object);
    const unsigned steps = objectToWorld.steps();
    if (steps == 1) {
        setMatrix(instance, 0, objectToWorld.start());
        return instance;
    }
    rtcSetGeometryTimeStepCount(instance, steps);
    // With many time steps, linear interpolation of matrices between them is accurate enough. With decomposed
    // transforms, Embree would search for the bounds of the rotation between every two steps, which takes ten
    // milliseconds per instance.
    const auto set = steps == AnimatedTransform::kMostSteps ? setMatrix : setFactors;
    for (unsigned i = 0; i < steps; ++i) set(instance, i, objectToWorld.at(float(i) / float(steps - 1)));
    return instance;
}

Transform instanceToWorld(RTCGeometry instance, float time) {
    float m[12];
    rtcGetGeometryTransform(instance, time, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, m);
    return Transform({m[0], m[3], m[6], m[9],   //
                      m[1], m[4], m[7], m[10],  //
                      m[2], m[5], m[8], m[11], 0, 0, 0, 1});
}

}  // namespace drc
