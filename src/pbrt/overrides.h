// Parameters of the film, the sampler or the integrator that are given outside the scene file, as by -D on the command
// line:
//
//     film.xresolution=640                 directive.name=value
//     pixelsamples=64                      of the only one of the three directives that has this parameter
//     film.cropwindow=0,.5,0,1             several values, separated by commas or blanks
//
// They act as if they stood in the file in place of its own values: with the type under which the front end looks the
// name up, the same defaults for other parameters, and the same errors.
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
    // Puts each override into the parameters of its directive; of two with one name the last counts. Throws Error for
    // an override of another form, with an unknown name, or with a value of another type. Must live as long as the
    // parameters are in use, because they refer to locations in it.
    Overrides(const std::vector<std::string>& texts, const std::vector<Directive>& directives);

  private:
    std::vector<std::unique_ptr<Source>> sources_;
};

}  // namespace drc::pbrt
