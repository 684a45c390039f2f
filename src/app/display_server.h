// `drc render --display-server`: shows a render in tev, the image viewer.
#pragma once
#include <memory>

#include "app/render_options.h"
#include "render/session.h"
#include "view/tev_display.h"

namespace drc {

// Begins to show the session's picture so far, unfiltered, as an image named by the scene and the first output, so that
// several renders can be told apart. Session and settings must outlive the returned object. The session may take steps
// meanwhile; TevDisplay::stopTaking must be called before it changes in any other way.
std::unique_ptr<TevDisplay> showInTev(const RenderOptions& options, const Session& session,
                                      const RenderSettings& settings);

}  // namespace drc
