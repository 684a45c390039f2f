#include "app/display_server.h"

#include <fmt/core.h>

#include "app/command.h"

namespace drc {

std::unique_ptr<TevDisplay> showInTev(const RenderOptions& options, const Session& session,
                                      const RenderSettings& settings) {
    TevSettings shown;
    shown.server = parseStreamAddress(options.displayServer);
    shown.name = fmt::format("{} ({})", sceneTitle(options.scene), sceneTitle(options.outputs.front()));
    // A snapshot of one pixel shows which layers there are.
    const PixelRegion region = session.film().region();
    tev::Picture outline =
        tev::pictureOf(session.snapshot({region.x0, region.y0, region.x0 + 1, region.y0 + 1}), settings.film);
    outline.region = region;
    return std::make_unique<TevDisplay>(
        std::move(shown), std::move(outline), [&session, &settings](TevDisplay::Extent extent) {
            if (extent == TevDisplay::Extent::Beauty) {
                Preview preview = session.preview();
                if (settings.whiteBalance) preview.balance(*settings.whiteBalance);
                return tev::pictureOf(std::move(preview), session.film().region(), settings.film);
            }
            LayeredPicture picture = session.snapshot();
            if (settings.whiteBalance) picture.balance(*settings.whiteBalance);
            return tev::pictureOf(std::move(picture), settings.film);
        });
}

}  // namespace drc
