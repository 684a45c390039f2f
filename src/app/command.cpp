#include "app/command.h"

namespace drc {

ProcessInfo& processInfo() {
    static ProcessInfo info;
    return info;
}

}  // namespace drc
