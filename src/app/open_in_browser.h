// Opens an address in the desktop's browser.
#pragma once
#include <string>

namespace drc {

// Lets xdg-open open a page of this user's alone that leads to the address: what stands on a command line can be read
// by all users of the machine, and the address has a token. Returns at once; the page is removed after a minute. Throws
// Error if there is no xdg-open, or the page cannot be written. address: of letters, digits and -._~:/[] alone.
void openInBrowser(const std::string& address);

}  // namespace drc
