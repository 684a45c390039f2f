#include "accel/curve_geometry.h"

namespace drc {

RTCGeometry makeCurveGeometry(RTCDevice device, const Curves& curves) {
    const bool ribbon = curves.type() == CurveType::Ribbon;
    RTCGeometry geometry = rtcNewGeometry(
        device, ribbon ? RTC_GEOMETRY_TYPE_NORMAL_ORIENTED_BEZIER_CURVE : RTC_GEOMETRY_TYPE_FLAT_BEZIER_CURVE);
    static_assert(sizeof(Curves::ControlPoint) == 16 && sizeof(Curves::ControlNormal) == 16);
    const size_t points = curves.controlPoints().size();
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, curves.controlPoints().data(), 0,
                               sizeof(Curves::ControlPoint), points);
    if (ribbon)
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_NORMAL, 0, RTC_FORMAT_FLOAT3,
                                   curves.controlNormals().data(), 0, sizeof(Curves::ControlNormal), points);
    auto* first = static_cast<uint32_t*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT,
                                                                 sizeof(uint32_t), curves.pieceCount()));
    for (uint32_t i = 0; i < curves.pieceCount(); ++i) first[i] = 4 * i;
    rtcSetGeometryTessellationRate(geometry, float(Curves::kLines));
    return geometry;
}

}  // namespace drc
