#include "app/map_denoiser_choice.h"

#include "app/models.h"
#include "maps/network_map_denoiser.h"

namespace drc {

std::string chooseMapDenoiser(const RenderOptions& o, IndirectSettings& indirect) {
    const auto setProjection = [&](const std::string& ownOfNetwork) {
        const std::string& name = o.projection != "auto" ? o.projection
                                  : ownOfNetwork.empty() ? projectionName(Projection::EqualArea)
                                                         : ownOfNetwork;
        indirect.capture.layout = MapLayout(projectionFromName(name), indirect.capture.layout.size());
    };
    setProjection("");
    if (o.mapDenoiser == "gaussian") {
        indirect.denoiser = makeGaussianMapDenoiser(1);
    } else if (o.mapDenoiser == "network") {
        const auto weights = UNetWeights::load(findWeights(o.weights));
        setProjection(weights->projection());
        std::optional<Precision> precision;
        if (o.precision != "auto") precision = o.precision == "fp32" ? Precision::Fp32 : Precision::Bf16;
        indirect.denoiser = makeNetworkMapDenoiser(weights, indirect.capture.layout, precision);
        return weights->hash();
    } else if (o.mapDenoiser == "oracle") {
        indirect.capture.samplesPerTexel = o.oracleSamples;
    }
    return "";  // none and oracle: maps as they are captured
}

}  // namespace drc
