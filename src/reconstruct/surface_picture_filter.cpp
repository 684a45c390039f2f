#include "reconstruct/surface_picture_filter.h"

#include "film/sample_pass.h"
#include "reconstruct/layer_filter.h"

namespace drc {

void SurfacePictureFilter::apply(LayeredPicture& picture) const {
    const Film& film = *picture.film;
    const LobeGBuffer surfaces(film);
    const auto set = [&](const char* name, Image mean) {
        for (float& v : mean.data()) v *= picture.scale;
        picture.layer(name).mean = std::move(mean);
    };
    if (smooth_) set("lit", LayerFilter(surfaces, LobeKind::All).smooth(film.layer("lit")));
    const bool correct = correct_ && film.mapPasses() > 0;
    if (smooth_ || correct) {
        const LayerFilter broad(surfaces, LobeKind::Broad);
        const FilmLayer& maps = film.layer("maps");
        Image indirect = smooth_ ? broad.smooth(maps) : maps.image();
        if (!smooth_) fillUnsampled({&indirect}, maps);
        if (correct) broad.correct(indirect, film.layer("broad"));
        set("maps", std::move(indirect));
    }
    if (smooth_) set("glossy", LayerFilter(surfaces, LobeKind::Glossy).smooth(film.layer("glossy")));
    picture.compose();
}

}  // namespace drc
