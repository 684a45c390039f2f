#include "film/preview.h"

#include "film/layered_picture.h"

namespace drc {

void Preview::balance(const RgbMatrix& matrix) { balanceBeauty(beauty, matrix); }

}  // namespace drc
