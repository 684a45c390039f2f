#include "render/preview.h"

#include "render/layered_picture.h"

namespace drc {

void Preview::balance(const RgbMatrix& matrix) { balanceBeauty(beauty, matrix); }

}  // namespace drc
