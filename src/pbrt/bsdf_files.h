// The BSDF files of a scene's materials. Each file is read once and shared by all materials that name it.
#pragma once
#include <map>
#include <memory>
#include <string>

#include "pbrt/source.h"
#include "scene/lobes/fourier_table.h"
#include "scene/lobes/measured_table.h"

namespace drc::pbrt {

class BsdfFiles {
  public:
    // Both functions throw Error, located at pos or in the file, if the file cannot be read.
    std::shared_ptr<const FourierTable> fourier(const std::string& path, const SourcePos& pos);
    std::shared_ptr<const MeasuredTable> measured(const std::string& path, const SourcePos& pos);

  private:
    std::map<std::string, std::shared_ptr<const FourierTable>> fourier_;
    std::map<std::string, std::shared_ptr<const MeasuredTable>> measured_;
};

}  // namespace drc::pbrt
