// Parameters of a film, a sampler or an integrator that are given beside the file, as -D does on the command line:
//
//     film.xresolution=640                 directive.name=value
//     pixelsamples=64                      of the one directive of the three that knows the name
//     film.cropwindow=0,.5,0,1             values in a row, with commas or blanks between them
//
// They count as if they stood in the file, in place of what it says: with the type under which the front end looks the
// name up, the same defaults beside them, and the same errors.
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
    // Puts each into the parameters of its directive; of two with one name the last counts. Throws Error for one that
    // is not of that form, that nobody knows, or whose value is of another type. Must live for as long as the
    // parameters are in use: they refer to places in it.
    Overrides(const std::vector<std::string>& texts, const std::vector<Directive>& directives);

  private:
    std::vector<std::unique_ptr<Source>> sources_;
};

}  // namespace drc::pbrt
