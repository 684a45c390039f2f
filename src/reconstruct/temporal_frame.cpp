#include "reconstruct/temporal_frame.h"

#include "image/image_layers.h"

namespace drc {

TemporalFrame temporalFrameOf(const PictureFile& picture) {
    TemporalFrame frame;
    frame.surfaces = frameSurfacesOf(picture);
    for (size_t half = 0; half < 2; ++half) {
        frame.direct[half] = layerOverTime(picture, kHalfLayers[half]);
        if (!layerOf(picture.image, kDirectHalfLayers[half])) continue;
        frame.indirect[half] = std::move(frame.direct[half]);
        frame.direct[half] = layerOverTime(picture, kDirectHalfLayers[half]);
        for (size_t i = 0; i < frame.direct[half].data().size(); ++i)
            frame.indirect[half].data()[i] -= frame.direct[half].data()[i];
    }
    return frame;
}

}  // namespace drc
