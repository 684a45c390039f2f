#include "image/frame_geometry.h"

#include <charconv>

#include "base/error.h"
#include "image/exr_matrix.h"

namespace drc {

ExrAttributes attributesOf(const FrameGeometry& geometry) {
    ExrAttributes attributes{{kWorldToCamera, matrixAttribute(geometry.worldToCamera)}};
    if (geometry.worldToNdc) attributes[kWorldToNdc] = matrixAttribute(*geometry.worldToNdc);
    if (geometry.objects.size() > 0) attributes[ObjectPlacements::kAttribute] = geometry.objects.attribute();
    return attributes;
}

std::optional<FrameGeometry> frameGeometryIn(const PictureFile& picture) {
    const ExrAttributes& attributes = picture.storage.attributes;
    const std::optional<Transform> toCamera = matrixIn(attributes, kWorldToCamera);
    if (!toCamera) return {};
    try {
        return FrameGeometry{*toCamera, matrixIn(attributes, kWorldToNdc), ObjectPlacements::in(attributes)};
    } catch (const Error& error) {
        throw Error(picture.path + ": " + error.what());
    }
}

int frameNumberIn(const ExrMetadata& metadata) {
    const auto found = metadata.find(kFrameNumber);
    int number = 0;
    if (found != metadata.end())
        std::from_chars(found->second.data(), found->second.data() + found->second.size(), number);
    return number;
}

}  // namespace drc
