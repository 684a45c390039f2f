// Numbers the objects and the materials of a scene file: Primitive::objectNumber, Instance::objectNumber and
// Primitive::materialNumber.
#pragma once
#include <map>
#include <memory>

#include "image/object_placements.h"
#include "pbrt/material_factory.h"

namespace drc::pbrt {

class ObjectNumbers {
  public:
    // The number of the next object in the file; 0 if there are no numbers left. Every directive for an object has to
    // ask for one, even if the object is left out, so that it never changes those of the objects after it.
    uint32_t next() { return last_ == ObjectPlacements::kMostObjects ? 0 : ++last_; }
    // The number of a material, by the order of first calls, from 1.
    uint32_t ofMaterial(const std::shared_ptr<const MaterialInstance>& material) {
        return materials_.try_emplace(material, uint32_t(materials_.size() + 1)).first->second;
    }

  private:
    uint32_t last_ = 0;
    // The materials are kept, because the address of one that is gone might become that of another.
    std::map<std::shared_ptr<const MaterialInstance>, uint32_t> materials_;
};

}  // namespace drc::pbrt
