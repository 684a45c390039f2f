// Fixtures of bathrooms and kitchens.
#pragma once
#include "generator_piece.h"

namespace drc::interior {

void bathtub(const Kit& k);
void washbasin(const Kit& k);  // with a mirror above
void toilet(const Kit& k);
void showerScreen(const Kit& k);
void counter(const Kit& k);  // a worktop with doors below and cupboards above
void hood(const Kit& k);
void rack(const Kit& k);  // rods, with bottles and the like on its shelves

}  // namespace drc::interior
