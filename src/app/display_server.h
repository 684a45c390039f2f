// `drc render --display-server`: a render is shown in tev, the image viewer.
#pragma once
#include <memory>

#include "app/render_options.h"
#include "render/session.h"
#include "view/tev_display.h"

namespace drc {

// Begins to show the session's picture so far, unfiltered, as an image that is called by the scene and the first
// output, so that several renders can be told apart. Session and settings must outlive what is returned. The session
// may take steps meanwhile; before anything else changes it comes TevDisplay::stopTaking.
std::unique_ptr<TevDisplay> showInTev(const RenderOptions& options, const Session& session,
                                      const RenderSettings& settings);

}  // namespace drc
