#include "app/exit_code.h"

namespace drc {

int& exitCode() {
    static int code = 0;
    return code;
}

}  // namespace drc
