// `drc view`: renders a scene and shows it in a browser while it refines.
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "app/command.h"
#include "app/display_options.h"
#include "app/open_in_browser.h"
#include "app/option_checks.h"
#include "app/option_choice.h"
#include "app/scene_overrides.h"
#include "app/usage_error.h"
#include "base/error.h"
#include "base/limits.h"
#include "base/log.h"
#include "integrators/integrator.h"
#include "render/picture_filters.h"
#include "render/picture_writer.h"
#include "view/http_server.h"
#include "view/live_render.h"
#include "view/view_service.h"

extern char** environ;

namespace drc {
namespace {

// Default number of samples per pixel, so large that a view goes on until the user ends it.
constexpr int kSamples = 1 << 16;
// The page's slider of the exposure goes from -kMostStops to kMostStops.
constexpr int kMostStops = 10;

struct ViewOptions {
    std::string scene, address = "127.0.0.1", token, oidnLibrary;
    SceneOverrides overrides;
    DisplaySettings display;  // initial settings of the page
    RenderParams params;
    int port = 0, threads = 0;
    bool open = false, verbose = false;
};

// Saved pictures contain the command line, and must not give access to the view.
std::string commandLineWithout(const std::string& token) {
    std::string line = processInfo().commandLine;
    if (const size_t at = line.find(token); !token.empty() && at != std::string::npos)
        line.replace(at, token.size(), "...");
    return line;
}

std::string encodeFrame(RenderSettings settings, const LiveFrame& frame, const RenderParams& params,
                        const std::string& token) {
    const PixelRegion& region = frame.picture.film->region();
    settings.film.width = std::max(region.x1, settings.film.width);
    settings.film.height = std::max(region.y1, settings.film.height);
    const PictureWriter writer(settings, {"drc.exr"}, true);
    return writer.encode(frame.picture, {{"drc:version", DRC_VERSION},
                                         {"drc:command", commandLineWithout(token)},
                                         {"drc:seed", std::to_string(params.seed)},
                                         {"drc:integrator", params.integrator},
                                         {"drc:spp", std::to_string(frame.samples)}})[0];
}

// "[::1]:80" for IPv6 addresses.
std::string hostAndPort(const std::string& address, int port) {
    const bool isV6 = address.find(':') != std::string::npos;
    return fmt::format("{}{}{}:{}", isV6 ? "[" : "", address, isV6 ? "]" : "", port);
}

bool isLoopback(const std::string& address) { return address == "127.0.0.1" || address == "::1"; }
// Whether a server on this address listens on all addresses of the machine.
bool isAny(const std::string& address) { return address == "0.0.0.0" || address == "::"; }

void view(ViewOptions o) {
    setLogLevel(o.verbose ? LogLevel::Verbose : LogLevel::Normal);
    setThreadCount(o.threads);
    if (std::abs(o.display.exposure) > kMostStops)
        throw UsageError(
            fmt::format("--exposure {0:g}: the page's goes from -{1} to {1}", o.display.exposure, kMostStops));
    pbrt::LoadOptions load = o.overrides.loadOptions();
    load.names = true;
    const auto scene = o.overrides.load(o.scene, load);
    o.overrides.cropFilm(scene->sensor.settings);
    o.params.gBuffer = o.params.parts = o.params.variance = o.params.independentHalves = true;
    if (!o.params.spp) o.params.spp = kSamples;
    RenderParams params = asUsage([&] { return resolved(o.params, scene->sensor.settings); });
    if (traitsOf(params.integrator).maps) throw UsageError("drc view: --integrator drc-maps cannot be watched yet");
    const ChosenDenoiser denoiser =
        chooseDenoiser(o.params.denoise, params, [&] { return findOidn(OidnSearch::ofProcess(o.oidnLibrary)); });
    params.denoise = denoiser.denoise;

    Stats stats;
    CancelToken outdated;
    const LiveFilters filters(denoiser, outdated);
    const RenderSettings settings = scene->sensor.settings;
    Session session(*scene, params, &stats);
    // Frames are announced only once there is a server.
    std::atomic<HttpServer*> listener = nullptr;
    std::atomic<ViewService*> source = nullptr;
    const auto announce = [&] {
        HttpServer* to = listener;
        if (to != nullptr) to->send("frame", source.load()->frameEvent());
    };
    LiveRender render(session, {.finish = [&](LayeredPicture& picture, bool moving) { filters.apply(picture, moving); },
                                .onFrame = announce,
                                .estimate = traitsOf(params.integrator).halves
                                                ? [&](const LayeredPicture& p) { return filters.errorOf(p); }
                                                : std::function<DenoisedError(const LayeredPicture&)>(),
                                .outdated = &outdated});
    ViewService service(
        *scene, session.accel(), render,
        {.title = sceneTitle(o.scene),
         .token = o.token.empty() ? randomToken() : o.token,
         .encodeExr = [&](const LiveFrame& frame) { return encodeFrame(settings, frame, params, o.token); },
         .display = o.display});
    HttpSettings http;
    http.address = o.address;
    http.port = uint16_t(o.port);
    http.admit = [&](const HttpRequest& header) { return service.admit(header); };
    HttpServer server(http, [&](const HttpRequest& request) { return service.answer(request); });
    source = &service;
    listener = &server;
    const std::string own = isAny(o.address) ? (o.address == "::" ? "::1" : "127.0.0.1") : o.address;
    const std::string address = fmt::format("http://{}/{}/", hostAndPort(own, server.port()), service.token());
    if (!isLoopback(o.address))
        logWarning("--listen " + o.address +
                   ": everybody who can reach this machine and knows the whole line below can watch and steer" +
                   (isAny(o.address) ? "; other machines put its address in place of " + own : ""));
    fmt::print("{}\n", address);
    std::fflush(stdout);
    try {
        if (o.open) openInBrowser(address);
    } catch (const Error& error) {
        logWarning(fmt::format("--open: {}; open the address by hand", error.what()));
    }
    // There is nothing to save: Ctrl-C ends the program.
    for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
}

}  // namespace

void addViewCommand(CLI::App& app) {
    auto* command = app.add_subcommand("view", "Render a scene and watch it in a browser");
    auto o = std::make_shared<ViewOptions>();
    command->add_option("SCENE", o->scene, "pbrt-v3 or pbrt-v4 scene file")->required();
    addSceneOverrides(*command, o->overrides);
    std::vector<std::string> integrators{"scene"};
    std::ranges::remove_copy_if(integratorNames(), std::back_inserter(integrators),
                                [](const std::string& name) { return traitsOf(name).maps; });
    command
        ->add_option("--integrator", o->params.integrator,
                     fmt::format("What renders the picture: {}; scene takes what the scene file asks for",
                                 fmt::join(integrators, ", ")))
        ->capture_default_str()
        ->check(CLI::IsMember(integrators));
    command->add_option("--spp", o->params.spp, "Camera samples a pixel at which the render rests")
        ->check(wholeNumberIn(1, limits::kSamplesPerPixel));
    command->add_option("--max-depth", o->params.maxDepth, "Maximum length of paths, in non-specular bounces")
        ->check(wholeNumberFrom(1));
    addSeedOption(*command, o->params.seed, "Seed of all random numbers");
    addChoice<Denoise>(*command, "--denoise", o->params.denoise,
                       {{"auto", Denoise::Automatic}, {"off", Denoise::Off}, {"oidn", Denoise::Oidn}},
                       "auto: Intel's Open Image Denoise if it is found; oidn: the same, and an error if it is not; "
                       "off: nothing. Default: auto");
    addDisplayOptions(*command, o->display);
    command->add_option("--port", o->port, "Port; by default any that is free")->check(wholeNumberIn(0, 65535));
    command
        ->add_option("--listen", o->address,
                     "Address to listen on; others than 127.0.0.1 let other machines watch and steer")
        ->capture_default_str();
    command
        ->add_option("--token", o->token,
                     "The part of the address that others do not know: 16 to 128 letters, digits, - and _. With --port "
                     "the address stays the same. By default another one each time")
        ->envname("DRC_VIEW_TOKEN")
        ->check(CLI::Validator(
            [](const std::string& text) {
                return isToken(text) ? std::string() : "must be 16 to 128 letters, digits, - and _";
            },
            "", "token"));
    command->add_flag("--open", o->open, "Open the page in the browser");
    addThreadsOption(*command, o->threads);
    command->add_option("--oidn-library", o->oidnLibrary, "Open Image Denoise's library");
    command->add_flag("-v,--verbose", o->verbose, "Say more");
    command->callback([o] { view(*o); });
}

}  // namespace drc
