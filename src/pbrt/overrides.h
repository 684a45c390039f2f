// Parameters of the film, the sampler or the integrator given outside the scene file, such as by -D on the command
// line:
//
//     film.xresolution=640                 directive.name=value
//     pixelsamples=64                      the directive is not needed if only one of the three has this parameter
//     film.cropwindow=0,.5,0,1             several values, separated by commas or blanks
//
// They act as if the file contained them in place of its own values: with the type that the front end expects for the
// name, the same defaults for other parameters, and the same errors.
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/render_settings.h"

namespace drc::pbrt {

class Overrides {
  public:
    struct Directive {
        std::string_view name;  // "film"
        const std::string& type;
        ParamSet& params;
        decltype(&applyFilm) apply;
    };
    // Puts each override into the parameters of its directive; if two have the same name, the last one counts. Throws
    // Error for an override that is malformed, has an unknown name, or has a value of the wrong type. This object must
    // outlive the parameters, which refer to locations in it.
    Overrides(const std::vector<std::string>& texts, const std::vector<Directive>& directives);

  private:
    std::vector<std::unique_ptr<Source>> sources_;
};

}  // namespace drc::pbrt
